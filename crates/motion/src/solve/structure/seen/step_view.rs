//! The state that a run shows after each step.

use crate::lane::Lane;
use crate::solve::structure::average::lane_state::Average;
use crate::solve::structure::general::General;
use crate::solve::structure::linear_part::moving::Moving;

/// Share of the energy that contact forces take from the motion in a step. Round-off of N steps is about 1e-16 N of this energy, so a
/// ratio stays below 1e-8 up to 1e5 steps; a motion of any use has more energy than this share.
const LEAST: f64 = 1e-3;

/// The state of L structures after a step, by the method of the run.
#[derive(Debug)]
pub struct State<'a, const L: usize>(pub(crate) Kind<'a, L>);

/// The steppers.
#[derive(Debug)]
pub(crate) enum Kind<'a, const L: usize> {
    /// Constant average acceleration.
    Average(Average<'a, L>),
    /// All other methods.
    General(General<'a, L>),
}

/// A contact after a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactStep<const L: usize> {
    /// Relative displacement r.
    pub displacement: Lane<L>,
    /// Relative velocity rdot.
    pub velocity: Lane<L>,
    /// Force S; the mean over the step where it is an impulse.
    pub force: Lane<L>,
    /// Friction limit; 0 for an impact.
    pub limit: Lane<L>,
    /// r - S/k^C of the displacement-control model; r of the other laws.
    pub slip: Lane<L>,
}

impl<const L: usize> State<'_, L> {
    /// Displacement of a node, numbered as in the structure; the supports that move follow the nodes.
    #[inline(always)]
    pub fn displacement(&self, node: usize) -> Lane<L> {
        let rest = |node| self.rest_displacement(node);
        match self.moving() {
            None => rest(node),
            Some(moving) => moving.total(node, 0, rest),
        }
    }

    /// Velocity of a node, numbered in the same way.
    #[inline(always)]
    pub fn velocity(&self, node: usize) -> Lane<L> {
        let rest = |node| self.rest_velocity(node);
        match self.moving() {
            None => rest(node),
            Some(moving) => moving.total(node, 1, rest),
        }
    }

    /// Displacement of a node; with supports that move, the rest beside what they carry.
    #[inline(always)]
    pub fn rest_displacement(&self, node: usize) -> Lane<L> {
        match &self.0 {
            Kind::Average(state) => state.displacement(node),
            Kind::General(state) => state.displacement(node),
        }
    }

    /// Velocity of a node; with supports that move, the rest beside what they carry.
    #[inline(always)]
    pub fn rest_velocity(&self, node: usize) -> Lane<L> {
        match &self.0 {
            Kind::Average(state) => state.velocity(node),
            Kind::General(state) => state.velocity(node),
        }
    }

    /// Acceleration of a support that moves; 0 without it.
    pub fn support_acceleration(&self, support: usize) -> Lane<L> {
        let moving = self.moving();
        moving.map_or(Lane::splat(0.0), |moving| moving.acceleration(support))
    }

    fn moving(&self) -> Option<&Moving<L>> {
        match &self.0 {
            Kind::Average(state) => state.moving.as_ref(),
            Kind::General(state) => state.moving.as_ref(),
        }
    }

    /// A contact.
    #[inline(always)]
    pub fn contact(&self, contact: usize) -> ContactStep<L> {
        match &self.0 {
            Kind::Average(state) => state.contact(contact),
            Kind::General(state) => state.contact(contact),
        }
    }

    /// Kinetic and strain energy, without the contacts; of the motion beside what supports carry.
    #[inline(always)]
    pub fn energy(&self) -> Lane<L> {
        match &self.0 {
            Kind::Average(state) => state.energy(),
            Kind::General(state) => state.energy(),
        }
    }

    /// Kinetic energy and strain energy, without the contacts.
    pub(crate) fn kinetic_and_strain(&self) -> [Lane<L>; 2] {
        match &self.0 {
            Kind::Average(state) => state.kinetic_and_strain(),
            Kind::General(state) => state.kinetic_and_strain(),
        }
    }

    /// Energy that the contacts store.
    #[inline(always)]
    pub fn stored_energy(&self) -> Lane<L> {
        match &self.0 {
            Kind::Average(state) => state.stored_energy(),
            Kind::General(state) => state.stored_energy(),
        }
    }

    /// The least energy that others are compared with: a share of what the forces of contacts without compliance take from the motion in a
    /// step, the sum of S^2 H_cc. Where they stick and nothing else moves, the energy itself is round-off of these products. Others store
    /// energy; with nodes without mass H is no part of a motion.
    #[inline(always)]
    pub(crate) fn least_energy(&self) -> Lane<L> {
        let (m, zero) = (self.contacts(), Lane::splat(0.0));
        // Zero where the law has a compliance.
        let of_rigid = |s: Lane<L>, compliance: Lane<L>| {
            s.zip(compliance, |s, g| if g == 0.0 { s } else { 0.0 })
        };
        let of = |c: usize| match &self.0 {
            Kind::Average(state) if !state.prepared.massless.is_empty() => zero,
            Kind::Average(state) => {
                let contact = &state.contacts[c];
                let s = of_rigid(contact.force, contact.line.compliance);
                s * (s * state.prepared.flexibility.diagonal(c))
            }
            Kind::General(state) if !state.prepared.massless.is_empty() => zero,
            Kind::General(state) => {
                let s = of_rigid(state.contact(c).force, state.compliance(c));
                s * (s * state.displacement_by_force(c))
            }
        };
        (0..m).fold(zero, |sum, c| sum + of(c)) * LEAST
    }

    /// Number of contacts.
    pub fn contacts(&self) -> usize {
        match &self.0 {
            Kind::Average(state) => state.prepared.contacts(),
            Kind::General(state) => state.prepared.contacts(),
        }
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        match &self.0 {
            Kind::Average(state) => state.prepared.nodes(),
            Kind::General(state) => state.prepared.nodes(),
        }
    }
}
