//! Which parameters tell the cases of a figure apart, and how its legend says so.

use super::Shown;
use super::number;
use crate::problem::parameter::{Kind, Parameter, Value};

/// Whether two values are the same, or both do not apply.
pub fn same(a: Option<Value>, b: Option<Value>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => a.matches(b),
        (None, None) => true,
        _ => false,
    }
}

/// The different values of parameter `row` among the cases, in order of appearance.
pub fn values(cases: &[Shown], row: usize) -> Vec<Option<Value>> {
    let mut found: Vec<Option<Value>> = Vec::new();
    for shown in cases {
        let value = shown.case.values[row];
        if !found.iter().any(|f| same(*f, value)) {
            found.push(value);
        }
    }
    found
}

/// The labels of the cases: by parameter `by`, or else by all that vary but the rows `except`. Never empty ones.
pub fn labels(
    table: &[Parameter],
    cases: &[Shown],
    by: Option<usize>,
    except: &[usize],
) -> Vec<String> {
    let mut rows = match by {
        Some(row) => vec![row],
        None => (0..table.len())
            .filter(|row| !except.contains(row) && values(cases, *row).iter().flatten().count() > 1)
            .collect(),
    };
    // A law need not be named where each case's own parameter tells it.
    let implied = |row: usize| {
        cases.iter().all(|shown| {
            let depends = |other: &usize| {
                table[*other]
                    .applies
                    .is_some_and(|(on, _)| on == table[row].name)
                    && shown.case.values[*other].is_some()
            };
            rows.iter().any(depends)
        })
    };
    let kept: Vec<usize> = rows.iter().copied().filter(|row| !implied(*row)).collect();
    rows = kept;
    cases
        .iter()
        .map(|shown| label(table, shown, &rows))
        .collect()
}

fn label(table: &[Parameter], shown: &Shown, rows: &[usize]) -> String {
    let parts: Vec<_> = rows
        .iter()
        .filter_map(|row| shown.case.values[*row].map(|value| said(&table[*row], value)))
        .collect();
    if parts.is_empty() {
        "computed".into()
    } else {
        parts.join(", ")
    }
}

/// `symbol = value` in markup; a name speaks for itself.
pub fn said(parameter: &Parameter, value: Value) -> String {
    match (parameter.kind, value) {
        (Kind::Choice(_), Value::Name(name)) => super::markup::escape(name),
        _ => format!("{} = {}", parameter.symbol, number::value(value)),
    }
}

/// Numbers the labels by first appearance, so that equal labels look alike: for each label its number, and all of them.
pub fn numbered(labels: &[String]) -> (Vec<usize>, Vec<String>) {
    let mut distinct: Vec<String> = Vec::new();
    let numbers = labels
        .iter()
        .map(|label| match distinct.iter().position(|d| d == label) {
            Some(number) => number,
            None => {
                distinct.push(label.clone());
                distinct.len() - 1
            }
        })
        .collect();
    (numbers, distinct)
}
