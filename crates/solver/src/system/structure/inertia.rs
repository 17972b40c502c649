//! What divides forces by masses, and the nodes that have none.

use super::factor::{Factor, NotPositive};
use super::{Structure, Symmetric};

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
                Some(Factor::new(&matrix, &vec![false; masses.len()])?)
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
        let mut accelerations: Vec<f64> = load
            .iter()
            .zip(&inner)
            .map(|(load, inner)| load - inner)
            .collect();
        Inertia::new(self)?.divide(&mut accelerations);
        Ok(accelerations)
    }

    /// Whether every node has a mass.
    pub fn has_mass_everywhere(&self) -> bool {
        self.nodes.iter().all(|node| node.mass > 0.0)
    }

    /// Whether each node has neither mass nor damping: K u + B S = p holds there at every instant.
    pub fn massless(&self) -> Vec<bool> {
        let mut massless: Vec<bool> = self.nodes.iter().map(|node| node.mass == 0.0).collect();
        let mut leave_out = |matrix: &Symmetric| {
            for ((i, j), value) in matrix.entries() {
                if value != 0.0 {
                    (massless[i], massless[j]) = (false, false);
                }
            }
        };
        leave_out(&self.coupled_mass);
        leave_out(&self.damping);
        massless
    }
}
