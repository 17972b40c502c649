//! A structure in the form that the pieces need.

use super::phase::{ContactState, Force};
use super::signals;
use super::sparse::{RowSums, Rows};
use crate::system::structure::Structure;

/// Largest product of the bound of the frequencies and the length of a piece: the terms left out are below 2^27/27! = 1e-20.
pub const LONGEST: f64 = 2.0;

/// A structure with the inverse masses, the rows of K and C, and the times of the points of its tables.
#[derive(Debug)]
pub struct Model<'a> {
    /// The structure.
    pub structure: &'a Structure,
    /// 1/m of each node.
    pub inverse_masses: Vec<f64>,
    /// K.
    pub stiffness: Rows,
    /// C.
    pub damping: Rows,
    /// Times of the points of all tables.
    pub points: Vec<f64>,
    sums: [RowSums; 2],
    fastest_load: f64,
}

impl Model<'_> {
    /// Prepares a structure.
    pub fn new(structure: &Structure) -> Model<'_> {
        let masses = structure.nodes.iter();
        let inverse_masses: Vec<f64> = masses.map(|node| 1.0 / node.mass).collect();
        let (stiffness, damping) = (
            Rows::new(&structure.stiffness),
            Rows::new(&structure.damping),
        );
        Model {
            sums: [&stiffness, &damping].map(|matrix| RowSums::new(matrix, &inverse_masses)),
            structure,
            points: signals::points(structure),
            fastest_load: signals::fastest(structure),
            inverse_masses,
            stiffness,
            damping,
        }
    }

    /// The length of a piece for contacts in these phases; infinite for a structure without stiffness and damping.
    ///
    /// With bounds w^2 of M^-1 K and g of M^-1 C, the derivatives grow at most as powers of x, x^2 = g x + w^2. Constraints only
    /// lower the bounds.
    pub fn piece_length(&self, contacts: &[ContactState]) -> f64 {
        let [mut stiffness, mut damping] = self.sums.clone();
        for (contact, state) in self.structure.contacts.iter().zip(contacts) {
            let (sums, coefficient) = match state.law(&contact.law) {
                Force::Spring { k, .. } => (&mut stiffness, k),
                Force::Dashpot { c } => (&mut damping, c),
                Force::None | Force::Limit(_) | Force::Constraint => continue,
            };
            sums.add_along(&contact.along, coefficient, &self.inverse_masses);
        }
        let (square, half) = (stiffness.bound(), 0.5 * damping.bound());
        let rate = half + (half * half + square).sqrt();
        LONGEST / rate.max(self.fastest_load)
    }

    /// Number of pieces of a motion up to `end` with contacts in these phases all the time: a new one starts at each point of a
    /// table, and none is longer than the phases allow.
    pub fn pieces(&self, contacts: &[ContactState], end: f64) -> f64 {
        let points = self.points.iter().filter(|point| **point < end).count();
        (end / self.piece_length(contacts)).max(points as f64)
    }

    /// The relative value of a contact without its gap.
    pub fn relative(&self, contact: usize, x: &[f64]) -> f64 {
        self.structure.relative(contact, x)
    }

    /// Subtracts M^-1 B times a force of a contact from accelerations, or times an impulse from velocities.
    pub fn subtract_force(&self, contact: usize, force: f64, from: &mut [f64]) {
        for (node, sign) in self.structure.column(contact) {
            from[node] -= self.inverse_masses[node] * sign * force;
        }
    }

    /// B^T M^-1 B of these contacts, by rows.
    pub fn flexibility(&self, contacts: &[usize]) -> Vec<f64> {
        let mut matrix = Vec::with_capacity(contacts.len() * contacts.len());
        for i in contacts {
            for j in contacts {
                let columns = self.structure.column(*i);
                matrix.push(
                    columns
                        .map(|(node, sign)| {
                            let others = self.structure.column(*j).filter(|(n, _)| *n == node);
                            let factors: f64 = others.map(|(_, other)| other).sum();
                            sign * factors * self.inverse_masses[node]
                        })
                        .sum(),
                );
            }
        }
        matrix
    }
}
