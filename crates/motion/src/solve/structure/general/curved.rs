//! Contacts with laws that are not clipped lines.

use super::stages::General;
use crate::lane::Lane;
use crate::solve::structure::Prepared;
use crate::solve::structure::contacts::curved::contact::has_curved;
use crate::solve::structure::contacts::curved::contacts::Curved;
use crate::solve::structure::contacts::curved::lanes::{curved_lanes, meet_lane};
use crate::solve::structure::contacts::curved::step::Motion;
use crate::solve::structure::contacts::forces::Forces;
use crate::solve::structure::contacts::static_friction::breaks;
use crate::solve::structure::linear_part::linear::Linear;
use crate::system::structure::Structure;

/// The contacts of each sub-step in each lane that has such a law; empty if there is none.
pub(super) fn contacts<const L: usize>(
    cases: &[&Structure; L],
    parts: &[Linear],
    forces: &mut [Forces<L>],
) -> Vec<Vec<Option<Curved>>> {
    if !cases.iter().any(|case| has_curved(case)) {
        return Vec::new();
    }
    let of_part = |(linear, forces): (&Linear, &mut Forces<L>)| {
        let sub_step = &linear.sub_step;
        let pace = match sub_step.is_explicit() {
            true => f64::INFINITY,
            false => 1.0 / sub_step.of_velocity(),
        };
        curved_lanes(cases, &linear.flexibility, pace, sub_step.length, forces)
    };
    parts.iter().zip(forces).map(of_part).collect()
}

/// Why a method cannot have the laws of a structure; `None` if it can.
pub(super) fn refused(case: &Structure, prepared: &Prepared) -> Option<String> {
    let curved = case.contacts.iter().find(|c| c.law.is_curved())?;
    let impulses = prepared.method.has_impulses();
    let mut contacts = case.contacts.iter();
    let rigid = contacts
        .find(|contact| impulses && contact.law.is_rigid() && contact.law.row().is_none())?;
    Some(format!(
        "method: moreau-jean has no forces for '{}' without compliance together with the law of '{}'; allowed: another method",
        rigid.name, curved.name
    ))
}

impl<const L: usize> General<'_, L> {
    /// The forces of the lanes with such laws.
    #[cold]
    #[inline(never)]
    pub(super) fn meet_curved(&mut self, part: usize, end: usize) {
        let explicit = self.prepared.sub_steps[part].sub_step.is_explicit();
        let (before, now) = self.curved.split_at_mut(part);
        let start = &self.stages[part];
        for (l, curved) in now[0].iter_mut().enumerate() {
            let Some(curved) = curved else {
                continue;
            };
            if let Some(Some(before)) = before.last().map(|before| &before[l]) {
                curved.remember(before);
            }
            let (contacts, along) = (&self.contacts, &self.prepared.along);
            let motion = |c: usize| {
                let [displacement, velocity, force] = start.contacts[c].map(|x| x.0[l]);
                let (change, rate) = (contacts[c].change.0[l], contacts[c].rate.0[l]);
                let size = match explicit {
                    true => velocity.abs() + rate.abs(),
                    false => displacement.abs() + change.abs(),
                };
                let terms = |which: usize| -> f64 {
                    let nodes = along.list(c).iter();
                    nodes
                        .map(|(at, factor)| (start.nodes[*at][which].0[l] * factor).abs())
                        .sum()
                };
                let gap = contacts[c].gap.0[l].abs();
                Motion {
                    terms: [
                        terms(0) + gap + displacement.abs(),
                        terms(1) + velocity.abs(),
                    ],
                    displacement,
                    velocity,
                    force,
                    change,
                    rate,
                    size,
                }
            };
            let forces = &mut self.forces[part];
            let breaks = breaks(&mut self.two_limits, l);
            meet_lane(curved, motion, &mut self.force, forces, (l, end), breaks);
        }
        if self.two_limits.is_some() {
            self.end_planes();
        }
        // The first sub-step of the next step goes on from the last one.
        if part > 0 {
            let (first, last) = self.curved.split_at_mut(part);
            for (first, last) in first[0].iter_mut().zip(&last[0]) {
                if let (Some(first), Some(last)) = (first, last) {
                    first.remember(last);
                }
            }
        }
    }

    /// Energy that the contacts with such laws store, in the lanes that have them.
    pub(super) fn curved_energy(&self, mut energy: Lane<L>) -> Lane<L> {
        let Some(last) = self.curved.last() else {
            return energy;
        };
        for (l, curved) in last.iter().enumerate() {
            if let Some(curved) = curved {
                let states = self.last().contacts.iter();
                energy.0[l] = curved.stored_energy(states.map(|[r, _, s]| [r.0[l], s.0[l]]));
            }
        }
        energy
    }
}
