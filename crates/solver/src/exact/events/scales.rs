//! Round-off of the quantities that events depend on, from the largest values so far.

use super::model::Model;
use super::series::Series;
use crate::system::structure::StructureLaw;

/// Tolerance over the largest value.
const TOLERANCE: f64 = 1e-12;

/// Round-off of an acceleration, as of two nodes that the ground moves alike. From rest, nothing else is known of the scales.
const ROUND_OFF: f64 = 4.0 * f64::EPSILON;

/// The largest values so far.
#[derive(Debug, Clone)]
pub struct Scales {
    displacement: f64,
    /// |u'|.
    pub velocity: f64,
    /// Forces on a node, and limits.
    force: f64,
    /// Forces on a node over its mass.
    acceleration: f64,
    limits: Vec<f64>,
}

impl Scales {
    /// Nothing has moved.
    pub fn new(contacts: usize) -> Scales {
        Scales {
            displacement: 0.0,
            velocity: 0.0,
            force: 0.0,
            acceleration: 0.0,
            limits: vec![0.0; contacts],
        }
    }

    /// Takes the motion at a time into account; `forces` are the sums of the absolute values of the forces on each node.
    pub fn include(&mut self, model: &Model, u: &[f64], v: &[f64], series: &Series) {
        let largest = |x: &[f64]| x.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        self.displacement = self.displacement.max(largest(u));
        self.velocity = self.velocity.max(largest(v));
        for i in 0..series.contacts.len() {
            if let Some([gap, rate]) = series.gaps.at(i, 0.0) {
                self.displacement = self.displacement.max(gap.abs());
                self.velocity = self.velocity.max(rate.abs());
            }
            if let Some(of_gap) = series.gaps.acceleration(i, 0) {
                self.acceleration = self.acceleration.max(of_gap.abs());
            }
        }
        for (largest, series) in self.limits.iter_mut().zip(&series.contacts) {
            *largest = largest.max(series.limit[0].abs());
        }
        let mut forces = vec![0.0; u.len()];
        for (i, force) in forces.iter_mut().enumerate() {
            let terms = |row: &[(usize, f64)], x: &[f64]| -> f64 {
                row.iter().map(|(j, value)| (value * x[*j]).abs()).sum()
            };
            *force = terms(model.stiffness.row(i), u) + terms(model.damping.row(i), v);
        }
        for (load, signal) in model.structure.loads.iter().zip(&series.loads) {
            for (node, factor) in &load.pattern {
                forces[*node] += (factor * signal[0]).abs();
            }
        }
        for (i, limit) in self.limits.iter().enumerate() {
            for (node, _) in model.structure.column(i) {
                forces[node] += limit;
            }
        }
        for (force, w) in forces.iter().zip(&model.inverse_masses) {
            self.force = self.force.max(*force);
            self.acceleration = self.acceleration.max(force * w);
        }
    }

    /// Tolerance of r of a contact on a piece of this length.
    pub fn r(&self, model: &Model, contact: usize, length: f64) -> f64 {
        let gap = model.structure.contacts[contact].gap.abs();
        TOLERANCE * self.displacement.max(gap) + ROUND_OFF * self.acceleration * length * length
    }

    /// Tolerance of rdot on a piece of this length.
    pub fn rate(&self, length: f64) -> f64 {
        TOLERANCE * self.velocity + ROUND_OFF * self.acceleration * length
    }

    /// Tolerance of the limit of a contact.
    pub fn limit(&self, contact: usize) -> f64 {
        TOLERANCE * self.limits[contact]
    }

    /// The largest force on a node.
    pub fn force(&self) -> f64 {
        self.force
    }

    /// Tolerance of S of a contact on a piece of this length.
    pub fn contact_force(&self, model: &Model, contact: usize, length: f64) -> f64 {
        let motion = match &model.structure.contacts[contact].law {
            StructureLaw::ImpactSpring { stiffness: k }
            | StructureLaw::DisplacementControl { stiffness: k, .. } => {
                k * self.r(model, contact, length)
            }
            StructureLaw::VelocityControl { viscosity, .. } => viscosity * self.rate(length),
            StructureLaw::RigidStop { .. }
            | StructureLaw::Coulomb { .. }
            | StructureLaw::CurvedImpact { .. }
            | StructureLaw::CurvedFriction { .. }
            | StructureLaw::Link { .. } => TOLERANCE * self.force,
        };
        motion + self.limit(contact)
    }
}
