//! A structure in the form that the pieces need: in coordinates in which M is diagonal.
//!
//! There are two forms. Of a small structure with lumped masses the coordinates are its nodes, which needs no preparation and
//! allows any damping. Of others they are its modes (`modal`): M of elements couples nodes, nodes without mass are condensed, both
//! of which would need a solution at each order of each piece, and K u costs more than one product for each mode. All that follows,
//! pieces, phases, events and the energy book, is the same for both.

use super::flexible::Flexible;
use super::modes::Modes;
use super::pressed::Pressed;
use crate::exact::events::numerics::matrix::Matrix;
use crate::exact::events::numerics::row::Row;
use crate::exact::events::numerics::signals;
use crate::exact::events::numerics::sparse::{RowSums, Rows};
use crate::exact::events::phases::contact_state::{ContactState, Force};
use crate::system::structure::{Contact, Structure};
use std::borrow::Cow;

/// Largest product of the bound of the frequencies and the length of a piece: the terms left out are below 2^27/27! = 1e-20.
pub const LONGEST: f64 = 2.0;

/// From this number of nodes on, modes are faster, their computation included: a chain of 300 masses took 0.9 s in place of 1.6 s,
/// one of 1000 7 s in place of 17 s. Smaller structures with lumped masses keep the form of nodes, and so the bits of their results.
pub(crate) const MANY: usize = 200;

/// Most modes: their matrices have this number squared, and their computation takes the time of its cube.
pub const MOST_MODES: usize = 4000;

/// A structure with the inverse masses of its coordinates, K, C, B, and the times of the points of its tables.
#[derive(Debug)]
pub struct Model<'a> {
    /// The structure.
    pub structure: &'a Structure,
    /// 1/m of each coordinate.
    pub inverse_masses: Vec<f64>,
    /// K.
    pub stiffness: Matrix,
    /// C.
    pub damping: Matrix,
    /// The contacts; their `along` is that of the structure.
    pub contacts: Cow<'a, [Contact]>,
    /// B, a row for each contact.
    pub columns: Vec<Row>,
    /// The pattern of each load.
    pub patterns: Vec<Row>,
    /// Values and rates of the coordinates at t = 0.
    pub start: [Vec<f64>; 2],
    /// The modes, if these are the coordinates.
    pub modes: Option<Modes>,
    /// Contacts at nodes without mass.
    pub flexible: Option<Flexible>,
    /// Friction contacts that others press.
    pub pressed: Vec<Pressed>,
    /// Times of the points of all tables.
    pub points: Vec<f64>,
    pub bounds: Bounds,
    pub fastest_load: f64,
}

/// What bounds the eigenvalues of K and C.
#[derive(Debug)]
pub enum Bounds {
    /// Sums of rows.
    Nodes([RowSums; 2]),
    /// The largest eigenvalues of K and C, or more, and |b_i^T b_j| of all contacts, by rows.
    Modes {
        largest: [f64; 2],
        couplings: Vec<f64>,
    },
}

impl<'a> Model<'a> {
    /// The coordinates are the nodes.
    pub fn of_nodes(structure: &'a Structure) -> Model<'a> {
        let masses = structure.nodes.iter();
        // Nodes without mass are here only where pieces are counted: others bound their motion.
        let inverse = |mass: f64| if mass > 0.0 { 1.0 / mass } else { 0.0 };
        let inverse_masses: Vec<f64> = masses.map(|node| inverse(node.mass)).collect();
        let (stiffness, damping) = (
            Rows::new(&structure.stiffness),
            Rows::new(&structure.damping),
        );
        let columns = structure
            .contacts
            .iter()
            .map(|contact| Row::Sparse(contact.along.clone()));
        let patterns = structure
            .loads
            .iter()
            .map(|load| Row::Sparse(load.pattern.clone()));
        Model {
            bounds: Bounds::Nodes(
                [&stiffness, &damping].map(|matrix| RowSums::new(matrix, &inverse_masses)),
            ),
            stiffness: Matrix::Sparse(stiffness),
            damping: Matrix::Sparse(damping),
            start: [structure.displacement.clone(), structure.velocity.clone()],
            contacts: Cow::Borrowed(&structure.contacts),
            columns: columns.collect(),
            patterns: patterns.collect(),
            modes: None,
            flexible: None,
            pressed: Pressed::of(structure, |along| Row::Sparse(along.clone())),
            points: signals::points(structure),
            fastest_load: signals::fastest(structure),
            structure,
            inverse_masses,
        }
    }

    /// Number of coordinates.
    pub fn len(&self) -> usize {
        self.inverse_masses.len()
    }

    /// The length of a piece for contacts in these phases; infinite for a structure without stiffness and damping.
    ///
    /// With bounds w^2 of M^-1 K and g of M^-1 C, the derivatives grow at most as powers of x, x^2 = g x + w^2. Constraints only
    /// lower the bounds.
    pub fn piece_length(&self, contacts: &[ContactState]) -> f64 {
        let law = |i: usize| contacts[i].law(&self.contacts[i].law);
        let forces = (0..contacts.len()).map(law);
        let [square, damping] = match &self.bounds {
            Bounds::Nodes(sums) => {
                let [mut stiffness, mut damping] = sums.clone();
                for (contact, force) in self.contacts.iter().zip(forces) {
                    let (sums, coefficient) = match force {
                        Force::Spring { k, .. } | Force::Line { slope: k, .. } => {
                            // A law that softens has slopes below 0.
                            (&mut stiffness, k.abs())
                        }
                        Force::Dashpot { c } => (&mut damping, c),
                        Force::None | Force::Limit(_) | Force::Constraint => continue,
                    };
                    sums.add_along(&contact.along, coefficient, &self.inverse_masses);
                }
                for pressed in &self.pressed {
                    let along = &self.contacts[pressed.contact].along;
                    let [k, c] = pressed.slopes(law);
                    stiffness.add_along(along, k, &self.inverse_masses);
                    damping.add_along(along, c, &self.inverse_masses);
                }
                [stiffness.bound(), damping.bound()]
            }
            Bounds::Modes { largest, couplings } => {
                let [mut springs, mut dashpots] = [(); 2].map(|()| vec![0.0; self.contacts.len()]);
                for (i, force) in forces.enumerate() {
                    match force {
                        Force::Spring { k, .. } if !self.is_flexible(i) => springs[i] = k,
                        Force::Spring { .. } => {}
                        Force::Line { slope, .. } => springs[i] = slope.abs(),
                        Force::Dashpot { c } => dashpots[i] = c,
                        Force::None | Force::Limit(_) | Force::Constraint => {}
                    }
                }
                for pressed in &self.pressed {
                    let [k, c] = pressed.slopes(law);
                    springs[pressed.contact] += k;
                    dashpots[pressed.contact] += c;
                }
                let [mut stiffness, damping] = *largest;
                if let Some(flexible) = &self.flexible {
                    stiffness += flexible.bound(&self.contacts, contacts, couplings);
                }
                [
                    stiffness + bound(couplings, &springs),
                    damping + bound(couplings, &dashpots),
                ]
            }
        };
        let half = 0.5 * damping;
        let rate = half + (half * half + square).sqrt();
        LONGEST / rate.max(self.fastest_load)
    }

    /// Number of pieces of a motion up to `end` with contacts in these phases all the time: a new one starts at each point of a
    /// table, and none is longer than the phases allow.
    pub fn pieces(&self, contacts: &[ContactState], end: f64) -> f64 {
        let points = self.points.iter().filter(|point| **point < end).count();
        (end / self.piece_length(contacts)).max(points as f64)
    }

    /// Whether a contact is at a node without mass.
    fn is_flexible(&self, contact: usize) -> bool {
        let flexible = self.flexible.as_ref();
        flexible.is_some_and(|flexible| flexible.contacts.contains(&contact))
    }

    /// The stiffness k of a contact, with the compliance of nodes without mass.
    pub fn stiffness_of(&self, contact: usize, k: f64) -> f64 {
        let flexible = self.flexible.as_ref();
        flexible.map_or(k, |flexible| flexible.stiffness_of(contact, k))
    }

    /// The relative value of a contact without its gap; without the part of nodes without mass that its forces and loads move.
    pub fn relative(&self, contact: usize, x: &[f64]) -> f64 {
        self.columns[contact].dot(x)
    }

    /// Subtracts M^-1 B times a force of a contact from accelerations, or times an impulse from velocities.
    pub fn subtract_force(&self, contact: usize, force: f64, from: &mut [f64]) {
        self.columns[contact].subtract_weighted(&self.inverse_masses, force, from);
    }

    /// b^T M^-1 b of a contact.
    pub fn own_flexibility(&self, contact: usize) -> f64 {
        match &self.bounds {
            Bounds::Nodes(_) => self.flexibility(&[contact])[0],
            Bounds::Modes { couplings, .. } => couplings[contact * (self.contacts.len() + 1)],
        }
    }

    /// B^T M^-1 B of these contacts, by rows.
    pub fn flexibility(&self, contacts: &[usize]) -> Vec<f64> {
        let mut matrix = Vec::with_capacity(contacts.len() * contacts.len());
        for i in contacts {
            for j in contacts {
                matrix.push(self.columns[*i].form(&self.inverse_masses, &self.columns[*j]));
            }
        }
        matrix
    }
}

/// A bound of the largest eigenvalue of sum c_i b_i b_i^T from the |b_i^T b_j| (Gershgorin).
fn bound(couplings: &[f64], coefficients: &[f64]) -> f64 {
    let rows = couplings
        .chunks_exact(coefficients.len().max(1))
        .zip(coefficients)
        .map(|(row, c)| {
            let terms = row.iter().zip(coefficients);
            terms
                .map(|(coupling, other)| coupling * (c * other).sqrt())
                .sum()
        });
    rows.fold(0.0, f64::max)
}
