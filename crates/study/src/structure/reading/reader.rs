//! What all parts of a structure are decoded with: the parameters of the study, the names of nodes, and the folder of records.

use crate::source::faults::{Faults, in_words, quoted, unknown};
use crate::source::folder::Folder;
use crate::source::object::Object;
use crate::source::tree::{Node, Tree};
use crate::structure::identity::Records;
use crate::value::{number, with_unit};
use slipgap_problem::problem::ParameterExpression;
use slipgap_problem::problem::expression::Formula;
use slipgap_problem::problem::numbers::parameter::{Parameter, Range};
use slipgap_problem::problem::structure::channels::names::Names;
use slipgap_problem::problem::structure::given::amount::{Amount, Source};
use slipgap_problem::problem::structure::given::node::{NodeName, NodeRef};
use slipgap_problem::problem::structure::given::scale_to::ScaleTo;
use slipgap_problem::problem::structure::given::strength::Strengths;
use slipgap_problem::problem::structure::parts::template::Moved;
use slipgap_system::system::loads::record::Heading;
use slipgap_system::system::structure::Direction;
use std::cell::RefCell;
use std::collections::{BTreeSet, HashSet};
use std::sync::Arc;

/// A named part with its value in the study.
pub(in crate::structure) type Part<'a> = (String, &'a Node, String);

/// The strength that motions of the ground get, and the pair that gets it.
pub(in crate::structure) type OfGround = (Arc<ScaleTo>, Option<Arc<dyn Strengths>>);

/// The surroundings of a value in a structure.
pub(in crate::structure) struct Reader<'a> {
    /// The whole study.
    pub root: &'a Node,
    /// The parameters of the study.
    pub table: &'a [Parameter],
    /// Names of the parts.
    pub names: Names,
    /// The study's units as it has them; empty if it names none.
    pub units: String,
    /// The study's unit of length in m.
    pub metre: f64,
    /// Folder of the study.
    pub folder: &'a Folder<'a>,
    /// Rows of the parameters that the structure contains.
    pub used: RefCell<BTreeSet<usize>>,
    /// Records whose mean is removed without a key that says so, with this mean.
    pub removed_means: RefCell<Vec<(String, String)>>,
    /// Files that begin before t = 0, with what is not used and how to use it.
    pub early: RefCell<Vec<(String, String)>>,
    /// Records whose headers say otherwise than their numbers, with the first doubt.
    pub doubts: RefCell<Vec<(String, String)>>,
    /// What the headers of the records name.
    pub headings: RefCell<Vec<(String, Heading)>>,
    /// The strength of the ground for other motions, if it has one.
    pub of_ground: RefCell<Option<OfGround>>,
    /// The records and matrices, for the identity of the structure.
    pub records: RefCell<Records>,
}

impl<'a> Reader<'a> {
    /// The surroundings of a study without names of parts and units.
    pub fn plain(root: &'a Node, table: &'a [Parameter], folder: &'a Folder<'a>) -> Reader<'a> {
        Reader {
            root,
            table,
            names: Names::default(),
            units: String::new(),
            metre: 1.0,
            folder,
            used: Default::default(),
            records: Default::default(),
            removed_means: Default::default(),
            early: Default::default(),
            doubts: Default::default(),
            headings: Default::default(),
            of_ground: Default::default(),
        }
    }
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
            Tree::Object(_) | Tree::List(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => {
                Source::Number(number(node, path, range, faults)?)
            }
        };
        Some(Amount {
            source,
            range,
            at: node.at,
            path: path.to_owned(),
        })
    }

    /// The number under `key`. If it is missing but needed, that is a fault.
    pub fn number(&self, object: &Object, key: &str, faults: &mut Faults) -> Option<Amount> {
        let (node, path) = object.given(key, faults)?;
        self.amount(node, &path, object.range(key), faults)
    }

    /// The number under `key`, which other keys of the object need. If it is missing, that is a fault.
    pub fn needed(&self, object: &Object, key: &str, faults: &mut Faults) -> Option<Amount> {
        object.needed(key, faults)?;
        self.number(object, key, faults)
    }

    /// The nodes of which the motion of a name at a place of the study is the sum, each with its factor.
    pub fn named_nodes(
        &self,
        name: &str,
        at: usize,
        path: &str,
        faults: &mut Faults,
    ) -> Option<Vec<(f64, NodeName)>> {
        let Some(nodes) = self.names.nodes(name) else {
            faults.add(at, path, self.no_node(name));
            return None;
        };
        let path = path.to_owned();
        let named = nodes.into_iter().map(|(factor, node)| {
            let path = path.clone();
            (factor, NodeName { node, at, path })
        });
        Some(named.collect())
    }

    /// Why there is no node with this name.
    pub fn no_node(&self, name: &str) -> String {
        if let Some(why) = self.names.why_no_dof(name) {
            return format!("no node {}: {why}", quoted(name));
        }
        let of_matrices = self.names.matrices.iter();
        let mut with_part = of_matrices.filter(|(_, imported)| imported.dofs.row(name).is_some());
        if let Some((part, _)) = with_part.next() {
            let full = quoted(&format!("{part}.{name}"));
            return format!("unknown node {}, did you mean {full}?", quoted(name));
        }
        let bars = self.names.bars.iter();
        let of_bars = bars.flat_map(|bar| [format!("{bar}.left"), format!("{bar}.right")]);
        let ends: Vec<String> = of_bars.collect();
        let masses = self.names.masses.iter().map(String::as_str);
        let supports = self.names.supports.iter().map(|support| support.0.as_str());
        let nodes = ["ground"].into_iter().chain(supports).chain(masses);
        let known: Vec<&str> = nodes.chain(ends.iter().map(String::as_str)).collect();
        unknown("node", name, &known)
    }

    /// What a name at a place of the study moves: a node other than the ground, all nodes of a bar, or all rows of matrices of a
    /// direction, such as `tower.x`.
    pub fn moved(&self, name: &str, at: usize, path: &str, faults: &mut Faults) -> Option<Moved> {
        if let Some(bar) = self.names.bar(name) {
            return Some(Moved::Bar(bar));
        }
        if let Some((part, direction)) = name.split_once('.')
            && let Some(matrices) = self.names.matrices(part)
            && let Some(direction) = Direction::named(direction)
        {
            let forces = self.names.matrices[matrices].1.dofs.forces(direction);
            if forces.iter().all(|force| *force == 0.0) {
                let message = format!("{part} has no dof of direction {}", direction.name());
                faults.add(at, path, message);
                return None;
            }
            return Some(Moved::Rows(matrices, direction));
        }
        if self.names.is_support(name) {
            let message = "a support moves as \"supports\" says";
            faults.add(at, path, message);
            return None;
        }
        let mut nodes = self.named_nodes(name, at, path, faults)?;
        if nodes.iter().all(|(_, name)| name.node == NodeRef::Ground) {
            let message = "the ground does not move; give its acceleration under \"ground\"";
            faults.add(at, path, message);
            return None;
        }
        match self.names.node(name) {
            Some(_) => nodes.pop().map(|(_, node)| Moved::Node(node)),
            None => Some(Moved::Tied(nodes)),
        }
    }

    /// The direction under `direction`; x without it.
    pub fn direction(&self, object: &Object, faults: &mut Faults) -> Option<Direction> {
        match object.get("direction") {
            Some(_) => object.choice("direction", &Direction::TRANSLATIONS, faults),
            None => Some(Direction::X),
        }
    }
}

/// Whether a text is a name: letters, digits and _, not beginning with a digit.
pub(in crate::structure) fn is_name(text: &str) -> bool {
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '_';
    text.chars().all(plain) && text.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
}

/// The members of an object of named parts, each name once; several names before one part are separated by `|`.
pub(in crate::structure) fn named<'a>(
    node: &'a Node,
    path: &str,
    what: &str,
    taken: &mut HashSet<String>,
    faults: &mut Faults,
) -> Vec<(String, &'a Node, String)> {
    let Some(members) = node.object() else {
        faults.must_be(node, path, &format!("an object with a key for each {what}"));
        return Vec::new();
    };
    let mut found = Vec::new();
    for member in members.iter().filter(|member| member.key != "//") {
        let path = crate::source::faults::join(path, &member.key);
        for name in member.key.split('|').map(str::trim) {
            if take_name(name, what, (member.at, &path), taken, faults) {
                found.push((name.to_owned(), &member.node, path.clone()));
            }
        }
    }
    found
}

/// Takes a name for a part, or reports that it is no name or that of another part.
pub(in crate::structure) fn take_name(
    name: &str,
    what: &str,
    (at, path): (usize, &str),
    taken: &mut HashSet<String>,
    faults: &mut Faults,
) -> bool {
    if !is_name(name) || name == "ground" {
        let message = format!(
            "{} cannot name a {what}; a name is letters, digits and _, and not \"ground\"",
            quoted(name)
        );
        faults.add(at, path, message);
        return false;
    }
    let is_new = taken.insert(name.to_owned());
    if !is_new {
        let message = format!("{} is the name of another part", quoted(name));
        faults.add(at, path, message);
    }
    is_new
}
