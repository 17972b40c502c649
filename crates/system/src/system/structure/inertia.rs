//! What divides forces by masses, and the nodes that have none.

use super::{Contact, Structure};
use crate::contact::ClippedLine;
use crate::system::structure::sparse::factor::{Factor, NotPositive};

/// M^-1, for nodes with mass.
#[derive(Debug, Clone)]
pub struct Inertia {
    masses: Vec<f64>,
    /// The factor of M where masses are coupled, with 1 on the diagonal of rows without mass.
    factor: Option<Factor>,
}

impl Inertia {
    /// That of a structure.
    ///
    /// # Errors
    /// M is not positive definite among the nodes with mass.
    pub fn new(structure: &Structure) -> Result<Inertia, NotPositive> {
        let masses: Vec<f64> = structure.nodes.iter().map(|node| node.mass).collect();
        let factor = match structure.coupled_mass.is_empty() {
            true => None,
            false => {
                let mut matrix = structure.mass();
                for (i, mass) in masses.iter().enumerate() {
                    if *mass == 0.0 {
                        matrix.add(i, i, 1.0);
                    }
                }
                Some(Factor::new(matrix, &vec![false; masses.len()])?)
            }
        };
        Ok(Inertia { masses, factor })
    }

    /// Replaces forces by accelerations; 0 for nodes without mass.
    pub fn divide(&self, forces: &mut [f64]) {
        let without_mass = |x: &mut f64, mass: f64| {
            if mass == 0.0 {
                *x = 0.0;
            }
        };
        match &self.factor {
            None => {
                for (x, mass) in forces.iter_mut().zip(&self.masses) {
                    *x /= mass;
                    without_mass(x, *mass);
                }
            }
            Some(factor) => {
                for (x, mass) in forces.iter_mut().zip(&self.masses) {
                    without_mass(x, *mass);
                }
                factor.solve(forces);
            }
        }
    }
}

impl Structure {
    /// M^-1 (p - B S - C v - K u) at t = 0 for these contact forces; 0 for nodes without mass.
    ///
    /// # Errors
    /// As [`Inertia::new`].
    pub fn accelerations(&self, forces: &[f64]) -> Result<Vec<f64>, NotPositive> {
        let [load, inner] = self.forces_at_start(forces);
        let differences = load.iter().zip(inner);
        let mut accelerations: Vec<f64> = differences.map(|(load, inner)| load - inner).collect();
        Inertia::new(self)?.divide(&mut accelerations);
        Ok(accelerations)
    }

    /// p and B S + C v + K u at t = 0 for these contact forces.
    pub fn forces_at_start(&self, forces: &[f64]) -> [Vec<f64>; 2] {
        let n = self.len();
        let (mut load, mut inner) = (vec![0.0; n], vec![0.0; n]);
        self.add_loads(0.0, &mut load);
        self.stiffness.add_product(&self.displacement, &mut inner);
        self.damping.add_product(&self.velocity, &mut inner);
        for (contact, force) in forces.iter().enumerate() {
            for (node, factor) in self.column(contact) {
                inner[node] += factor * force;
            }
        }
        [load, inner]
    }

    /// Whether every node has a mass.
    pub fn has_mass_everywhere(&self) -> bool {
        self.nodes.iter().all(|node| node.mass > 0.0)
    }

    /// Whether a contact whose force follows the velocity by a line is at a node without mass and damping.
    pub fn has_massless_dampers(&self) -> bool {
        let is_damper = |contact: &&Contact| {
            let line = contact.law.line();
            matches!(line, Some(ClippedLine::Viscous { .. }))
        };
        let mut dampers = self.contacts.iter().filter(is_damper).peekable();
        if dampers.peek().is_none() || self.has_mass_everywhere() {
            return false;
        }
        let massless = self.massless();
        let mut nodes = dampers.flat_map(|contact| &contact.along);
        nodes.any(|(node, _)| massless.get(*node) == Some(&true))
    }

    /// Whether each node has neither mass nor damping: K u + B S = p holds there at every instant.
    pub fn massless(&self) -> Vec<bool> {
        if self.has_mass_everywhere() {
            return vec![false; self.nodes.len()];
        }
        let coupled = self.coupled_mass.nonzero_rows();
        let rows = self
            .nodes
            .iter()
            .zip(coupled)
            .zip(self.damping.nonzero_rows());
        rows.map(|((node, coupled), damped)| node.mass == 0.0 && !coupled && !damped)
            .collect()
    }
}
