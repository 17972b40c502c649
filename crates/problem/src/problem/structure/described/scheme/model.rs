//! Matrices of another program as data for a picture: places of nodes, and which of them K couples.

use crate::system::import::{Dofs, Imported};
use crate::system::structure::Direction;
use std::collections::{BTreeSet, HashMap};

/// Entries of K below this part of the diagonal entries of their rows are round-off.
const ROUND_OFF: f64 = 1e-12;

/// Sums of K below this part of their terms are round-off, or digits that a file leaves out.
const HELD: f64 = 1e-6;

/// Nodes of matrices and their couplings.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Model {
    /// X, Y, Z of each node, in the order of the first rows of the nodes; empty if the file has no places.
    pub nodes: Vec<[f64; 3]>,
    /// Name of each of these nodes.
    pub names: Vec<String>,
    /// Pairs of nodes, the first one below the second, with an entry of K that is not 0, in rising order; empty without places.
    pub couplings: Vec<[usize; 2]>,
    /// Whether K holds each node to the ground: a motion of all nodes by 1 in some direction has a force there. Empty without places.
    pub held: Vec<bool>,
    /// The degrees of freedom that springs, contacts and loads name, each once.
    pub interface: Vec<Named>,
}

/// A degree of freedom that a study names.
#[derive(Debug, Clone, PartialEq)]
pub struct Named {
    /// Its name without that of its matrices, such as `7.x`.
    pub name: String,
    /// Its node, from 0.
    pub node: usize,
    /// Its direction.
    pub direction: Direction,
}

/// The node of each row, numbered in the order of their first rows, and the number of nodes.
pub fn nodes_of_rows(dofs: &Dofs) -> (Vec<usize>, usize) {
    let mut known: HashMap<&str, usize> = HashMap::new();
    let mut nodes = Vec::with_capacity(dofs.len());
    for dof in dofs.rows() {
        let next = known.len();
        nodes.push(*known.entry(&dof.node).or_insert(next));
    }
    let count = known.len();
    (nodes, count)
}

impl Model {
    /// The nodes of matrices, without an interface. `nodes` has the node of each row.
    pub fn new(imported: &Imported, nodes: &[usize], count: usize) -> Model {
        let mut places = vec![None; count];
        for (dof, node) in imported.dofs.rows().iter().zip(nodes) {
            places[*node] = places[*node].or(dof.at);
        }
        let Some(places) = places.into_iter().collect::<Option<Vec<_>>>() else {
            return Model::default();
        };
        let mut diagonal = vec![0.0; nodes.len()];
        for ((i, j), value) in imported.stiffness.entries() {
            if i == j {
                diagonal[i] = value.abs();
            }
        }
        let couples = |((i, j), value): ((usize, usize), f64)| {
            let least = ROUND_OFF * (diagonal[i] * diagonal[j]).sqrt();
            let [a, b] = [nodes[i], nodes[j]];
            (a != b && value.abs() > least).then_some([a.min(b), a.max(b)])
        };
        let couplings: BTreeSet<[usize; 2]> =
            imported.stiffness.entries().filter_map(couples).collect();
        let mut names = vec![String::new(); count];
        for (dof, node) in imported.dofs.rows().iter().zip(nodes) {
            names[*node] = dof.node.to_string();
        }
        Model {
            held: held(imported, nodes, count),
            nodes: places,
            names,
            couplings: couplings.into_iter().collect(),
            interface: Vec::new(),
        }
    }

    /// The place of a row in the interface, which has it from now on.
    pub fn named(&mut self, dofs: &Dofs, row: usize, node: usize) -> usize {
        let name = dofs.name(row);
        let known = self
            .interface
            .iter()
            .position(|known_node| known_node.name == name);
        known.unwrap_or_else(|| {
            self.interface.push(Named {
                name,
                node,
                direction: dofs.rows()[row].direction,
            });
            self.interface.len() - 1
        })
    }
}

/// Whether each node has a force where all nodes move by 1 in a direction.
fn held(imported: &Imported, nodes: &[usize], count: usize) -> Vec<bool> {
    let mut held = vec![false; count];
    let rows = imported.dofs.rows();
    for direction in Direction::TRANSLATIONS {
        let moves = |row: usize| rows[row].direction == direction;
        let (mut sums, mut sizes) = (vec![0.0; rows.len()], vec![0.0; rows.len()]);
        let mut add = |row: usize, k: f64| {
            sums[row] += k;
            sizes[row] += f64::abs(k);
        };
        for ((i, j), k) in imported.stiffness.entries() {
            if moves(j) && moves(i) {
                add(i, k);
                if i != j {
                    add(j, k);
                }
            }
        }
        for (row, node) in nodes.iter().enumerate() {
            held[*node] |= sums[row].abs() > HELD * sizes[row];
        }
    }
    held
}
