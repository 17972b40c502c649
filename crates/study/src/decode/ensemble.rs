//! The key `ensemble` of a study.

use crate::Filter;
use crate::cases::scope::{Scope, names};
use crate::source::faults::Faults;
use crate::source::object::Object;
use crate::source::tree::{Node, Tree};

/// Most combinations of a study with an ensemble: its metrics are in memory together.
const MOST: u64 = 10_000_000;

/// Decodes the key; `None` without it, empty if it has a fault.
pub(super) fn ensemble(object: &Object, scope: &Scope, faults: &mut Faults) -> Option<Vec<usize>> {
    let node = object.get("ensemble")?;
    let (path, before) = (object.path("ensemble"), faults.count());
    let rows = names(node, &path, "parameter", &scope.parameters(), faults);
    let rows = rows.unwrap_or_default();
    let blocks = scope.blocks.iter();
    let count = blocks.fold(0, |sum: u64, block| sum.saturating_add(block.raw_len()));
    if count > MOST {
        let message = format!("{count} combinations; a study with an ensemble has at most {MOST}");
        faults.add(node.at, &path, message);
    } else if !scope.blocks.is_empty() {
        for (i, row) in rows.iter().enumerate() {
            if let Some(message) = unsuitable(scope, *row) {
                let (at, path) = item(node, &path, i);
                faults.add(at, &path, message);
            }
        }
    }
    Some(if faults.count() > before {
        Vec::new()
    } else {
        rows
    })
}

/// Why the cases are no ensemble over a parameter; `None` if they are.
fn unsuitable(scope: &Scope, row: usize) -> Option<String> {
    let name = &scope.problem.parameters()[row].name;
    let mut derived = scope.blocks.iter().flat_map(|block| &block.derived);
    if derived.any(|derived| derived.parameter == row) {
        return Some(format!(
            "{name} is given by an expression; name the parameters that it follows from"
        ));
    }
    let levels = scope.levels(&Filter::default(), row);
    match levels.as_slice() {
        [] => Some(format!("{name} is given in none of the cases")),
        [one] => Some(format!(
            "{name} is {one} in all cases; an ensemble needs a parameter with several values"
        )),
        _ => None,
    }
}

/// The offset and path of name `i`, which may be given without a list.
fn item(node: &Node, path: &str, i: usize) -> (usize, String) {
    match &node.tree {
        Tree::List(items) if i < items.len() => (items[i].at, format!("{path}[{i}]")),
        _ => (node.at, path.to_owned()),
    }
}
