//! Structures with any number of contacts: M u'' + C u' + K u + B S = p(t), r = B^T u + gap.
//!
//! One direction, small motions, lumped masses. B has one column for each contact, with -1 at node I and +1 at node J, so that
//! S resists the opening of the contact: S <= 0 in an impact.

pub mod factor;
mod initial;
pub mod lists;
mod matrix;
mod signal;
mod structure_law;

pub use matrix::Symmetric;
pub use signal::{Signal, Table};
pub use structure_law::{Limit, Pressure, StructureLaw};

use std::sync::Arc;

/// A structure with its contacts, loads and state at t = 0.
#[derive(Debug, Clone)]
pub struct Structure {
    /// Name and mass of each node; all masses are positive.
    pub nodes: Vec<Node>,
    /// K without the contacts.
    pub stiffness: Symmetric,
    /// C without the contacts.
    pub damping: Symmetric,
    /// The contacts.
    pub contacts: Vec<Contact>,
    /// The loads.
    pub loads: Vec<Load>,
    /// u(0) of each node.
    pub displacement: Vec<f64>,
    /// u'(0) of each node.
    pub velocity: Vec<f64>,
}

/// A node: a lumped mass that moves in one direction.
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    /// Its name, such as `p1` or `g1.left`.
    pub name: String,
    /// Its mass, > 0.
    pub mass: f64,
}

/// Forces in a fixed proportion, times one signal.
#[derive(Debug, Clone)]
pub struct Load {
    /// Nodes with the force on each for a signal of 1; -mass for a ground acceleration.
    pub pattern: Vec<(usize, f64)>,
    /// Its course in time.
    pub signal: Arc<Signal>,
}

/// A contact between two nodes, or a node and the ground.
#[derive(Debug, Clone)]
pub struct Contact {
    /// Its name.
    pub name: String,
    /// Nodes I and J; `None` is the ground. r = u_J - u_I + gap.
    pub between: [Option<usize>; 2],
    /// r at rest.
    pub gap: f64,
    /// Its law.
    pub law: StructureLaw,
}

impl Structure {
    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether there is no node.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// Relative displacement or velocity of a contact for displacements or velocities `u` of the nodes, without the gap.
    pub fn relative(&self, contact: usize, u: &[f64]) -> f64 {
        let at = |node: Option<usize>| node.map_or(0.0, |node| u[node]);
        let [i, j] = self.contacts[contact].between;
        at(j) - at(i)
    }

    /// The column of B of a contact: each node with -1 or +1.
    pub fn column(&self, contact: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let [i, j] = self.contacts[contact].between;
        let ends = [i.map(|i| (i, -1.0)), j.map(|j| (j, 1.0))];
        ends.into_iter().flatten()
    }

    /// Adds the loads at time t to `force`.
    pub fn add_loads(&self, t: f64, force: &mut [f64]) {
        for load in &self.loads {
            let value = load.signal.at(t);
            for (node, factor) in &load.pattern {
                force[*node] += factor * value;
            }
        }
    }
}
