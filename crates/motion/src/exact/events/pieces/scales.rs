//! Round-off of the quantities that events depend on, from the largest values so far.

use super::series::Series;
use crate::contact::ClippedLine;
use crate::exact::events::coordinates::model::Model;

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
        for i in 0..series.contacts.len() {
            if let Some([gap, rate]) = series.gaps.at(i, 0.0) {
                self.displacement = self.displacement.max(gap.abs());
                self.velocity = self.velocity.max(rate.abs());
            }
            if let Some(of_gap) = series.gaps.acceleration(i, 0) {
                self.acceleration = self.acceleration.max(of_gap.abs());
            }
        }
        let contacts = model.contacts.iter().zip(&series.contacts);
        for (largest, (contact, series)) in self.limits.iter_mut().zip(contacts) {
            *largest = largest.max(contact.law.static_ratio() * series.limit[0].abs());
        }
        if model.modes.is_some() {
            return self.include_modes(model, u, v, series);
        }
        self.displacement = self.displacement.max(largest(u));
        self.velocity = self.velocity.max(largest(v));
        let mut forces = vec![0.0; u.len()];
        model.stiffness.add_terms(u, &mut forces);
        model.damping.add_terms(v, &mut forces);
        for (load, signal) in model.structure.loads.iter().zip(&series.loads) {
            for (node, factor) in &load.pattern {
                forces[*node] += (factor * signal[0]).abs();
            }
        }
        for (contact, limit) in model.contacts.iter().zip(&self.limits) {
            for (node, _) in &contact.along {
                forces[*node] += limit;
            }
        }
        for (force, w) in forces.iter().zip(&model.inverse_masses) {
            self.force = self.force.max(*force);
            self.acceleration = self.acceleration.max(force * w);
        }
    }

    /// The same of modes: r, rdot and r'' of the contacts are sums over all modes, and have the round-off of their terms.
    fn include_modes(&mut self, model: &Model, u: &[f64], v: &[f64], series: &Series) {
        let mut accelerations = vec![0.0; u.len()];
        model.stiffness.add_terms(u, &mut accelerations);
        model.damping.add_terms(v, &mut accelerations);
        for (pattern, signal) in model.patterns.iter().zip(&series.loads) {
            pattern.add_terms(signal[0], &mut accelerations);
        }
        for (limit, column) in self.limits.iter().zip(&model.columns) {
            column.add_terms(*limit, &mut accelerations);
        }
        for (i, column) in model.columns.iter().enumerate() {
            self.displacement = self.displacement.max(column.terms(u));
            self.velocity = self.velocity.max(column.terms(v));
            let acceleration = column.terms(&accelerations);
            self.acceleration = self.acceleration.max(acceleration);
            let flexibility = model.own_flexibility(i);
            if flexibility > 0.0 {
                self.force = self.force.max(acceleration / flexibility);
            }
        }
    }

    /// Tolerance of r of a contact on a piece of this length.
    pub fn r(&self, model: &Model, contact: usize, length: f64) -> f64 {
        let gap = model.contacts[contact].gap.abs();
        TOLERANCE * self.displacement.max(gap) + ROUND_OFF * self.acceleration * length * length
    }

    /// Tolerance of rdot on a piece of this length.
    pub fn rate(&self, length: f64) -> f64 {
        TOLERANCE * self.velocity + ROUND_OFF * self.acceleration * length
    }

    /// Tolerance of S of a spring on a piece of this length.
    pub fn spring(&self, [k, c]: [f64; 2], length: f64) -> f64 {
        let r = TOLERANCE * self.displacement + ROUND_OFF * self.acceleration * length * length;
        k.abs() * r + c * self.rate(length)
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
        let line = model.contacts[contact].law.line();
        let motion = match line {
            Some(ClippedLine::Spring { stiffness } | ClippedLine::Elastic { stiffness }) => {
                // Infinite for rigid contacts of nodes without mass that only contacts hold.
                match model.stiffness_of(contact, stiffness) {
                    f64::INFINITY => TOLERANCE * self.force,
                    k => k * self.r(model, contact, length),
                }
            }
            Some(ClippedLine::Viscous { viscosity }) => viscosity * self.rate(length),
            Some(ClippedLine::Stop { .. } | ClippedLine::Coulomb) | None => TOLERANCE * self.force,
        };
        motion + self.limit(contact)
    }
}
