//! What all parts of a structure are decoded with: the parameters of the study, the names of nodes, and the folder of records.

use super::keys::{Keys, names};
use crate::source::faults::{Faults, in_words, quoted, unknown};
use crate::source::object::Object;
use crate::source::tree::{Node, Tree};
use crate::value::{number, text, with_unit};
use slipgap_solver::expression::Formula;
use slipgap_solver::problem::ParameterExpression;
use slipgap_solver::problem::parameter::{Parameter, Range};
use slipgap_solver::problem::structure::amount::{Amount, Source};
use slipgap_solver::problem::structure::node::{NodeName, NodeRef};
use std::cell::RefCell;
use std::collections::BTreeSet;
use std::path::Path;
use std::sync::Arc;

/// The surroundings of a value in a structure.
pub(super) struct Reader<'a> {
    /// The parameters of the study.
    pub table: &'a [Parameter],
    /// Names of the masses.
    pub masses: Vec<String>,
    /// Names of the bars.
    pub bars: Vec<String>,
    /// The study's unit of length in m.
    pub metre: f64,
    /// Folder of the study.
    pub folder: &'a Path,
    /// Rows of the parameters that the structure contains.
    pub used: RefCell<BTreeSet<usize>>,
    /// Records whose mean is removed without a key that says so, with this mean.
    pub removed_means: RefCell<Vec<(String, String)>>,
    /// The bytes of the records, for the identity of the structure.
    pub records: RefCell<Vec<(String, Vec<u8>)>>,
}

impl Reader<'_> {
    /// A number, plain or as an expression of parameters.
    pub fn amount(
        &self,
        node: &Node,
        path: &str,
        range: Range,
        faults: &mut Faults,
    ) -> Option<Amount> {
        let source = match &node.tree {
            Tree::Text(text) => match Formula::number(text, self.table) {
                Ok(formula) if !formula.uses().is_empty() => {
                    self.used.borrow_mut().extend(formula.uses());
                    Source::Expression(Arc::new(ParameterExpression {
                        formula,
                        text: text.clone(),
                    }))
                }
                Ok(_) => Source::Number(number(node, path, range, faults)?),
                Err(fault) => {
                    let what = with_unit(text, None).unwrap_or_else(|| in_words(&fault));
                    faults.add(node.at, path, format!("{}: {what}", quoted(text)));
                    return None;
                }
            },
            _ => Source::Number(number(node, path, range, faults)?),
        };
        Some(Amount {
            source,
            range,
            at: node.at,
            path: path.to_owned(),
        })
    }

    /// The number under `key`, if it is given.
    pub fn optional(
        &self,
        object: &Object,
        key: &str,
        range: Range,
        faults: &mut Faults,
    ) -> Option<Amount> {
        let node = object.get(key)?;
        self.amount(node, &object.path(key), range, faults)
    }

    /// The number under `key` of these keys. If it is missing, that is a fault.
    pub fn needed(
        &self,
        object: &Object,
        keys: Keys,
        key: &str,
        range: Range,
        faults: &mut Faults,
    ) -> Option<Amount> {
        let what = keys.iter().find(|known| known.0 == key);
        let node = object.need(key, what.map_or("", |known| known.1), faults)?;
        self.amount(node, &object.path(key), range, faults)
    }

    /// A node by its name.
    pub fn node(&self, node: &Node, path: &str, faults: &mut Faults) -> Option<NodeName> {
        let name = text(node, path, faults)?;
        let masses: Vec<&str> = self.masses.iter().map(String::as_str).collect();
        let bars: Vec<&str> = self.bars.iter().map(String::as_str).collect();
        if let Some(found) = NodeRef::parse(&name, &masses, &bars) {
            return Some(NodeName {
                node: found,
                at: node.at,
                path: path.to_owned(),
            });
        }
        let ends = bars
            .iter()
            .flat_map(|bar| [format!("{bar}.left"), format!("{bar}.right")]);
        let ends: Vec<String> = ends.collect();
        let known = ["ground"].into_iter().chain(masses.iter().copied());
        let known: Vec<&str> = known.chain(ends.iter().map(String::as_str)).collect();
        faults.add(node.at, path, unknown("node", &name, &known));
        None
    }

    /// A node other than the ground.
    pub fn moving(&self, node: &Node, path: &str, faults: &mut Faults) -> Option<NodeName> {
        let name = self.node(node, path, faults)?;
        if name.node == NodeRef::Ground {
            let message = "the ground does not move; give its acceleration under \"ground\"";
            faults.add(node.at, path, message);
            return None;
        }
        Some(name)
    }

    /// Two different nodes.
    pub fn between(
        &self,
        object: &Object,
        what: &str,
        faults: &mut Faults,
    ) -> Option<[NodeName; 2]> {
        let node = object.need("between", "two nodes", faults)?;
        let path = object.path("between");
        let Tree::List(items) = &node.tree else {
            faults.must_be(node, &path, "a list of two nodes");
            return None;
        };
        let [i, j] = &items[..] else {
            faults.must_be(node, &path, "a list of two nodes");
            return None;
        };
        // Both are decoded, so that every fault is reported.
        let first = self.node(i, &format!("{path}[0]"), faults);
        let second = self.node(j, &format!("{path}[1]"), faults);
        let (first, second) = (first?, second?);
        if first.node == second.node {
            let message = format!("{what} needs two different nodes, got one twice");
            faults.add(node.at, &path, message);
            return None;
        }
        Some([first, second])
    }
}

/// The object at a node with these keys.
pub(super) fn open<'a>(
    node: &'a Node,
    path: &str,
    keys: Keys,
    faults: &mut Faults,
) -> Option<Object<'a>> {
    Object::open(node, path, &names(keys), faults)
}

/// Whether a text is a name: letters, digits and _, not beginning with a digit.
pub(super) fn is_name(text: &str) -> bool {
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '_';
    text.chars().all(plain) && text.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
}

/// The members of an object of named parts, each name once; several names before one part are separated by `|`.
pub(super) fn named<'a>(
    node: &'a Node,
    path: &str,
    what: &str,
    taken: &mut Vec<String>,
    faults: &mut Faults,
) -> Vec<(String, &'a Node, String)> {
    let Tree::Object(members) = &node.tree else {
        faults.must_be(node, path, &format!("an object with a key for each {what}"));
        return Vec::new();
    };
    let mut found = Vec::new();
    for member in members.iter().filter(|member| member.key != "//") {
        let path = crate::source::faults::join(path, &member.key);
        for name in member.key.split('|').map(str::trim) {
            if !is_name(name) || name == "ground" {
                let message = format!(
                    "{} cannot name a {what}; a name is letters, digits and _, and not \"ground\"",
                    quoted(name)
                );
                faults.add(member.at, &path, message);
            } else if taken.iter().any(|other| other == name) {
                let message = format!("{} is the name of another part", quoted(name));
                faults.add(member.at, &path, message);
            } else {
                taken.push(name.to_owned());
                found.push((name.to_owned(), &member.node, path.clone()));
            }
        }
    }
    found
}
