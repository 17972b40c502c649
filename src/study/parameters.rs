//! The `parameters` object of a block: values and axes by the problem's table, and which of them apply.

use super::object::Object;
use super::report::{Faults, join};
use super::spread;
use super::tree::{Node, Tree};
use super::value::value;
use super::{Axis, Block};
use crate::problem::parameter::{Default, Kind, Parameter, Value};

/// A parameter that a block gives, with the place of every value.
pub(super) struct Given {
    /// Row of the table.
    pub parameter: usize,
    pub path: String,
    /// Offset of the whole value.
    pub at: usize,
    /// Values with their offsets; none at all if one of them is faulty.
    pub values: Vec<(Value, usize)>,
    /// Whether the values stand in a list.
    pub list: bool,
}

/// The parameters of a block with their places, for the faults that show only later.
pub(super) struct Draft {
    /// Offset of the opening brace.
    pub at: usize,
    pub path: String,
    pub given: Vec<Given>,
    /// Rows of parameters that are given, but with a faulty value: of them nothing further is said.
    pub faulty: Vec<usize>,
}

impl Draft {
    /// The block without places.
    pub fn block(&self) -> Block {
        let axes = self.given.iter().map(|given| Axis {
            parameter: given.parameter,
            values: given.values.iter().map(|(value, _)| *value).collect(),
        });
        let axes = axes.collect();
        Block { axes }
    }
}

/// Decodes a `parameters` object, what is faulty left out; `None` if it is none.
pub(super) fn parameters(
    node: &Node,
    path: &str,
    table: &'static [Parameter],
    faults: &mut Faults,
) -> Option<Draft> {
    let mut given = Vec::new();
    gather(node, path, "", table, &mut given, faults)?;
    let mut draft = Draft {
        at: node.at,
        path: path.to_owned(),
        given,
        faulty: Vec::new(),
    };
    for (row, parameter) in table.iter().enumerate() {
        applies(&draft, row, parameter, table, faults);
    }
    let without = draft.given.iter().filter(|given| given.values.is_empty());
    draft.faulty = without.map(|given| given.parameter).collect();
    draft.given.retain(|given| !given.values.is_empty());
    Some(draft)
}

/// Decodes the keys of one object; `right.L` of the table is key `L` of the object `right`.
fn gather(
    node: &Node,
    path: &str,
    prefix: &str,
    table: &'static [Parameter],
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
                given.push(axis(
                    &member.node,
                    path,
                    parameter,
                    &table[parameter],
                    faults,
                ));
            }
            (None, _) => faults.must_be(&member.node, &path, "an object"),
        }
    }
    Some(())
}

/// Decodes a single value, a list of values or a rule for them.
fn axis(
    node: &Node,
    path: String,
    parameter: usize,
    row: &Parameter,
    faults: &mut Faults,
) -> Given {
    let before = faults.count();
    let mut values = Vec::new();
    let list = matches!(node.tree, Tree::List(_));
    match &node.tree {
        Tree::List(items) if items.is_empty() => {
            faults.must_be(node, &path, "a value or a list of at least one");
        }
        Tree::List(items) => {
            for (i, item) in items.iter().enumerate() {
                let path = format!("{path}[{i}]");
                values.extend(value(item, &path, row, faults).map(|value| (value, item.at)));
            }
        }
        Tree::Object(_) => {
            let rule = spread::values(node, &path, row, faults);
            values.extend(rule.into_iter().flatten().map(|value| (value, node.at)));
        }
        _ => values.extend(value(node, &path, row, faults).map(|value| (value, node.at))),
    }
    if faults.count() > before {
        values.clear();
    }
    Given {
        parameter,
        path,
        at: node.at,
        values,
        list,
    }
}

/// Refuses a parameter that does not apply, and misses one that does and has no default.
fn applies(
    draft: &Draft,
    row: usize,
    parameter: &Parameter,
    table: &'static [Parameter],
    faults: &mut Faults,
) {
    let given = draft.given.iter().find(|given| given.parameter == row);
    let required = matches!(parameter.default, Default::Required);
    let missing = format!("missing: {}", described(parameter));
    let missing_path = join(&draft.path, parameter.name);
    let Some((governor, wanted)) = parameter.applies else {
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
        "applies to {governor} {wanted} alone, and {governor} is also {} here; give each {governor} a block of its \
         own in \"blocks\"",
        others.join(", ")
    );
    match given {
        Some(given) if !here => {
            let fitting = table.iter().filter(|p| match p.applies {
                Some((other, name)) => other == governor && chosen.contains(&name),
                None => true,
            });
            let fitting: Vec<&str> = fitting.map(|p| p.name).collect();
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
            faults.add(draft.at, &missing_path, format!("missing, and it {apart}"));
        }
        _ => {}
    }
}

/// The different names that the parameter called `governor` takes in a block.
fn names(draft: &Draft, governor: &str, table: &'static [Parameter]) -> Option<Vec<&'static str>> {
    let row = table.iter().position(|p| p.name == governor)?;
    let values: Vec<Value> = match draft.given.iter().find(|given| given.parameter == row) {
        Some(given) => given.values.iter().map(|(value, _)| *value).collect(),
        None => match table[row].default {
            Default::Is(value) => vec![value],
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
