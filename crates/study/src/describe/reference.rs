//! The lists of reference pages: warnings, methods, and the parameters and metrics of a problem.

use std::fmt::Write;

use super::schema::values::allowed;
use slipgap_motion::solve::{WARNINGS, Warning};
use slipgap_problem::problem::Problem;
use slipgap_problem::problem::method::PARAMETERS as METHOD;
use slipgap_problem::problem::numbers::parameter::{Default, Kind, Parameter};

/// Names as code, with commas.
pub(super) fn code(names: &[&str]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    quoted.join(", ")
}

/// Keys with their meanings as a list. Neighbours with the same meaning share an item.
pub(super) fn list(keys: &[(&str, &str)]) -> String {
    let item = |same: &[(&str, &str)]| {
        let names: Vec<&str> = same.iter().map(|key| key.0).collect();
        format!("- {}: {}", code(&names), same[0].1)
    };
    let items = keys.chunk_by(|a, b| a.1 == b.1).map(item);
    items.collect::<Vec<_>>().join("\n")
}

/// The keys of a small object as one item of a list.
pub(super) fn object(name: &str, keys: &[(&str, &str)]) -> String {
    let key = |(key, meaning): &(&str, &str)| match key == meaning {
        true => format!("`{key}`"),
        false => format!("`{key}` ({meaning})"),
    };
    let keys: Vec<String> = keys.iter().map(key).collect();
    format!("- {name}: {}", keys.join(", "))
}

/// The kinds of warnings.
pub(super) fn warnings() -> String {
    let item = |kind: &Warning| format!("- `{}`: {}", kind.name(), kind.meaning());
    let items: Vec<String> = WARNINGS.iter().map(item).collect();
    items.join("\n")
}

/// The method and its parameters, which all problems have.
pub(super) fn methods() -> String {
    let items: Vec<String> = METHOD.iter().map(item).collect();
    items.join("\n")
}

pub(super) fn problem_page(problem: &dyn Problem) -> String {
    let name = problem.name();
    let schema = problem.schema();
    let mut text = format!(
        "# Study files: {name}\n\n`\"problem\": \"{name}\"`: {}. \
         Also: [keys of all problems](study-files.md), [symbols](scope.md#symbols), [laws and methods](laws-and-methods.md).\n\n## Parameters\n\n",
        schema.meaning
    );
    let of_method = |parameter: &Parameter| METHOD.iter().any(|row| row.name == parameter.name);
    let others = problem.parameters().iter().filter(|p| !of_method(p));
    text += &parameters(&others.collect::<Vec<_>>());
    text += "\n## Metrics\n\nc is computed, e exact. Of several metrics in a line, the formula is that of the first.\n\n";
    text += &metrics(problem, true);
    text += "\nOnly if `metrics` of the study lists them:\n\n";
    text += &metrics(problem, false);
    let quantities = schema.quantities.iter().map(|q| (&*q.name, &*q.title));
    let _ = write!(
        text,
        "\n## Quantities\n\nOver time: {}.\n",
        named(quantities)
    );
    let profiles: Vec<(&str, &str)> = schema
        .profiles
        .iter()
        .map(|p| (&*p.name, &*p.title))
        .collect();
    if !profiles.is_empty() {
        let _ = write!(
            text,
            "\nAlong the structure: {}.\n",
            named(profiles.into_iter())
        );
    }
    let budgets = schema.budgets.iter().map(|b| (&*b.name, &*b.title));
    let _ = write!(text, "\nBudgets: {}.\n", named(budgets));
    text
}

fn named<'a>(names: impl Iterator<Item = (&'a str, &'a str)>) -> String {
    let items = names.map(|(name, title)| format!("`{name}` ({})", plain(title)));
    items.collect::<Vec<_>>().join(", ")
}

/// Parameters as a list. Those of one object that follow others in the same way share a line.
fn parameters(listed: &[&Parameter]) -> String {
    let like = |parameter: &Parameter| match (&parameter.default, parameter.name.split_once('.')) {
        (Default::Follows(from), Some((object, _))) => Some((object.to_owned(), from.to_string())),
        _ => None,
    };
    let mut text = String::new();
    for group in listed.chunk_by(|a, b| like(a).is_some() && like(a) == like(b)) {
        text += &match (group, like(group[0])) {
            ([_, _, ..], Some((_, from))) => {
                let names: Vec<&str> = group.iter().map(|p| &*p.name).collect();
                format!("- {}: default {from}", code(&names))
            }
            _ => item(group[0]),
        };
        text.push('\n');
    }
    text
}

/// A parameter as an item of a list.
fn item(parameter: &Parameter) -> String {
    let choices = match parameter.kind {
        Kind::Choice(choices) => choices,
        Kind::Number(_) | Kind::Whole { .. } => &[],
    };
    let allowed = match choices {
        [] => allowed(parameter),
        some => code(&some.iter().map(|choice| choice.0).collect::<Vec<_>>()),
    };
    let default = match &parameter.default {
        Default::Required => "required".into(),
        Default::Is(value) => format!("default {value}"),
        Default::Follows(from) => from.to_string(),
    };
    // The formulas of laws and methods have a page of their own.
    let meanings = match choices.len() > 1 && !["law", "method"].contains(&&*parameter.name) {
        true => choices
            .iter()
            .map(|(name, meaning)| format!("; {name}: {meaning}"))
            .collect(),
        false => String::new(),
    };
    let unit = match &*parameter.unit {
        "1" => String::new(),
        unit => format!("{unit}, "),
    };
    let only = match &parameter.applies {
        Some(on) => format!("; for {} {}", on.governor, on.choices()),
        None => String::new(),
    };
    let column = match parameter.heading {
        Some(column) => format!("; its column is `{column}`"),
        None => String::new(),
    };
    format!(
        "- `{}` ({unit}{allowed}; {default}{only}): {}{meanings}{column}",
        parameter.name, parameter.meaning
    )
}

/// The metrics that are always computed, or those that a study lists. Metrics of two quantities that differ in nothing else share a line.
fn metrics(problem: &dyn Problem, default: bool) -> String {
    let mut lines: Vec<(String, Vec<String>, &str)> = Vec::new();
    for metric in problem.metrics().iter().filter(|m| m.default == default) {
        let name = match &*metric.unit {
            "1" => format!("`{}`", metric.name),
            unit => format!("`{}` (in {unit})", metric.name),
        };
        let pattern = metric.meaning.replace("rdot", "r");
        match lines.iter_mut().find(|line| line.0 == pattern) {
            Some(line) => line.1.push(name),
            None => lines.push((pattern, vec![name], &metric.meaning)),
        }
    }
    let mut text = String::new();
    let mut above = "";
    for (_, names, meaning) in &lines {
        let (formula, rest) = meaning.split_once("; ").unwrap_or((meaning, ""));
        let names = names.join(", ");
        // Long conditions that several metrics share are written once.
        text += &match rest.len() > 60 && rest == above {
            true => format!("- {names}: {formula}; the rest as above\n"),
            false => format!("- {names}: {meaning}\n"),
        };
        above = rest;
    }
    text
}

/// An axis title without its markup.
fn plain(title: &str) -> String {
    title.replace(['*', '_', '^'], "")
}
