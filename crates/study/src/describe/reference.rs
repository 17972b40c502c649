//! The reference pages of study files: prose with lists from the tables that decode them.

use std::fmt::Write;

use super::values::allowed;
use super::{figures, structure_page};
use crate::axes::axis_rule::RULES;
use crate::axes::design;
use crate::axes::interval::INTERVALS;
use crate::calibrate;
use crate::computed::sources::NAMED;
use crate::decode::blocks::BLOCK_KEYS;
use crate::decode::{self, checks, units};
use crate::figure::reduced;
use crate::reduction::OPERATORS;
use slipgap_solver::expression::{CONSTANTS, FUNCTIONS};
use slipgap_solver::problem::method::PARAMETERS as METHOD;
use slipgap_solver::problem::parameter::{Default, Kind, Parameter};
use slipgap_solver::problem::{PROBLEMS, Problem};
use slipgap_solver::solve::{WARNINGS, Warning};

/// The pages beside the general one, docs/study-files.md: one for each problem.
pub fn problem_pages() -> Vec<&'static str> {
    let problems = PROBLEMS.iter().map(|problem| problem.name());
    problems.chain([structure_page::PAGE]).collect()
}

/// docs/study-files-PROBLEM.md; `None` for a name that no problem has.
pub fn problem_reference(name: &str) -> Option<String> {
    if name == structure_page::PAGE {
        return Some(structure_page::reference());
    }
    let problem = PROBLEMS.iter().find(|problem| problem.name() == name)?;
    Some(problem_page(&**problem))
}

/// docs/study-files.md.
pub fn reference() -> String {
    let functions = FUNCTIONS.map(|function| function.0);
    include_str!("reference.md")
        .replace("{{study}}", &list(&decode::KEYS))
        .replace("{{units}}", &list(&units::KEYS))
        .replace("{{rules}}", &list(&RULES))
        .replace("{{constants}}", &code(&CONSTANTS))
        .replace("{{functions}}", &code(&functions))
        .replace("{{beside}}", &list(&BLOCK_KEYS))
        .replace("{{intervals}}", &list(&INTERVALS))
        .replace("{{designs}}", &list(&design::KINDS))
        .replace("{{design}}", &list(&design::KEYS))
        .replace("{{methods}}", &methods())
        .replace("{{named}}", &list(&NAMED))
        .replace("{{figures}}", &figures::reference())
        .replace("{{words}}", &list(&OPERATORS))
        .replace("{{reduced}}", &code(&reduced::KINDS))
        .replace("{{calibrate}}", &list(&calibrate::decode::KEYS))
        .replace("{{recommend}}", &list(&calibrate::recommend::KEYS))
        .replace("{{checks}}", &list(&checks::KEYS))
        .replace("{{warnings}}", &warnings())
}

/// Names as code, with commas.
pub(super) fn code(names: &[&str]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    quoted.join(", ")
}

/// Keys with their meanings as a list.
pub(super) fn list(keys: &[(&str, &str)]) -> String {
    let items = keys
        .iter()
        .map(|(key, meaning)| format!("- `{key}`: {meaning}"));
    items.collect::<Vec<_>>().join("\n")
}

/// The kinds of warnings.
fn warnings() -> String {
    let item = |kind: &Warning| format!("- `{}`: {}", kind.name(), kind.meaning());
    let items: Vec<String> = WARNINGS.iter().map(item).collect();
    items.join("\n")
}

/// The method and its parameters, which all problems have.
fn methods() -> String {
    let items: Vec<String> = METHOD.iter().map(item).collect();
    items.join("\n")
}

fn problem_page(problem: &dyn Problem) -> String {
    let name = problem.name();
    let schema = problem.schema();
    let mut text = format!(
        "# Study files: {name}\n\nFor those who write a study with `\"problem\": \"{name}\"`: {}. \
         [study-files.md](study-files.md) has the keys of all problems, [scope.md](scope.md) equations and symbols, \
         [laws-and-methods.md](laws-and-methods.md) the laws.\n\n## Parameters\n\n\
         With their units, allowed values and values if left out; besides those of the [method](study-files.md#methods).\n\n",
        schema.meaning
    );
    let of_method = |parameter: &Parameter| METHOD.iter().any(|own| own.name == parameter.name);
    let own = problem.parameters().iter().filter(|p| !of_method(p));
    text += &parameters(&own.collect::<Vec<_>>());
    text += "\n## Metrics\n\nIn the formulas c is computed, e exact. Of several metrics in a line, the formula is that of the first.\n\n";
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
fn parameters(all: &[&Parameter]) -> String {
    let like = |parameter: &Parameter| match (&parameter.default, parameter.name.split_once('.')) {
        (Default::Follows(from), Some((object, _))) => Some((object.to_owned(), from.to_string())),
        _ => None,
    };
    let mut text = String::new();
    for group in all.chunk_by(|a, b| like(a).is_some() && like(a) == like(b)) {
        text += &match (group, like(group[0])) {
            ([_, _, ..], Some((_, from))) => {
                let names: Vec<&str> = group.iter().map(|p| &*p.name).collect();
                format!("- {}: {from} if left out", code(&names))
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
        text += &match rest.len() > 100 && rest == above {
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
