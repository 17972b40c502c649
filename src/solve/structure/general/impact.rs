//! Rigid stops on which impulses act: which of them are active in a step.

use super::contacts::LaneContact;
use super::stepper::General;
use crate::lane::Lane;
use crate::solve::structure::Prepared;

/// What rigid stops and Coulomb friction of the method of Moreau and Jean need.
#[derive(Debug)]
pub(super) struct Impacts<const L: usize> {
    /// The stops that are active in the step.
    active: Vec<[bool; L]>,
    /// For each place, the place whose velocity it has; see `rest`.
    pub(super) with: Vec<usize>,
}

impl<const L: usize> Impacts<L> {
    /// `None` if impulses act on no contact.
    pub(super) fn new(contacts: &[LaneContact<L>], prepared: &Prepared) -> Option<Impacts<L>> {
        if contacts
            .iter()
            .all(|contact| contact.by_impulse == [false; L])
        {
            return None;
        }
        let m = contacts.len();
        Some(Impacts {
            active: vec![[false; L]; m],
            with: (0..=prepared.nodes()).collect(),
        })
    }

    pub(super) fn is_active(&self, contact: usize, lane: usize) -> bool {
        self.active[contact][lane]
    }
}

impl<const L: usize> General<'_, L> {
    /// Makes the stops active whose gap, predicted for the middle of the step by r + dt/2 rdot, is not positive.
    pub(super) fn activate(&mut self, part: usize) {
        let Some(impacts) = &mut self.impacts else {
            return;
        };
        let start = &self.stages[part].contacts;
        let half = 0.5 * self.prepared.sub_steps[part].sub_step.length;
        let mut changed = false;
        for (c, contact) in self.contacts.iter().enumerate() {
            let before = impacts.active[c];
            for l in (0..L).filter(|l| contact.stop[*l]) {
                let [r, rdot] = [0, 1].map(|k| start[c][k].0[l]);
                impacts.active[c][l] = r + half * rdot <= 0.0;
            }
            // A limit that changes sets the bounds of all lanes.
            let new = self.step == 1 || self.inputs.limits_vary();
            if new || impacts.active[c] != before {
                self.forces[part].rebound(c, contact.bounds_with(&impacts.active[c]));
                changed = true;
            }
        }
        if changed {
            self.forces[part].hold();
        }
    }

    /// After a step: contacts at rest have equal velocities.
    pub(super) fn rest(&mut self, part: usize) {
        let mut moved = false;
        for l in 0..L {
            moved |= self.join(part, l);
        }
        if moved {
            self.touch(part + 1);
        }
    }
}

impl<const L: usize> LaneContact<L> {
    /// The bounds of S' where stops are active in these lanes.
    fn bounds_with(&self, active: &[bool; L]) -> [Lane<L>; 2] {
        let [mut low, high] = self.bounds;
        for ((low, stop), active) in low.0.iter_mut().zip(self.stop).zip(active) {
            if stop && !active {
                *low = 0.0;
            }
        }
        [low, high]
    }
}
