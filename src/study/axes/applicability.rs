//! Which parameters apply in a block, by the names chosen in it.

use super::draft::Draft;
use crate::problem::parameter::{Default, Kind, Parameter, Value};
use crate::study::source::faults::{Faults, join};

/// Refuses a parameter that does not apply, and misses one that does and has no default.
pub(in crate::study) fn applies(
    draft: &Draft,
    row: usize,
    parameter: &Parameter,
    table: &[Parameter],
    faults: &mut Faults,
) {
    let given = draft.given.iter().find(|given| given.parameter == row);
    let required = matches!(parameter.default, Default::Required);
    let missing = format!("missing: {}", described(parameter));
    let missing_path = join(&draft.path, &parameter.name);
    let Some((governor, wanted)) = &parameter.applies else {
        if given.is_none() && required {
            faults.add(draft.at, &missing_path, missing);
        }
        return;
    };
    // Faulty or missing itself: then nothing can be said of what depends on it.
    let Some(chosen) = names(draft, governor, table) else {
        return;
    };
    let others: Vec<&str> = chosen.iter().copied().filter(|c| *c != wanted).collect();
    let here = others.len() < chosen.len();
    let apart = format!(
        "applies only to {governor} {wanted}, but {governor} is also {} here; give each {governor} its own block \
         in \"blocks\"",
        others.join(", ")
    );
    match given {
        Some(given) if !here => {
            let fitting = table.iter().filter(|p| match &p.applies {
                Some((other, name)) => other == governor && chosen.iter().any(|own| own == name),
                None => true,
            });
            let fitting: Vec<&str> = fitting.map(|p| &*p.name).collect();
            let message = format!(
                "does not apply to {governor} {}, only to {wanted}; allowed: {}",
                chosen.join(", "),
                fitting.join(", ")
            );
            faults.add(given.at, &given.path, message);
        }
        Some(given) if !others.is_empty() => faults.add(given.at, &given.path, apart),
        None if here && required && others.is_empty() => {
            faults.add(draft.at, &missing_path, missing);
        }
        None if here && required => {
            faults.add(draft.at, &missing_path, format!("missing; it {apart}"));
        }
        _ => {}
    }
}

/// The different names that the parameter called `governor` takes in a block.
fn names(draft: &Draft, governor: &str, table: &[Parameter]) -> Option<Vec<&'static str>> {
    let row = table.iter().position(|p| p.name == governor)?;
    let values: Vec<Value> = match draft.given.iter().find(|given| given.parameter == row) {
        Some(given) => given.values.iter().map(|(value, _)| *value).collect(),
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

/// What a parameter is and what it may be.
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
