//! Rigid stops on which impulses act: which of them are active in a step.

use crate::lane::Lane;
use crate::solve::structure::general::stages::General;
use crate::solve::structure::general::sub_step_contacts::LaneContact;

/// Round-off of r of a stop that stays shut for a million steps, over the largest displacement so far, also that of the velocity
/// which its force makes in a step: some 1000 times 2e-16.
const ROUND_OFF: f64 = 1e-12;

impl<const L: usize> General<'_, L> {
    /// Makes the stops active whose gap, predicted for the middle of the step by r + dt/2 rdot, is not positive. A stop that stays
    /// shut has r = 0 and rdot = 0 but for round-off, which must not open it.
    pub(crate) fn activate(&mut self, part: usize) {
        let Some(impacts) = &mut self.impacts else {
            return;
        };
        let (start, nodes) = (&self.stages[part].contacts, &self.stages[part].nodes);
        let length = self.prepared.sub_steps[part].sub_step.length;
        let (half, time) = (0.5 * length, self.step as f64 * length);
        let mut changed = false;
        for (c, contact) in self.contacts.iter().enumerate() {
            let before = impacts.active[c];
            for l in (0..L).filter(|l| contact.stop[*l]) {
                let [r, rdot] = [0, 1].map(|k| start[c][k].0[l]);
                let places = self.prepared.along.list(c).iter();
                let moved = places.map(|(row, factor)| (factor * nodes[*row][0].0[l]).abs());
                let size = &mut impacts.size[c][l];
                *size = moved.fold(size.max(contact.gap.0[l].abs()), f64::max);
                if let Some([gap, _]) = self.stages[part].gaps.get(c) {
                    *size = size.max(gap.0[l].abs());
                }
                // Round-off of the velocities that the force makes in a step moves the stop from then on.
                let by_rate = self.lines[part][c].by_rate.0[l];
                let speed = self.force[c].0[l] * self.forces[part].own(c) / by_rate;
                *size = size.max(time * speed.abs());
                let least = if before[l] { ROUND_OFF * *size } else { 0.0 };
                impacts.active[c][l] = r + half * rdot <= least;
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
    pub(crate) fn rest(&mut self, part: usize) {
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
