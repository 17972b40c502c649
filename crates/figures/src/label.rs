//! The parameters that distinguish the cases of a figure, and the labels of the legend.

use super::{DrawnCase, words};
use slipgap_drawing::style;
use slipgap_drawing::text::number::Form;
use slipgap_drawing::text::{self, markup};
use slipgap_problem::problem::Case;
use slipgap_problem::problem::numbers::parameter::{Default, Parameter, Value};
use slipgap_study::{Filter, Study};
use std::collections::HashMap;

/// Whether two values are the same, or both do not apply.
pub fn same(a: Option<Value>, b: Option<Value>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => a.matches(b),
        (None, None) => true,
        (Some(_), None) | (None, Some(_)) => false,
    }
}

/// The different values of parameter `row` among the cases, in order of appearance.
pub fn values(cases: &[DrawnCase], row: usize) -> Vec<Option<Value>> {
    let mut found: Vec<Option<Value>> = Vec::new();
    for shown in cases {
        let value = shown.value(row);
        if !found.iter().any(|f| same(*f, value)) {
            found.push(value);
        }
    }
    found
}

/// `by`, and the parameters that vary but are the same in all cases with the same `by`: the captions of panels give them.
pub fn bound(table: &[Parameter], cases: &[DrawnCase], by: usize) -> Vec<usize> {
    let groups = values(cases, by);
    let settled = |row: &usize| {
        groups.iter().all(|group| {
            let of_group = cases.iter().filter(|c| same(c.value(by), *group));
            let mut its = of_group.map(|c| c.value(*row));
            let first = its.next().flatten();
            its.all(|value| same(value, first))
        })
    };
    let others = (0..table.len()).filter(|row| *row != by && varies(cases, *row));
    std::iter::once(by).chain(others.filter(settled)).collect()
}

/// The values of these parameters as the caption of a panel of this width: only that of the first one if they need more.
pub fn caption(
    table: &[Parameter],
    cases: &[DrawnCase],
    rows: &[usize],
    case: &Case,
    width: f64,
) -> String {
    let whole = value_labels(table, cases, rows, case);
    // With a letter before it.
    let length = text::width(&whole, style::TITLE) + 2.0 * style::TITLE;
    match rows {
        [first, _, ..] if length > width => value_labels(table, cases, &[*first], case),
        _ => whole,
    }
}

/// The values of these parameters in a case, in markup, without those that only repeat another.
pub fn value_labels(
    table: &[Parameter],
    cases: &[DrawnCase],
    rows: &[usize],
    case: &Case,
) -> String {
    let distinguishing = rows.iter().filter(|row| !repeats_another(cases, **row));
    let part = |row: &usize| Some((&table[*row], case.values[*row]?, form(cases, *row)));
    joined(distinguishing.filter_map(part))
}

/// The parameters that do not distinguish curves over `x`: `x`, what follows from it, and what the problem works out from it
/// and others.
pub fn along(study: &Study, cases: &[DrawnCase], x: usize) -> Vec<usize> {
    let table = study.problem.parameters();
    let given = |row: usize| study.blocks.iter().any(|block| block.gives(row));
    let worked_out =
        |row: &usize| matches!(table[*row].default, Default::Follows(_)) && !given(*row);
    let no_filter = Filter::default();
    let follows = |row: &usize| {
        let mut blocks = study.blocks.iter();
        blocks.all(|block| block.follows(&no_filter, *row, &[x]))
    };
    // Blocks may give different values at the same place.
    let one_a_place = |row: usize| settled_by(cases, &[x], row);
    let (mut along, mut distinguishing) = (vec![x], Vec::new());
    for row in (0..table.len()).filter(|row| *row != x && varies(cases, *row)) {
        let follows = !study.blocks.is_empty() && follows(&row) && one_a_place(row);
        match !worked_out(&row) && follows {
            true => along.push(row),
            false if !worked_out(&row) => distinguishing.push(row),
            false => {}
        }
    }
    // A value that the problem computes distinguishes a curve if all cases of the curve have it.
    let settled = |row: &usize| settled_by(cases, &distinguishing, *row);
    let unsettled = (0..table.len()).filter(|row| worked_out(row) && !settled(row));
    along.extend(unsettled);
    along
}

/// Whether all cases with the same values of the parameters `by` have the same value of another one.
fn settled_by(cases: &[DrawnCase], by: &[usize], row: usize) -> bool {
    let mut found = HashMap::new();
    cases.iter().all(|shown| {
        let its = shown.value(row);
        let first = found.entry(shown.identity(by)).or_insert(its);
        same(*first, its)
    })
}

fn varies(cases: &[DrawnCase], row: usize) -> bool {
    values(cases, row).iter().flatten().count() > 1
}

/// Whether a parameter has the value of an earlier one in every case, as the mesh of the right bar that of the left one.
fn repeats_another(cases: &[DrawnCase], row: usize) -> bool {
    let repeats = |other| {
        let alike = |c: &DrawnCase| same(c.value(other), c.value(row));
        cases.iter().all(alike)
    };
    (0..row).any(repeats)
}

/// Whether a label of cases has one value of a parameter, together with the parameters `except`: its name is enough.
fn behind_a_label(table: &[Parameter], cases: &[DrawnCase], row: usize, except: &[usize]) -> bool {
    let labels = Vec::from_iter((0..table.len()).filter(|row| table[*row].is_label()));
    if labels.is_empty() || table[row].is_label() {
        return false;
    }
    settled_by(cases, &[&labels, except].concat(), row)
}

/// The parameters that labels name: `by`, or else all that vary but the rows `except`.
pub fn named(
    table: &[Parameter],
    cases: &[DrawnCase],
    by: Option<usize>,
    except: &[usize],
) -> Vec<usize> {
    let rows = match by {
        Some(row) => vec![row],
        None => {
            let varies = (0..table.len()).filter(|row| {
                !except.contains(row) && varies(cases, *row) && !repeats_another(cases, *row)
            });
            varies
                .filter(|row| !behind_a_label(table, cases, *row, except))
                .collect()
        }
    };
    // A choice is not named if each case has a parameter that applies only to its choice.
    let implied = |row: usize| {
        cases.iter().all(|shown| {
            let depends = |other: &usize| {
                table[*other]
                    .applies
                    .as_ref()
                    .is_some_and(|on| on.governor == table[row].name)
                    && shown.value(*other).is_some()
            };
            rows.iter().any(depends)
        })
    };
    rows.iter().copied().filter(|row| !implied(*row)).collect()
}

/// The labels of the cases by the parameters that `named` finds; none is empty.
pub fn labels(
    table: &[Parameter],
    cases: &[DrawnCase],
    by: Option<usize>,
    except: &[usize],
) -> Vec<String> {
    let rows: Vec<(usize, Form)> = named(table, cases, by, except)
        .into_iter()
        .map(|row| (row, form(cases, row)))
        .collect();
    cases
        .iter()
        .map(|shown| label(table, shown, &rows))
        .collect()
}

/// The form of number that distinguishes the values of a parameter.
pub fn form(cases: &[DrawnCase], row: usize) -> Form {
    let values = cases.iter().filter_map(|shown| shown.value(row));
    Form::of(values.filter_map(|value| value.as_f64()))
}

/// The label of a case by these parameters, each with its form of numbers.
fn label(table: &[Parameter], shown: &DrawnCase, rows: &[(usize, Form)]) -> String {
    let pairs = rows.iter();
    let parts = pairs.filter_map(|(row, form)| Some((&table[*row], shown.value(*row)?, *form)));
    match joined(parts) {
        text if text.is_empty() => "computed".into(),
        text => text,
    }
}

/// Values behind one another. Of a record with the event and station of the one before it, only the component.
fn joined<'a>(values: impl Iterator<Item = (&'a Parameter, Value, Form)>) -> String {
    let mut before = None;
    let part = |(parameter, value, form): (&Parameter, Value, Form)| {
        let whole = value_label(parameter, value, form);
        let split = match value {
            Value::Name(name) if parameter.shown(name) != name => whole.rsplit_once(", "),
            Value::Number(_) | Value::Whole(_) | Value::Name(_) => None,
        };
        let parts = split.map(|(stem, component)| (stem.to_owned(), component.to_owned()));
        match parts {
            Some((stem, component)) if before.as_ref() == Some(&stem) => component,
            parts => {
                before = parts.map(|parts| parts.0).or(before.take());
                whole
            }
        }
    };
    values.map(part).collect::<Vec<_>>().join(", ")
}

/// A value of a parameter in markup, in this form.
pub fn value(parameter: &Parameter, value: Value, form: Form) -> String {
    match value {
        Value::Number(x) => form.write(x),
        Value::Whole(n) => n.to_string(),
        Value::Name(name) => markup::escape(words::of(parameter.shown(name))),
    }
}

/// `symbol = value` in markup, in this form; only the name for a choice.
pub fn value_label(parameter: &Parameter, value: Value, form: Form) -> String {
    match value {
        Value::Name(_) => self::value(parameter, value, form),
        Value::Number(_) | Value::Whole(_) => {
            let shown_unit = parameter.shown_unit.as_ref();
            let unit = shown_unit.map_or(String::new(), |unit| format!(" {}", markup::unit(unit)));
            let value = self::value(parameter, value, form);
            format!("{} = {value}{unit}", parameter.symbol)
        }
    }
}

/// For each label its index among the different labels, and the different labels in order of first appearance.
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
