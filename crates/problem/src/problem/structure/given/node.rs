//! Nodes of a structure by their names, and their numbers in a case.

use super::amount::Amount;
use super::rows::{RowNumber, Rows};
use crate::problem::Violation;
use crate::system::reduction::Reduced;
use crate::system::structure::Direction;
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
    /// A support that moves in a direction, by its place among all of them.
    Support(usize),
}

/// The node that does not move.
pub const GROUND: &str = "ground";

/// Numbers of the nodes in a case: the masses, then the bars with their nodes from left to right, then the rows of matrices that
/// belong to no support and, if they are reduced, their modes. The supports that move follow the nodes.
#[derive(Debug, Clone)]
pub struct Numbering {
    masses: usize,
    /// Number of elements of each bar.
    elements: Vec<u32>,
    /// How many elements an element of the study is divided into.
    finer: u32,
    /// The rows of each of the matrices.
    rows: Vec<RowsInCase>,
}

/// The nodes that matrices have in a case.
#[derive(Debug, Clone)]
pub enum RowsInCase {
    /// All rows but those of supports.
    All(Arc<Rows>),
    /// Some rows and modes of a reduction.
    Kept {
        /// What the rows are.
        rows: Arc<Rows>,
        /// The rows that are kept and belong to no support; they rise.
        nodes: Vec<usize>,
        /// Number of modes.
        modes: usize,
    },
}

impl RowsInCase {
    /// These kept rows and so many modes of matrices with these rows.
    pub fn kept(rows: &Arc<Rows>, kept: &[usize], modes: usize) -> RowsInCase {
        let is_node = |row: &usize| matches!(rows.number(*row), RowNumber::Free(_));
        RowsInCase::Kept {
            rows: rows.clone(),
            nodes: kept.iter().copied().filter(is_node).collect(),
            modes,
        }
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        match self {
            RowsInCase::All(rows) => rows.free(),
            RowsInCase::Kept { nodes, modes, .. } => nodes.len() + modes,
        }
    }

    /// What a row is.
    ///
    /// # Errors
    /// A reduction leaves it out.
    fn number(&self, row: usize) -> Result<RowNumber, String> {
        match self {
            RowsInCase::All(rows) => Ok(rows.number(row)),
            RowsInCase::Kept { rows, nodes, .. } => match rows.number(row) {
                RowNumber::Free(_) => match nodes.binary_search(&row) {
                    Ok(index) => Ok(RowNumber::Free(index)),
                    Err(_) => Err("the reduction leaves this dof out".to_owned()),
                },
                other @ (RowNumber::Support(_) | RowNumber::Fixed) => Ok(other),
            },
        }
    }
}

impl Numbering {
    /// The numbering of `masses` masses and bars of so many elements, each divided into `finer` ones. Inner nodes keep their
    /// places along the bar.
    pub fn new(masses: usize, elements: Vec<u32>, finer: u32, rows: Vec<RowsInCase>) -> Numbering {
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
        let before = self.rows[..matrices].iter().map(RowsInCase::nodes);
        self.first(self.elements.len()) + before.sum::<usize>()
    }

    /// Number of a row of matrices: of a node or, after all nodes, of a support; `None` for a row that does not move.
    pub fn row(&self, matrices: usize, row: usize) -> Option<usize> {
        let number = self.rows[matrices].number(row).ok()?;
        self.of_row(matrices, number)
    }

    /// The nodes of the kept rows and the modes of reduced matrices; `None` for a row of a support.
    pub fn coordinates(&self, matrices: usize, reduced: &Reduced) -> Vec<Option<usize>> {
        let nodes = self.nodes();
        let kept = reduced.kept().iter().map(|row| {
            let node = self.row(matrices, *row);
            node.filter(|node| *node < nodes)
        });
        let end = self.first_row(matrices + 1);
        let modes = (end - reduced.modes()..end).map(Some);
        kept.chain(modes).collect()
    }

    fn of_row(&self, matrices: usize, number: RowNumber) -> Option<usize> {
        match number {
            RowNumber::Free(index) => Some(self.first_row(matrices) + index),
            RowNumber::Support(support) => Some(self.nodes() + support),
            RowNumber::Fixed => None,
        }
    }

    /// Number of the left node of a bar.
    pub fn first(&self, bar: usize) -> usize {
        let before = self.elements[..bar].iter();
        self.masses + before.map(|n| *n as usize + 1).sum::<usize>()
    }

    /// The nodes at the left and right end of an element of a bar, from 1 on.
    ///
    /// # Errors
    /// The bar has no such element.
    pub fn element(&self, bar: usize, element: u32) -> Result<[usize; 2], String> {
        let count = self.elements[bar] / self.finer;
        if element < 1 || element > count {
            return Err(format!("the bar has elements 1 to {count}, got {element}"));
        }
        let node = |i: u32| self.first(bar) + (i * self.finer) as usize;
        Ok([node(element - 1), node(element)])
    }

    /// Number of a node; `None` for the ground. Those of supports follow the nodes.
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
                Ok(self.of_row(matrices, self.rows[matrices].number(row)?))
            }
            NodeRef::Support(support) => Ok(Some(self.nodes() + support)),
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

/// A dof of matrices that is a sum of rows, with its factor.
#[derive(Debug, Clone)]
pub struct TiedDof {
    /// The place of the matrices.
    pub matrices: usize,
    /// The name of its node.
    pub node: String,
    /// Its direction.
    pub direction: Direction,
    /// Its factor.
    pub factor: Amount,
}
