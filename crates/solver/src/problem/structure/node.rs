//! Nodes of a structure by their names, and their numbers in a case.

use crate::problem::Violation;

/// A node as the study names it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NodeName {
    /// Which node.
    pub node: NodeRef,
    /// Byte offset and path of the name in the study.
    pub at: usize,
    /// See `at`.
    pub path: String,
}

/// A node that exists for every number of elements, or an inner node of a bar.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NodeRef {
    /// The ground, which does not move.
    Ground,
    /// A lumped mass, by its place in the list.
    Mass(usize),
    /// The left end of a bar, by its place in the list.
    Left(usize),
    /// The right end of a bar.
    Right(usize),
    /// Node i of a bar, from 1 to n - 1.
    Inner(usize, u32),
}

impl NodeRef {
    /// The node with this name among masses and bars; `None` if there is none.
    pub fn parse(name: &str, masses: &[&str], bars: &[&str]) -> Option<NodeRef> {
        if name == GROUND {
            return Some(NodeRef::Ground);
        }
        if let Some(mass) = masses.iter().position(|mass| *mass == name) {
            return Some(NodeRef::Mass(mass));
        }
        let (bar, place) = name.split_once('.')?;
        let bar = bars.iter().position(|known| *known == bar)?;
        match place {
            "left" => Some(NodeRef::Left(bar)),
            "right" => Some(NodeRef::Right(bar)),
            _ => {
                let digits = place.bytes().all(|c| c.is_ascii_digit()) && !place.starts_with('0');
                let inner = place.parse().ok().filter(|_| digits)?;
                Some(NodeRef::Inner(bar, inner))
            }
        }
    }
}

/// The node that does not move.
pub const GROUND: &str = "ground";

/// Numbers of the nodes in a case: the masses, then the bars with their nodes from left to right.
#[derive(Debug, Clone)]
pub struct Numbering {
    masses: usize,
    /// Number of elements of each bar.
    elements: Vec<u32>,
    /// How many elements an element of the study is divided into.
    finer: u32,
}

impl Numbering {
    /// The numbering of `masses` masses and bars of so many elements, each divided into `finer` ones. Inner nodes keep their
    /// places along the bar.
    pub fn new(masses: usize, elements: Vec<u32>, finer: u32) -> Numbering {
        let elements = elements.iter().map(|n| n * finer).collect();
        Numbering {
            masses,
            elements,
            finer,
        }
    }

    /// Number of elements of each bar.
    pub fn elements(&self) -> &[u32] {
        &self.elements
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.first(self.elements.len())
    }

    /// Number of the left node of a bar.
    pub fn first(&self, bar: usize) -> usize {
        let before = self.elements[..bar].iter();
        self.masses + before.map(|n| *n as usize + 1).sum::<usize>()
    }

    /// Number of a node; `None` for the ground.
    ///
    /// # Errors
    /// The bar has no such inner node.
    pub fn of(&self, name: &NodeName) -> Result<Option<usize>, Violation> {
        self.find(name.node).map_err(|message| Violation {
            parameter: name.path.clone().into(),
            message,
            at: Some(name.at),
        })
    }

    /// The same for a node without its place.
    pub fn find(&self, node: NodeRef) -> Result<Option<usize>, String> {
        match node {
            NodeRef::Ground => Ok(None),
            NodeRef::Mass(mass) => Ok(Some(mass)),
            NodeRef::Left(bar) => Ok(Some(self.first(bar))),
            NodeRef::Right(bar) => Ok(Some(self.first(bar) + self.elements[bar] as usize)),
            NodeRef::Inner(bar, i) if i >= 1 && i < self.elements[bar] / self.finer => {
                Ok(Some(self.first(bar) + (i * self.finer) as usize))
            }
            NodeRef::Inner(bar, i) => Err(match self.elements[bar] / self.finer {
                1 => format!("the bar has one element and no inner node, got {i}"),
                n => format!("the bar has inner nodes 1 to {}, got {i}", n - 1),
            }),
        }
    }
}
