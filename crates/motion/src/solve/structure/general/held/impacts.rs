//! What a run of impulses keeps of its impacts.

use crate::solve::structure::Prepared;
use crate::solve::structure::general::sub_step_contacts::LaneContact;

/// What rigid stops and Coulomb friction of the method of Moreau and Jean need.
#[derive(Debug, Clone)]
pub(crate) struct Impacts<const L: usize> {
    /// The stops that are active in the step.
    pub(crate) active: Vec<[bool; L]>,
    /// Largest displacement of the two nodes of each contact so far, and its gap.
    pub(crate) size: Vec<[f64; L]>,
    /// For each place, the place whose velocity it has; see `rest`.
    pub(crate) with: Vec<usize>,
}

impl<const L: usize> Impacts<L> {
    /// `None` if impulses act on no contact.
    pub(crate) fn new(contacts: &[LaneContact<L>], prepared: &Prepared) -> Option<Impacts<L>> {
        if contacts
            .iter()
            .all(|contact| contact.by_impulse == [false; L])
        {
            return None;
        }
        let m = contacts.len();
        Some(Impacts {
            active: vec![[false; L]; m],
            size: vec![[0.0; L]; m],
            with: (0..=prepared.nodes()).collect(),
        })
    }

    pub(crate) fn is_active(&self, contact: usize, lane: usize) -> bool {
        self.active[contact][lane]
    }
}
