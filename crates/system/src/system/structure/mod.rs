//! Structures with any number of contacts: M u'' + C u' + K u + B S = p(t), r = B^T u + gap.
//!
//! Small motions, masses lumped or consistent. A node is a degree of freedom. B has one column for each contact: the factors of u
//! in r. Between two nodes they are -1 at node I and +1 at node J, so that S resists the opening of the contact: S <= 0 in an impact.

mod builder;
mod chains;
mod direction;
mod held;
mod inertia;
mod initial;
mod moved;
mod observed;
mod preload;
mod pressed_by;
mod signals;
pub mod sparse;
mod structure_law;
mod support;

pub use crate::system::structure::signals::baseline::{Baseline, NoEnd};
pub use crate::system::structure::signals::motion_pieces::MotionFault;
pub use crate::system::structure::signals::signal::{Signal, Table};
pub use crate::system::structure::signals::support_motion::{Motion, Quantity};
pub use crate::system::structure::sparse::matrix::Symmetric;
pub use builder::{BuildFault, StructureBuilder};
pub use chains::{Chain, InnerNode, Member};
pub use direction::Direction;
pub use inertia::Inertia;
pub use observed::{Elements, Ground, Observed, Reaction, Spring};
pub use preload::Preload;
pub use pressed_by::{PressedBy, PressingSpring};
pub use structure_law::{Limit, PlaneRow, Pressure, StructureLaw};
pub use support::Support;

use std::sync::Arc;

/// A structure with its contacts, loads and state at t = 0.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Structure {
    /// Name and mass of each node.
    pub nodes: Vec<Node>,
    /// M besides its diagonal; no entries for lumped masses.
    pub coupled_mass: Symmetric,
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
    /// The supports that move. With them, u of the nodes is the rest w of their displacement.
    pub supports: Vec<Support>,
    /// Static loads before t = 0.
    pub preload: Preload,
    /// What channels need besides the equations; `None` where no channel does.
    pub observed: Option<Box<Observed>>,
}

/// A node: a degree of freedom.
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    /// Its name, such as `p1` or `g1.left`.
    pub name: String,
    /// Its mass, the entry on the diagonal of M, >= 0.
    pub mass: f64,
    /// Its direction. K u is a sum of differences between nodes of one direction.
    pub direction: Direction,
}

/// Forces in a fixed proportion, times one signal.
#[derive(Debug, Clone)]
pub struct Load {
    /// Nodes with the force on each for a signal of 1; -mass for a ground acceleration.
    pub pattern: Vec<(usize, f64)>,
    /// Its course in time.
    pub signal: Arc<Signal>,
}

/// A contact.
#[derive(Debug, Clone)]
pub struct Contact {
    /// Its name.
    pub name: String,
    /// Its column of B: r is the sum of factor times u of the node, plus the gap.
    pub along: Along,
    /// r at rest.
    pub gap: f64,
    /// Its law.
    pub law: StructureLaw,
}

/// The factors of u in a relative displacement, or in the extension of a spring: each node once.
pub type Along = Vec<(usize, f64)>;

/// -1 at node I and +1 at node J; `None` is the ground.
pub fn between([i, j]: [Option<usize>; 2]) -> Along {
    let ends = [i.map(|i| (i, -1.0)), j.map(|j| (j, 1.0))];
    ends.into_iter().flatten().collect()
}

impl Structure {
    /// These nodes at rest, with nothing between them.
    pub fn new(nodes: Vec<Node>) -> Structure {
        let (size, zeros) = (nodes.len(), vec![0.0; nodes.len()]);
        Structure {
            nodes,
            coupled_mass: Symmetric::zeros(size),
            stiffness: Symmetric::zeros(size),
            damping: Symmetric::zeros(size),
            contacts: Vec::new(),
            loads: Vec::new(),
            displacement: zeros.clone(),
            velocity: zeros,
            supports: Vec::new(),
            preload: Preload::default(),
            observed: None,
        }
    }

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
        let terms = self.column(contact);
        terms.fold(0.0, |sum, (node, factor)| sum + factor * u[node])
    }

    /// The contact alone, or both directions of a contact in a plane.
    pub fn directions_of(&self, contact: usize) -> std::ops::RangeInclusive<usize> {
        match self.contacts[contact].law.row() {
            None => contact..=contact,
            Some(PlaneRow::First) => contact..=contact + 1,
            Some(PlaneRow::Second) => contact - 1..=contact,
        }
    }

    /// The column of B of a contact: nodes with their factors.
    pub fn column(&self, contact: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.contacts[contact].along.iter().copied()
    }

    /// M.
    pub fn mass(&self) -> Symmetric {
        let mut mass = self.coupled_mass.clone();
        for (i, node) in self.nodes.iter().enumerate() {
            mass.add(i, i, node.mass);
        }
        mass
    }

    /// Adds a factor times M to a matrix.
    pub fn add_mass(&self, factor: f64, matrix: &mut Symmetric) {
        for (i, node) in self.nodes.iter().enumerate() {
            matrix.add(i, i, factor * node.mass);
        }
        matrix.add_matrix(&self.coupled_mass, factor);
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
