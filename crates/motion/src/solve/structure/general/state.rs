//! What a run shows of the state, and whether it is valid.

use super::stages::{General, Stage};
use crate::contact::Unsolved;
use crate::lane::Lane;
use crate::solve::Unsolvable;
use crate::solve::structure::ContactStep;
use crate::solve::structure::contacts::forces::Forces;
use crate::solve::structure::contacts::static_friction::StaticFriction;

impl<const L: usize> General<'_, L> {
    /// Displacement of a node, numbered as in the structure.
    #[inline(always)]
    pub(in crate::solve::structure) fn displacement(&self, node: usize) -> Lane<L> {
        self.last().nodes[self.prepared.place[node]][0]
    }

    /// Velocity of a node.
    #[inline(always)]
    pub(in crate::solve::structure) fn velocity(&self, node: usize) -> Lane<L> {
        self.last().nodes[self.prepared.place[node]][1]
    }

    /// A contact.
    #[inline(always)]
    pub(in crate::solve::structure) fn contact(&self, contact: usize) -> ContactStep<L> {
        let [displacement, velocity, force] = self.last().contacts[contact];
        let mut limit = self.contacts[contact].bounds[1];
        if let Some(friction) = &self.two_limits {
            friction.show(contact, &mut limit);
        }
        let contact = &self.contacts[contact];
        ContactStep {
            displacement,
            velocity,
            force,
            limit,
            slip: displacement - force * contact.by_force,
        }
    }

    /// Friction with two limits.
    pub(in crate::solve::structure) fn two_limits(&self) -> Option<&StaticFriction> {
        self.two_limits.as_ref()
    }

    /// g of the line of a contact in the first sub-step; 0 without compliance.
    pub(in crate::solve::structure) fn compliance(&self, contact: usize) -> Lane<L> {
        self.lines[0][contact].compliance
    }

    /// The displacement that a unit force of a contact takes from it in the first sub-step.
    pub(in crate::solve::structure) fn displacement_by_force(&self, contact: usize) -> f64 {
        let linear = &self.prepared.sub_steps[0];
        let by_force = linear.flexibility.diagonal(contact);
        match linear.sub_step.is_explicit() {
            // Of the velocity.
            true => by_force * linear.sub_step.length,
            false => by_force,
        }
    }

    /// The motion after the last step.
    #[inline(always)]
    pub(super) fn last(&self) -> &Stage<L> {
        &self.stages[self.prepared.sub_steps.len()]
    }

    /// The first step at which a lane has no forces, and why; or why it cannot start.
    pub(in crate::solve::structure) fn failures(&self) -> [Option<Unsolvable>; L] {
        let parts = self.prepared.sub_steps.len();
        std::array::from_fn(|l| {
            let of = |forces: &Forces<L>| forces.failures()[l];
            let corrections = self.corrections.as_ref();
            let first = self
                .forces
                .iter()
                .chain(corrections.map(|corrections| &corrections.forces))
                .filter_map(of)
                .min_by_key(|(end, _)| *end);
            let failure = |(end, why): (usize, Unsolved)| Unsolvable::NoForces {
                step: end.div_ceil(parts),
                why,
            };
            self.refused[l].clone().or(first.map(failure))
        })
    }

    /// Whether the motion of each lane is finite.
    pub(in crate::solve::structure) fn finite(&self) -> [bool; L] {
        let mut finite = [true; L];
        for [u, v, _] in &self.last().nodes {
            for (l, finite) in finite.iter_mut().enumerate() {
                *finite &= u.0[l].is_finite() && v.0[l].is_finite();
            }
        }
        finite
    }
}
