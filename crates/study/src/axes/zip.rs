//! The key `zip`: parameters that advance together.

use super::draft::BlockDraft;
use crate::source::faults::{Faults, quoted, unknown};
use crate::source::tree::Node;
use crate::value::text;
use slipgap_problem::problem::numbers::parameter::Parameter;

/// Decodes the groups of a `zip` into the draft, without the faulty ones.
pub(crate) fn zip(
    node: &Node,
    path: &str,
    table: &[Parameter],
    draft: &mut BlockDraft,
    faults: &mut Faults,
) {
    const WHAT: &str = "a list of lists of parameters, as in [[\"alpha\", \"dT\"]]";
    let Some(groups) = node.list() else {
        return faults.must_be(node, path, WHAT);
    };
    for (i, group) in groups.iter().enumerate() {
        let path = format!("{path}[{i}]");
        let Some(items) = group.list() else {
            faults.must_be(group, &path, WHAT);
            continue;
        };
        let mut rows = Vec::new();
        for (j, item) in items.iter().enumerate() {
            let path = format!("{path}[{j}]");
            rows.extend(member(item, &path, table, draft, &rows, faults));
        }
        if rows.len() < items.len() {
            continue;
        }
        if rows.len() < 2 {
            faults.add(group.at, &path, "needs at least two parameters");
            continue;
        }
        let lens: Vec<(&str, usize)> = rows
            .iter()
            .map(|row| (&*table[*row].name, draft.count(*row)))
            .collect();
        if lens.iter().any(|(_, len)| *len != lens[0].1) {
            let counts = Vec::from_iter(lens.iter().map(|(name, len)| format!("{name} has {len}")));
            let message = format!(
                "needs the same number of values of each; {}",
                counts.join(", ")
            );
            faults.add(group.at, &path, message);
            continue;
        }
        draft.zips.push(rows);
    }
}

/// The row of a parameter, which must have a list or rule and be in no other group.
fn member(
    node: &Node,
    path: &str,
    table: &[Parameter],
    draft: &BlockDraft,
    rows: &[usize],
    faults: &mut Faults,
) -> Option<usize> {
    let name = text(node, path, faults)?;
    let mut refuse = |message: String| {
        faults.add(node.at, path, message);
        None
    };
    let Some(row) = table.iter().position(|p| p.name == name) else {
        let given = draft.parameters.iter();
        let names: Vec<&str> = given.map(|g| &*table[g.parameter].name).collect();
        return refuse(unknown("parameter", &name, &names));
    };
    if draft.faulty.contains(&row) {
        // Reported already.
        return None;
    }
    let quoted = quoted(&name);
    match draft.get(row) {
        None => refuse(format!("{quoted} is not given in this block")),
        Some(given) if given.interval.is_some() => {
            refuse(format!("{quoted} belongs to the design"))
        }
        Some(given) if !given.axis => refuse(format!("{quoted} has one value, not a list")),
        Some(_) if rows.contains(&row) || draft.zips.iter().any(|zip| zip.contains(&row)) => {
            refuse(format!("{quoted} is in a group already"))
        }
        Some(_) => Some(row),
    }
}
