//! Lanes whose structures have contacts with laws that are not clipped lines.

use super::contact::{Contact, has_curved, has_three_points};
use super::contacts::Curved;
use super::group::Group;
use super::step::Motion;
use crate::contact::{ContactKind, Unsolved};
use crate::lane::Lane;
use crate::solve::structure::contacts::forces::{Forces, Found};
use crate::solve::structure::contacts::static_in_plane::Admit;
use crate::solve::structure::linear_part::block_matrix::BlockMatrix;
use crate::system::structure::Structure;

/// A flexibility beside which every law is stiff.
const SOFT: f64 = 1e200;

impl Curved {
    /// The first contact whose law is of a user's program and has no answer to the step, or to the motion without forces.
    pub(super) fn own_fault(&mut self, is_solved: bool) -> Option<Unsolved> {
        let contacts = self.contacts.iter_mut().zip(&self.force).enumerate();
        let mut faults = contacts.filter_map(|(contact, (law, force))| {
            let why = law.own_fault(is_solved.then_some(*force))?;
            Some(Unsolved::Own { contact, why })
        });
        faults.next()
    }

    /// Whether a step that starts with these r and S may be one of clipped lines: all impacts with other laws are open without a force.
    #[inline(always)]
    pub(crate) fn begins_open(&self, start: impl Fn(usize) -> [f64; 2]) -> bool {
        let impacts = self.open_impacts.as_ref();
        impacts.is_some_and(|impacts| impacts.begin_open(start))
    }

    /// Ends such a step with these forces, if the impacts stay open in it; false if not. `terms` are the sizes of the terms of r and rdot.
    pub(crate) fn ends_open(
        &mut self,
        force: impl Fn(usize) -> f64,
        terms: impl Fn(usize) -> [f64; 2],
    ) -> bool {
        let impacts = self.open_impacts.as_ref();
        impacts.is_some_and(|impacts| impacts.end_open(&mut self.contacts, force, terms))
    }

    /// Whether a contact's law may have several answers in a step.
    pub(crate) fn is_ambiguous(&self) -> bool {
        self.is_ambiguous_in(|_| true)
    }

    /// Whether the law of a contact of such kinds may.
    pub(crate) fn is_ambiguous_in(&self, kinds: impl Fn(ContactKind) -> bool) -> bool {
        let has_one = |group: &Group, contact: &Contact| {
            if !kinds(contact.relation.kind()) {
                return true;
            }
            let limit = contact.relation.limit().map_or(0.0, |limit| limit.at(0.0));
            let law = contact.relation.law(limit);
            // Another contact in series may be as soft as it likes.
            let flexibility = if group.is_chain() { SOFT } else { contact.own };
            let later = match has_three_points(&contact.relation, contact.scale) {
                true => contact.scale.by_three_points(),
                false => contact.scale,
            };
            law.properties().has_one_root(&later.steps(flexibility)[0])
        };
        let mut groups = self.groups.iter();
        !groups.all(|group| group.contacts().all(|i| has_one(group, &self.contacts[i])))
    }
}

/// The contacts of each lane that has such a law; empty if no lane has. `forces` leaves these lanes out. A lane with a law that may
/// have several answers in a step fails.
pub(crate) fn curved_lanes<const L: usize>(
    cases: &[&Structure; L],
    flexibility: &BlockMatrix,
    pace: f64,
    dt: f64,
    forces: &mut Forces<L>,
) -> Vec<Option<Curved>> {
    if !cases.iter().any(|case| has_curved(case)) {
        return Vec::new();
    }
    let of = |case: &&Structure| Curved::new(case, flexibility, pace, dt);
    let laws: Vec<Option<Curved>> = cases.iter().map(of).collect();
    let mut lanes = [Found::Here; L];
    for (l, (found, curved)) in lanes.iter_mut().zip(&laws).enumerate() {
        if curved.is_some() {
            *found = Found::Elsewhere;
        }
        if curved.as_ref().is_some_and(Curved::is_ambiguous) {
            forces.fail(l, 0, Unsolved::Falling);
        }
    }
    forces.find(lanes);
    laws
}

/// Writes the forces of lane `l` at the end of step `end` to `force`. Without an answer they are NaN and the lane fails. `breaks`
/// changes bounds as long as contacts break loose.
pub(crate) fn meet_lane<const L: usize>(
    curved: &mut Curved,
    motion: impl Fn(usize) -> Motion,
    force: &mut [Lane<L>],
    forces: &mut Forces<L>,
    (l, end): (usize, usize),
    breaks: impl FnMut(&[f64], &mut Admit) -> bool,
) {
    let finite = (0..force.len()).all(|c| motion(c).change.is_finite());
    match curved.solve_until(motion, breaks) {
        Ok(solved) => {
            for (force, value) in force.iter_mut().zip(solved) {
                force.0[l] = *value;
            }
        }
        Err(why) => {
            // A motion that is not finite is not a fault of the contacts.
            if finite {
                forces.fail(l, end, why);
            }
            for force in force {
                force.0[l] = f64::NAN;
            }
        }
    }
}
