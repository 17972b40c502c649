//! The `parameters` object of a block: values, axes and expressions, decoded by the table of the problem.

use super::applicability::check_applicability;
use super::axis_rule;
use super::draft::{BlockDraft, ParameterDraft};
use super::interval::Interval;
use crate::source::faults::{Faults, in_words, join, quoted};
use crate::source::object::Object;
use crate::source::tree::{Node, Tree};
use crate::value::{value, with_unit};
use slipgap_cases::axis::values::Values;
use slipgap_problem::problem::expression::Formula;
use slipgap_problem::problem::numbers::parameter::{Kind, Parameter};

/// Decodes a `parameters` object without its faulty values; `None` if the node is not an object.
pub(crate) fn parameters(
    node: &Node,
    path: &str,
    table: &[Parameter],
    faults: &mut Faults,
) -> Option<BlockDraft> {
    let mut parameters = Vec::new();
    gather(node, path, "", table, &mut parameters, faults)?;
    let mut draft = BlockDraft {
        at: node.at,
        path: path.to_owned(),
        parameters,
        faulty: Vec::new(),
        zips: Vec::new(),
        when: None,
        design: None,
    };
    for (row, parameter) in table.iter().enumerate() {
        check_applicability(&draft, row, parameter, table, faults);
    }
    let valid = |given: &ParameterDraft| {
        !given.values.is_empty() || given.formula.is_some() || given.interval.is_some()
    };
    let faulty = draft.parameters.iter().filter(|given| !valid(given));
    draft.faulty = faulty.map(|given| given.parameter).collect();
    draft.parameters.retain(valid);
    Some(draft)
}

/// Decodes the keys of an object. `right.L` of the table is key `L` of the object `right`.
fn gather(
    node: &Node,
    path: &str,
    prefix: &str,
    table: &[Parameter],
    parameters: &mut Vec<ParameterDraft>,
    faults: &mut Faults,
) -> Option<()> {
    let mut allowed: Vec<&str> = Vec::new();
    for rest in table.iter().filter_map(|p| p.name.strip_prefix(prefix)) {
        let key = rest.split('.').next().unwrap_or(rest);
        if !allowed.contains(&key) {
            allowed.push(key);
        }
    }
    let object = Object::of_keys(node, path, &allowed, faults)?;
    for member in &object.members {
        let path = join(path, &member.key);
        let name = format!("{prefix}{}", member.key);
        let within = format!("{name}.");
        let group = table.iter().any(|p| p.name.starts_with(&within));
        let row = table.iter().position(|p| p.name == name);
        match (row, &member.node.tree) {
            (_, Tree::Object(_)) if group => {
                gather(&member.node, &path, &within, table, parameters, faults);
            }
            (Some(parameter), _) => {
                parameters.push(axis(&member.node, path, parameter, table, faults));
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
) -> ParameterDraft {
    let before = faults.count();
    let row = &table[parameter];
    let mut given = ParameterDraft {
        parameter,
        path,
        at: node.at,
        values: Values::default(),
        places: Vec::new(),
        list: matches!(node.tree, Tree::List(_)),
        axis: matches!(node.tree, Tree::List(_) | Tree::Object(_)),
        formula: None,
        interval: None,
        sampled: None,
    };
    let path = &given.path;
    match &node.tree {
        Tree::List(items) if items.is_empty() => {
            faults.must_be(node, path, "a value or a non-empty list");
        }
        Tree::List(items) => {
            let numbered = items.iter().enumerate();
            let values =
                numbered.filter_map(|(i, item)| value(item, &format!("{path}[{i}]"), row, faults));
            given.values = values.collect();
            given.places = items.iter().map(|item| item.at).collect();
        }
        Tree::Object(_) if Interval::is_interval(node) => {
            given.interval = Interval::decode(node, path, row, faults);
        }
        Tree::Object(_) => {
            given.values = axis_rule::values(node, path, row, faults).unwrap_or_default();
        }
        Tree::Text(text) if !matches!(row.kind, Kind::Choice(_)) => {
            match Formula::number(text, table) {
                Ok(formula) if !formula.uses().is_empty() => {
                    given.formula = Some((formula, text.clone()));
                }
                Ok(_) => given.values = value(node, path, row, faults).into_iter().collect(),
                Err(fault) => {
                    let what = with_unit(text, Some(row)).unwrap_or_else(|| in_words(&fault));
                    faults.add(node.at, path, format!("{}: {what}", quoted(text)));
                }
            }
        }
        Tree::Text(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => {
            given.values = value(node, path, row, faults).into_iter().collect();
        }
    }
    if faults.count() > before {
        given.values = Values::default();
    }
    given
}
