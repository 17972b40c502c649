//! The reference page of study files: prose with lists from the tables that decode them.

use std::fmt::Write;

use super::structure;
use super::values::allowed;
use crate::axes::axis_rule::RULES;
use crate::axes::design;
use crate::axes::interval::INTERVALS;
use crate::decode::blocks::BLOCK_KEYS;
use crate::decode::{self, checks, units};
use crate::figure::keys::{COMMON, Key};
use crate::figure::kinds::KINDS;
use crate::figure::reduced;
use crate::reduction::OPERATORS;
use slipgap_solver::expression::{CONSTANTS, FUNCTIONS};
use slipgap_solver::problem::parameter::{Default, Parameter};
use slipgap_solver::problem::{PROBLEMS, Problem};
use slipgap_solver::solve::WARNINGS;

/// docs/study-files.md.
pub fn reference() -> String {
    let kinds: Vec<String> = KINDS.iter().map(kind).collect();
    let problems = PROBLEMS.iter().map(|p| problem(&**p));
    let problems: Vec<String> = problems.chain([structure::reference()]).collect();
    let code = |names: &[&str]| -> String {
        let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
        quoted.join(", ")
    };
    let functions = FUNCTIONS.map(|function| function.0);
    include_str!("reference.md")
        .replace("{{study}}", &pairs(&decode::KEYS))
        .replace("{{units}}", &pairs(&units::KEYS))
        .replace("{{rules}}", &pairs(&RULES))
        .replace("{{constants}}", &code(&CONSTANTS))
        .replace("{{functions}}", &code(&functions))
        .replace("{{beside}}", &pairs(&BLOCK_KEYS))
        .replace("{{intervals}}", &pairs(&INTERVALS))
        .replace("{{designs}}", &pairs(&design::KINDS))
        .replace("{{design}}", &pairs(&design::KEYS))
        .replace("{{common}}", &keys(&COMMON))
        .replace("{{kinds}}", &kinds.join("\n"))
        .replace("{{words}}", &pairs(&OPERATORS))
        .replace("{{reduced}}", &code(&reduced::KINDS))
        .replace("{{checks}}", &pairs(&checks::KEYS))
        .replace("{{warnings}}", &warnings())
        .replace("{{problems}}\n", &problems.join("\n"))
}

/// The kinds of warnings.
fn warnings() -> String {
    let mut text = String::from("| kind | the cases | when |\n| --- | --- | --- |\n");
    for kind in WARNINGS {
        let (name, message, meaning) = (kind.name(), cell(kind.message()), cell(kind.meaning()));
        let _ = writeln!(text, "| `{name}` | {message} | {meaning} |");
    }
    text.trim_end().to_owned()
}

fn pairs(table: &[(&str, &str)]) -> String {
    let mut text = String::from("| key | meaning |\n| --- | --- |\n");
    for (key, meaning) in table {
        let _ = writeln!(text, "| `{key}` | {} |", cell(meaning));
    }
    text.trim_end().to_owned()
}

fn keys(table: &[Key]) -> String {
    let mut text = String::from("| key | | meaning |\n| --- | --- | --- |\n");
    for key in table {
        let needed = if key.required { "required" } else { "" };
        let _ = writeln!(
            text,
            "| `{}` | {needed} | {} |",
            key.name,
            cell(key.meaning)
        );
    }
    text.trim_end().to_owned()
}

fn kind(kind: &crate::figure::kinds::Kind) -> String {
    let own = match kind.keys {
        [] => String::new(),
        some => format!("\n{}\n", keys(some)),
    };
    format!("### {}\n\n{}.\n{own}", kind.name, capital(kind.meaning))
}

fn problem(problem: &dyn Problem) -> String {
    let mut text = format!(
        "## {}\n\n{}.\n\n| parameter | unit | allowed | if left out | meaning |\n| --- | --- | --- | --- | --- |\n",
        problem.name(),
        capital(&problem.schema().meaning)
    );
    for parameter in problem.parameters() {
        let _ = writeln!(
            text,
            "| `{}` | {} | {} | {} | {} |",
            parameter.name,
            unit(&parameter.unit),
            cell(&allowed(parameter)),
            cell(&left_out(parameter)),
            cell(&meaning(parameter))
        );
    }
    text += "\n| metric | unit | | formula (c computed, e exact) |\n| --- | --- | --- | --- |\n";
    for metric in problem.metrics() {
        let listed = if metric.default { "" } else { "if listed" };
        let (unit, meaning) = (unit(&metric.unit), cell(&metric.meaning));
        let _ = writeln!(
            text,
            "| `{}` | {unit} | {listed} | {meaning} |",
            metric.name
        );
    }
    let named = |names: Vec<(&str, &str)>| {
        let items = names
            .iter()
            .map(|(name, title)| format!("`{name}` ({})", plain(title)));
        items.collect::<Vec<_>>().join(", ")
    };
    let quantities = problem
        .schema()
        .quantities
        .iter()
        .map(|q| (&*q.name, &*q.title))
        .collect();
    let _ = write!(text, "\nOver time: {}.\n", named(quantities));
    let profiles: Vec<(&str, &str)> = problem
        .schema()
        .profiles
        .iter()
        .map(|p| (&*p.name, &*p.title))
        .collect();
    if !profiles.is_empty() {
        let _ = write!(text, "\nAlong the structure: {}.\n", named(profiles));
    }
    let budgets = problem
        .schema()
        .budgets
        .iter()
        .map(|b| (&*b.name, &*b.title))
        .collect();
    let _ = write!(text, "\nBudgets: {}.\n", named(budgets));
    text
}

/// The meaning of a parameter, and its column if that has another name.
fn meaning(parameter: &Parameter) -> String {
    match parameter.heading {
        Some(column) => format!("{}; its column is `{column}`", parameter.meaning),
        None => parameter.meaning.to_string(),
    }
}

fn left_out(parameter: &Parameter) -> String {
    let default = match &parameter.default {
        Default::Required => "required".into(),
        Default::Is(value) => value.to_string(),
        Default::Follows(from) => from.to_string(),
    };
    match &parameter.applies {
        Some(on) => format!("{default}; only for {} {}", on.governor, on.choices()),
        None => default,
    }
}

fn unit(unit: &str) -> &str {
    if unit == "1" { "" } else { unit }
}

/// An axis title without its markup.
fn plain(title: &str) -> String {
    title.replace(['*', '_', '^'], "")
}

/// A text for a cell of a table.
fn cell(text: &str) -> String {
    text.replace('|', "\\|")
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(|c| c.to_uppercase().to_string());
    first.unwrap_or_default() + letters.as_str()
}
