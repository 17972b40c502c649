//! Nodes of a structure by their names, and their numbers in a case.

use crate::problem::Violation;
use std::sync::Arc;

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
    /// A row of matrices, by their place in the list.
    Dof(usize, usize),
}

/// The node that does not move.
pub const GROUND: &str = "ground";

/// Numbers of the nodes in a case: the masses, then the bars with their nodes from left to right, then the rows of matrices and, if they are reduced,
/// their modes.
#[derive(Debug, Clone)]
pub struct Numbering {
    masses: usize,
    /// Number of elements of each bar.
    elements: Vec<u32>,
    /// How many elements an element of the study is divided into.
    finer: u32,
    /// Rows of each of the matrices.
    rows: Vec<Rows>,
}

/// The nodes that matrices have in a case.
#[derive(Debug, Clone)]
pub enum Rows {
    /// All rows, so many.
    All(usize),
    /// These rows, which rise, and so many modes.
    Kept(Arc<[usize]>, usize),
}

impl Rows {
    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        match self {
            Rows::All(rows) => *rows,
            Rows::Kept(kept, modes) => kept.len() + modes,
        }
    }

    /// The place of a row among the nodes.
    fn place(&self, row: usize) -> Result<usize, String> {
        match self {
            Rows::All(_) => Ok(row),
            Rows::Kept(kept, _) => {
                let place = kept.binary_search(&row);
                place.map_err(|_| "the reduction leaves this dof out".to_owned())
            }
        }
    }
}

impl Numbering {
    /// The numbering of `masses` masses and bars of so many elements, each divided into `finer` ones. Inner nodes keep their
    /// places along the bar.
    pub fn new(masses: usize, elements: Vec<u32>, finer: u32, rows: Vec<Rows>) -> Numbering {
        let elements = elements.iter().map(|n| n * finer).collect();
        Numbering {
            masses,
            elements,
            finer,
            rows,
        }
    }

    /// Number of elements of each bar.
    pub fn elements(&self) -> &[u32] {
        &self.elements
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.first_row(self.rows.len())
    }

    /// Number of the first row of matrices, by their place in the list.
    pub fn first_row(&self, matrices: usize) -> usize {
        let before = self.rows[..matrices].iter();
        self.first(self.elements.len()) + before.map(Rows::nodes).sum::<usize>()
    }

    /// The place of a row among the nodes of its matrices; `None` if a reduction leaves it out.
    pub fn place(&self, matrices: usize, row: usize) -> Option<usize> {
        self.rows[matrices].place(row).ok()
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
            NodeRef::Dof(matrices, row) => {
                let place = self.rows[matrices].place(row)?;
                Ok(Some(self.first_row(matrices) + place))
            }
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
