//! Which parameters apply in a block. Names given in the block decide it.

use super::draft::BlockDraft;
use crate::source::faults::{Faults, join};
use slipgap_problem::problem::numbers::parameter::{Default, Kind, Parameter, Value};

/// Reports a parameter that is given and does not apply, and one that applies, has no default and is not given.
pub(super) fn check_applicability(
    draft: &BlockDraft,
    row: usize,
    parameter: &Parameter,
    table: &[Parameter],
    faults: &mut Faults,
) {
    let given = draft.get(row);
    let required = matches!(parameter.default, Default::Required);
    let missing = format!("missing: {}", described(parameter));
    let missing_path = join(&draft.path, &parameter.name);
    let Some(on) = &parameter.applies else {
        if given.is_none() && required {
            faults.add(draft.at, &missing_path, missing);
        }
        return;
    };
    // A governor without a name is faulty or missing itself.
    let Some(chosen) = names(draft, on.governor, table) else {
        return;
    };
    let others: Vec<&str> = chosen.iter().copied().filter(|c| !on.allows(c)).collect();
    let (governor, wanted) = (on.governor, on.choices());
    let applies = others.len() < chosen.len();
    let separate = || {
        format!(
            "applies only to {governor} {wanted}, but {governor} is also {} here; give each {governor} its own block \
             in \"blocks\"",
            others.join(", ")
        )
    };
    match given {
        Some(given) if !applies => {
            let applicable = table.iter().filter(|p| match &p.applies {
                Some(other) => {
                    other.governor == governor && chosen.iter().any(|value| other.allows(value))
                }
                None => true,
            });
            let allowed: Vec<&str> = applicable.map(|p| &*p.name).collect();
            let message = format!(
                "does not apply to {governor} {}, only to {wanted}; allowed: {}",
                chosen.join(", "),
                allowed.join(", ")
            );
            faults.add(given.at, &given.path, message);
        }
        // One value of a parameter that may be left out: the other cases do without.
        Some(given)
            if !on.collapses && !others.is_empty() && (required || given.values.len() > 1) =>
        {
            faults.add(given.at, &given.path, separate());
        }
        None if applies && required && others.is_empty() => {
            faults.add(draft.at, &missing_path, missing);
        }
        None if applies && required => {
            let message = format!("missing; it {}", separate());
            faults.add(draft.at, &missing_path, message);
        }
        Some(_) | None => {}
    }
}

/// The different names that the parameter `governor` has in a block.
fn names(draft: &BlockDraft, governor: &str, table: &[Parameter]) -> Option<Vec<&'static str>> {
    let row = table.iter().position(|p| p.name == governor)?;
    let values: Vec<Value> = match draft.get(row) {
        Some(given) => given.values.iter().collect(),
        None => match &table[row].default {
            Default::Is(value) => vec![*value],
            Default::Required | Default::Follows(_) => return None,
        },
    };
    let mut names = Vec::new();
    for value in values {
        if let Value::Name(name) = value
            && !names.contains(&name)
        {
            names.push(name);
        }
    }
    (!names.is_empty()).then_some(names)
}

/// The meaning of a parameter and its allowed values.
fn described(parameter: &Parameter) -> String {
    let allowed = match parameter.kind {
        Kind::Number(range) => range.to_string(),
        Kind::Whole { min, max } => format!("a whole number from {min} to {max}"),
        Kind::Choice(choices) => {
            let names: Vec<&str> = choices.iter().map(|choice| choice.0).collect();
            names.join(" or ")
        }
    };
    format!("{} ({allowed})", parameter.meaning)
}
