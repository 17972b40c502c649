//! The `parameters` object of a block: values and axes by the problem's table, and which of them apply.

use super::applicability::applies;
use super::axis_rule;
use super::draft::{Draft, Given};
use super::interval::Interval;
use crate::problem::parameter::{Kind, Parameter};
use crate::study::expression::Formula;
use crate::study::source::faults::quoted;
use crate::study::source::faults::{Faults, join};
use crate::study::source::object::Object;
use crate::study::source::tree::{Node, Tree};
use crate::study::value::{value, with_unit};

/// Decodes a `parameters` object, what is faulty left out; `None` if it is none.
pub(in crate::study) fn parameters(
    node: &Node,
    path: &str,
    table: &[Parameter],
    faults: &mut Faults,
) -> Option<Draft> {
    let mut given = Vec::new();
    gather(node, path, "", table, &mut given, faults)?;
    let mut draft = Draft {
        at: node.at,
        path: path.to_owned(),
        given,
        faulty: Vec::new(),
        zips: Vec::new(),
        when: None,
        design: None,
    };
    for (row, parameter) in table.iter().enumerate() {
        applies(&draft, row, parameter, table, faults);
    }
    let good = |given: &Given| {
        !given.values.is_empty() || given.formula.is_some() || given.interval.is_some()
    };
    let without = draft.given.iter().filter(|given| !good(given));
    draft.faulty = without.map(|given| given.parameter).collect();
    draft.given.retain(good);
    Some(draft)
}

/// Decodes the keys of one object; `right.L` of the table is key `L` of the object `right`.
fn gather(
    node: &Node,
    path: &str,
    prefix: &str,
    table: &[Parameter],
    given: &mut Vec<Given>,
    faults: &mut Faults,
) -> Option<()> {
    let mut allowed: Vec<&str> = Vec::new();
    for rest in table.iter().filter_map(|p| p.name.strip_prefix(prefix)) {
        let key = rest.split('.').next().unwrap_or(rest);
        if !allowed.contains(&key) {
            allowed.push(key);
        }
    }
    let object = Object::open(node, path, &allowed, faults)?;
    for member in &object.members {
        let path = join(path, &member.key);
        let name = format!("{prefix}{}", member.key);
        let within = format!("{name}.");
        let group = table.iter().any(|p| p.name.starts_with(&within));
        let row = table.iter().position(|p| p.name == name);
        match (row, &member.node.tree) {
            (_, Tree::Object(_)) if group => {
                gather(&member.node, &path, &within, table, given, faults);
            }
            (Some(parameter), _) => {
                given.push(axis(&member.node, path, parameter, table, faults));
            }
            (None, _) => faults.must_be(&member.node, &path, "an object"),
        }
    }
    Some(())
}

/// Decodes a single value, a list of values, a rule for them, an interval or an expression.
fn axis(
    node: &Node,
    path: String,
    parameter: usize,
    table: &[Parameter],
    faults: &mut Faults,
) -> Given {
    let before = faults.count();
    let row = &table[parameter];
    let mut given = Given {
        parameter,
        path,
        at: node.at,
        values: Vec::new(),
        list: matches!(node.tree, Tree::List(_)),
        axis: matches!(node.tree, Tree::List(_) | Tree::Object(_)),
        formula: None,
        interval: None,
    };
    let path = &given.path;
    match &node.tree {
        Tree::List(items) if items.is_empty() => {
            faults.must_be(node, path, "a value or a non-empty list");
        }
        Tree::List(items) => {
            for (i, item) in items.iter().enumerate() {
                let path = format!("{path}[{i}]");
                let value = value(item, &path, row, faults);
                given.values.extend(value.map(|value| (value, item.at)));
            }
        }
        Tree::Object(_) if Interval::meant(node) => {
            given.interval = Interval::decode(node, path, row, faults);
        }
        Tree::Object(_) => {
            let rule = axis_rule::values(node, path, row, faults)
                .into_iter()
                .flatten();
            given.values.extend(rule.map(|value| (value, node.at)));
        }
        Tree::Text(text) if !matches!(row.kind, Kind::Choice(_)) => {
            match Formula::number(text, table) {
                Ok(formula) if !formula.uses().is_empty() => {
                    given.formula = Some((formula, text.clone()));
                }
                Ok(_) => {
                    let value = value(node, path, row, faults);
                    given.values.extend(value.map(|value| (value, node.at)));
                }
                Err(fault) => {
                    let what = with_unit(text, Some(row)).unwrap_or(fault.message);
                    faults.add(node.at, path, format!("{}: {what}", quoted(text)));
                }
            }
        }
        _ => {
            let value = value(node, path, row, faults);
            given.values.extend(value.map(|value| (value, node.at)));
        }
    }
    if faults.count() > before {
        given.values.clear();
    }
    given
}
