//! What all cases with equal masses, stiffness, damping, time step, and equal nodes of contacts and loads share.

use super::between::{self, Between};
use super::block_matrix::BlockMatrix;
use super::linear::Linear;
use super::links::{Elimination, Link, links};
use super::massless::{self, Massless};
use super::reduced::{Reduced, flexibility, place_of, places, reduce};
use crate::methods::{AverageAcceleration, Method};
use crate::solve::Unsolvable;
use crate::system::structure::sparse::factor::{Factor, NotPositive};
use crate::system::structure::sparse::lists::Lists;
use crate::system::structure::{Along, Inertia, Load, Structure, Symmetric};

/// Halvings in the search of a step that is short enough, and bisections for three digits of the longest one.
const HALVINGS: i32 = 40;
const BISECTIONS: usize = 12;

/// The linear part of a step, in the order of elimination of its matrix.
///
/// The rows and what follows from them are those of the constant average acceleration method. For the other methods they are empty,
/// and each sub-step has its own linear part.
#[derive(Debug, Clone)]
pub struct Prepared {
    pub(crate) dt: f64,
    pub(crate) method: Method,
    /// The sub-steps of a method other than constant average acceleration.
    pub(crate) sub_steps: Vec<Linear>,
    /// m by place, for these methods.
    pub(crate) mass: Vec<f64>,
    /// M besides its diagonal, by place: over dt^2 for the constant average acceleration method. Empty for lumped masses.
    pub(crate) coupled_mass: Vec<(usize, usize, f64)>,
    /// M^-1 where masses are coupled, for these methods.
    pub(crate) inertia_factor: Option<Inertia>,
    /// Nodes without mass and damping.
    pub(crate) massless: Vec<Massless>,
    /// Nodes between contacts in series.
    pub(crate) between: Vec<Between>,
    /// Place of each node in the order of elimination.
    pub(crate) place: Vec<usize>,
    /// Khat/4 = L D L^T.
    pub(crate) elimination: Elimination,
    /// Couplings of nodes of different directions.
    pub(crate) couplings: Vec<Link>,
    /// m/dt^2 by place.
    pub(crate) inertia: Vec<f64>,
    /// Places of each contact with their factors.
    pub(crate) along: Lists<(usize, f64)>,
    /// L^-1 B by columns, without zeros.
    pub(crate) reduced: Lists<Reduced>,
    /// H = B^T Khat^-1 B.
    pub(crate) flexibility: BlockMatrix,
    key: Key,
}

/// What a prepared structure depends on.
#[derive(Debug, Clone, PartialEq)]
struct Key {
    masses: Vec<f64>,
    stiffness: Symmetric,
    damping: Symmetric,
    coupled_mass: Symmetric,
    along: Vec<Along>,
    /// Nodes with loads.
    loads: Vec<Vec<usize>>,
}

impl Prepared {
    /// Prepares steps of `dt` by the constant average acceleration method.
    ///
    /// # Errors
    /// [`Unsolvable::Indefinite`] with the name of a node if Khat is not positive definite.
    pub fn new(structure: &Structure, dt: f64) -> Result<Prepared, Unsolvable> {
        let inertia = |node: usize| structure.nodes[node].mass / (dt * dt);
        let factor = Factor::new(step_matrix(structure, dt), &touches(structure)).map_err(
            |NotPositive { row }| {
                let node = structure.nodes[row].name.clone();
                match longest_step(dt, |dt| step_matrix(structure, dt)) {
                    Some(longest) => Unsolvable::TooLongStep { node, longest },
                    None => Unsolvable::Indefinite { node },
                }
            },
        )?;
        let row_of = place_of(&factor);
        let places = places(structure, &row_of);
        let reduced: Vec<_> = places.iter().map(|along| reduce(&factor, along)).collect();
        let inertia = factor.order().iter().map(|node| inertia(*node)).collect();
        let [links, couplings] = links(structure, &row_of, dt);
        Ok(Prepared {
            dt,
            method: AverageAcceleration.into(),
            sub_steps: Vec::new(),
            mass: Vec::new(),
            coupled_mass: coupled_mass(structure, &row_of, 1.0 / (dt * dt)),
            inertia_factor: None,
            massless: massless::rows(structure, &row_of),
            between: between::nodes(structure, &row_of),
            elimination: Elimination::new(factor, links),
            couplings,
            inertia,
            // L D L^T is Khat/4.
            flexibility: flexibility(structure, &reduced, 0.25),
            along: Lists::new(&places),
            reduced: Lists::new(&reduced),
            place: row_of,
            key: Key::new(structure),
        })
    }

    /// Prepares steps of `dt` by a method.
    ///
    /// # Errors
    /// As [`Prepared::new`]; for other methods in the words of their own matrix.
    pub fn by(method: &Method, structure: &Structure, dt: f64) -> Result<Prepared, Unsolvable> {
        if matches!(method, Method::AverageAcceleration(_)) {
            return Prepared::new(structure, dt);
        }
        let touches = touches(structure);
        let mut row_of = Vec::new();
        let mut linear = Vec::new();
        for sub_step in method.sub_steps(dt) {
            let (next, order) = Linear::new(structure, &touches, sub_step)?;
            linear.push(next);
            row_of = order;
        }
        let inertia_factor = match structure.coupled_mass.is_empty() {
            true => None,
            false => Some(Inertia::new(structure).map_err(|NotPositive { row }| {
                let node = structure.nodes[row].name.clone();
                Unsolvable::Indefinite { node }
            })?),
        };
        let mut mass = vec![0.0; structure.len()];
        for (node, row) in structure.nodes.iter().zip(&row_of) {
            mass[*row] = node.mass;
        }
        Ok(Prepared {
            dt,
            method: *method,
            sub_steps: linear,
            mass,
            coupled_mass: coupled_mass(structure, &row_of, 1.0),
            inertia_factor,
            massless: massless::rows(structure, &row_of),
            between: between::nodes(structure, &row_of),
            elimination: Elimination::none(),
            couplings: Vec::new(),
            inertia: Vec::new(),
            along: Lists::new(&places(structure, &row_of)),
            reduced: Lists::new(&[]),
            flexibility: BlockMatrix::default(),
            place: row_of,
            key: Key::new(structure),
        })
    }

    /// Whether a structure with steps of `dt` by a method has the same linear part, and loads on the same nodes.
    pub fn fits(&self, method: &Method, structure: &Structure, dt: f64) -> bool {
        let nodes = structure.nodes.iter().map(|node| &node.mass);
        let along = structure.contacts.iter().map(|contact| &contact.along);
        let same_nodes = |(a, b): (&Vec<usize>, _)| a.iter().copied().eq(loaded(b));
        self.dt == dt
            && self.method == *method
            && self.key.loads.len() == structure.loads.len()
            && self.key.loads.iter().zip(&structure.loads).all(same_nodes)
            && self.key.masses.iter().eq(nodes)
            && self.key.coupled_mass == structure.coupled_mass
            && self.key.along.iter().eq(along)
            && self.key.stiffness == structure.stiffness
            && self.key.damping == structure.damping
    }

    /// The time step.
    pub fn dt(&self) -> f64 {
        self.dt
    }

    /// The method.
    pub fn method(&self) -> &Method {
        &self.method
    }

    /// Whether the steps are those of constant average acceleration in increments, which have a form of their own.
    pub(crate) fn has_increments(&self) -> bool {
        self.sub_steps.is_empty()
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.place.len()
    }

    /// Number of contacts.
    pub fn contacts(&self) -> usize {
        self.along.len()
    }

    /// The contacts of nodes without mass; some more than once.
    pub(crate) fn massless_contacts(&self) -> impl Iterator<Item = usize> + '_ {
        let contacts = self.massless.iter().flat_map(|node| &node.contacts);
        contacts.copied()
    }
}

impl Key {
    fn new(structure: &Structure) -> Key {
        Key {
            masses: structure.nodes.iter().map(|node| node.mass).collect(),
            stiffness: structure.stiffness.clone(),
            damping: structure.damping.clone(),
            coupled_mass: structure.coupled_mass.clone(),
            along: structure.contacts.iter().map(|c| c.along.clone()).collect(),
            loads: structure
                .loads
                .iter()
                .map(loaded)
                .map(Vec::from_iter)
                .collect(),
        }
    }
}

/// The matrix of a step, K^/4.
fn step_matrix(structure: &Structure, dt: f64) -> Symmetric {
    let inertia = structure.nodes.iter().map(|node| node.mass / (dt * dt));
    let terms = [
        (&structure.coupled_mass, 1.0 / (dt * dt)),
        (&structure.damping, 0.5 / dt),
        (&structure.stiffness, 0.25),
    ];
    let mut matrix = Symmetric::sum(&inertia.collect::<Vec<_>>(), &terms);
    between::hold(structure, &mut matrix);
    matrix
}

/// About the longest step, in words, with which the matrix of a step is positive definite; `None` if there is none. It is not with
/// `dt`: a negative stiffness needs short steps.
pub(crate) fn longest_step(dt: f64, matrix: impl Fn(f64) -> Symmetric) -> Option<String> {
    let is_positive = |dt: f64| {
        let matrix = matrix(dt);
        Factor::new(&matrix, &vec![false; matrix.size()]).is_ok()
    };
    let mut steps = (1..=HALVINGS).map(|k| dt * 0.5f64.powi(k));
    let mut low = steps.find(|dt| is_positive(*dt))?;
    let mut high = 2.0 * low;
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (low + high);
        (low, high) = match is_positive(middle) {
            true => (middle, high),
            false => (low, middle),
        };
    }
    Some(format!("{low:.3}"))
}

/// Whether each node has a contact.
fn touches(structure: &Structure) -> Vec<bool> {
    let mut touches = vec![false; structure.len()];
    for (node, _) in structure.contacts.iter().flat_map(|c| &c.along) {
        touches[*node] = true;
    }
    touches
}

/// The entries of M below its diagonal by place, times a factor.
fn coupled_mass(structure: &Structure, row_of: &[usize], factor: f64) -> Vec<(usize, usize, f64)> {
    let entries = structure.coupled_mass.entries();
    entries
        .map(|((i, j), m)| (row_of[i], row_of[j], factor * m))
        .collect()
}

/// The nodes of a load.
fn loaded(load: &Load) -> impl Iterator<Item = usize> + '_ {
    load.pattern.iter().map(|(node, _)| *node)
}
