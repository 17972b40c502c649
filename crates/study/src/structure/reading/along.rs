//! The nodes of springs and contacts with their factors.

use super::reader::Reader;
use crate::source::faults::{Faults, join, quoted};
use crate::source::object::Object;
use crate::source::tree::Node;
use crate::value::text;
use slipgap_problem::problem::ParameterExpression;
use slipgap_problem::problem::expression::Formula;
use slipgap_problem::problem::numbers::parameter::Range;
use slipgap_problem::problem::structure::given::amount::{Amount, Source};
use slipgap_problem::problem::structure::given::node::{NodeName, NodeRef};
use slipgap_problem::problem::structure::parts::along::Term;
use slipgap_system::system::structure::Direction;
use std::sync::Arc;

/// What moves at one side, each node with its factor, and its terms.
pub(in crate::structure) type Side = (Vec<(f64, NodeRef)>, Vec<Term>);

impl Reader<'_> {
    /// The nodes of a spring or a contact with their factors: two nodes under `between`, -1 and 1, or nodes with factors under
    /// `along`. A support without a direction moves in the one of the object.
    pub fn along(&self, object: &Object, what: &str, faults: &mut Faults) -> Option<Vec<Term>> {
        let direction = match object.get("direction") {
            Some(_) => Some(self.direction(object, faults)?),
            None => None,
        };
        if let Some(node) = object.get("along") {
            if object.get("between").is_some() {
                let message = "give between or along, not both";
                faults.add(node.at, &object.path("along"), message);
                return None;
            }
            return self.factors(node, &object.path("along"), (what, direction), faults);
        }
        self.between(object, (what, direction), faults)
    }

    /// The name of a node with this direction behind it, if it is that of a support.
    fn in_direction(
        &self,
        name: &str,
        direction: Option<Direction>,
        (at, path): (usize, &str),
        faults: &mut Faults,
    ) -> Option<String> {
        let Some(direction) =
            direction.filter(|_| !name.contains('.') && self.names.is_support(name))
        else {
            return Some(name.to_owned());
        };
        let full = format!("{name}.{}", direction.name());
        if self.names.motion(name, direction).is_none() {
            let message = format!(
                "{name} does not move in {}; the node {} is held there",
                direction.name(),
                quoted(&full)
            );
            faults.add(at, path, message);
            return None;
        }
        Some(full)
    }

    /// The members of an object of nodes and factors.
    fn factors(
        &self,
        node: &Node,
        path: &str,
        (what, direction): (&str, Option<Direction>),
        faults: &mut Faults,
    ) -> Option<Vec<Term>> {
        let Some(members) = node.object() else {
            faults.must_be(node, path, "an object with a factor for each node");
            return None;
        };
        let before = faults.count();
        let members = members.iter().filter(|member| member.key != "//");
        let terms = members.filter_map(|member| {
            let path = join(path, &member.key);
            let factor = self.amount(&member.node, &path, Range::Any, faults);
            let name = self.in_direction(&member.key, direction, (member.at, &path), faults)?;
            let nodes = self.named_nodes(&name, member.at, &path, faults);
            Some(self.terms(&name, nodes?, &factor?))
        });
        let terms: Vec<Term> = terms.flatten().collect();
        if faults.count() == before && terms.iter().all(|term| term.node.node == NodeRef::Ground) {
            faults.add(node.at, path, format!("{what} needs a node that moves"));
        }
        (faults.count() == before).then_some(terms)
    }

    /// The terms of the nodes of a name with this factor.
    fn terms(&self, name: &str, nodes: Vec<(f64, NodeName)>, factor: &Amount) -> Vec<Term> {
        let tied = self.names.tied(name, factor).map(Arc::new);
        let terms = nodes.into_iter().map(|(weight, node)| Term {
            node,
            factor: match tied {
                Some(_) => self.times(factor, weight),
                None => factor.clone(),
            },
            tied: tied.clone(),
        });
        terms.collect()
    }

    /// An amount times a number.
    fn times(&self, amount: &Amount, factor: f64) -> Amount {
        let source = match &amount.source {
            Source::Number(x) => Source::Number(x * factor),
            Source::Expression(expression) => {
                let text = format!("({factor:?})*({})", expression.text);
                match Formula::number(&text, self.table) {
                    Ok(formula) => {
                        Source::Expression(Arc::new(ParameterExpression { formula, text }))
                    }
                    // Of a formula that was read before, none.
                    Err(_) => amount.source.clone(),
                }
            }
        };
        Amount {
            source,
            ..amount.clone()
        }
    }

    /// A node with its factor: what moves, and its terms.
    pub(in crate::structure) fn side(
        &self,
        name: &str,
        (at, path): (usize, String),
        factor: f64,
        faults: &mut Faults,
    ) -> Option<Side> {
        let nodes = self.named_nodes(name, at, &path, faults)?;
        let factor = Amount {
            source: Source::Number(factor),
            range: Range::Any,
            at,
            path,
        };
        let motion: Vec<_> = nodes
            .iter()
            .map(|(weight, name)| (*weight, name.node))
            .collect();
        Some((motion, self.terms(name, nodes, &factor)))
    }

    /// Two different nodes with the factors -1 and 1.
    fn between(
        &self,
        object: &Object,
        (what, direction): (&str, Option<Direction>),
        faults: &mut Faults,
    ) -> Option<Vec<Term>> {
        let wanted = "two nodes; or along, nodes with their factors";
        let node = object.need("between", wanted, faults)?;
        let path = object.path("between");
        let Some([i, j]) = node.list() else {
            faults.must_be(node, &path, "a list of two nodes");
            return None;
        };
        // Both are decoded, so that every fault is reported.
        let mut side = |node: &Node, index: usize, factor: f64| {
            let path = format!("{path}[{index}]");
            let given = text(node, &path, faults)?;
            let name = self.in_direction(&given, direction, (node.at, &path), faults)?;
            self.side(&name, (node.at, path), factor, faults)
        };
        let (first, second) = (side(i, 0, -1.0), side(j, 1, 1.0));
        let ((first, mut terms), (second, others)) = (first?, second?);
        if first == second {
            let message = format!("{what} needs two different nodes, got one twice");
            faults.add(node.at, &path, message);
            return None;
        }
        terms.extend(others);
        Some(terms)
    }
}
