//! The `parameters` object of a block: values and axes by the problem's table, and which of them apply.

use super::applies::applies;
use super::design::Design;
use super::expression::Formula;
use super::interval::Interval;
use super::object::Object;
use super::report::quoted;
use super::report::{Faults, join};
use super::spread;
use super::tree::{Node, Tree};
use super::value::{value, with_unit};
use super::{Axis, Group};
use crate::problem::parameter::{Kind, Parameter, Value};

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
    /// Whether they stand in a list or follow a rule.
    pub axis: bool,
    /// In place of values: an expression of other parameters, and its text.
    pub formula: Option<(Formula, String)>,
    /// In place of values, until the design gives them: where they lie.
    pub interval: Option<Interval>,
}

/// The parameters of a block with their places, for the faults that show only later.
pub(super) struct Draft {
    /// Offset of the opening brace.
    pub at: usize,
    pub path: String,
    pub given: Vec<Given>,
    /// Rows of parameters that are given, but with a faulty value: of them nothing further is said.
    pub faulty: Vec<usize>,
    /// Groups of parameters that advance together, by their rows.
    pub zips: Vec<Vec<usize>>,
    /// What combinations must meet, with its offset and text.
    pub when: Option<(Formula, usize, String)>,
    /// The design, where there is one without a fault.
    pub design: Option<Design>,
}

impl Draft {
    /// Number of values of a parameter.
    pub fn count(&self, parameter: usize) -> usize {
        let given = self.given.iter().find(|given| given.parameter == parameter);
        given.map_or(0, |given| given.values.len())
    }

    /// Which of `given` advance together: all with values, each group where its first member stands in the file.
    pub fn groups(&self) -> Vec<Vec<usize>> {
        let sampled = self.design.iter().map(|design| &design.parameters);
        let together: Vec<&Vec<usize>> = self.zips.iter().chain(sampled).collect();
        let mut groups: Vec<Vec<usize>> = Vec::new();
        for (i, given) in self.given.iter().enumerate() {
            if given.formula.is_some() || groups.iter().flatten().any(|member| *member == i) {
                continue;
            }
            let zip = together.iter().find(|zip| zip.contains(&given.parameter));
            let member = |(_, other): &(usize, &Given)| match zip {
                Some(zip) => zip.contains(&other.parameter),
                None => other.parameter == given.parameter,
            };
            let members = self.given.iter().enumerate().filter(member);
            groups.push(members.map(|(i, _)| i).collect());
        }
        groups
    }

    /// The groups without places.
    pub fn axes(&self) -> Vec<Group> {
        let axis = |given: &Given| Axis {
            parameter: given.parameter,
            values: given.values.iter().map(|(value, _)| *value).collect(),
        };
        let group = |members: Vec<usize>| Group {
            axes: members.iter().map(|i| axis(&self.given[*i])).collect(),
        };
        self.groups().into_iter().map(group).collect()
    }
}

/// Decodes a `parameters` object, what is faulty left out; `None` if it is none.
pub(super) fn parameters(
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
            let rule = spread::values(node, path, row, faults)
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
