//! What moves nodes and contacts beside the solution of a step.

use super::lane_state::Average;
use crate::lane::Lane;
use crate::solve::structure::linear_part::between::Between;
use crate::solve::structure::linear_part::massless::Massless;

impl<const L: usize> Average<'_, L> {
    /// Moves the nodes between contacts in series to where the laws have them after the step.
    #[cold]
    pub(crate) fn move_between(&mut self) {
        for Between {
            place,
            first: (first, factor),
            contacts,
        } in &self.prepared.between
        {
            let first = *first;
            let mut change = Lane::splat(0.0);
            for (l, curved) in self.curved.iter().enumerate() {
                if let Some(curved) = curved {
                    let contact = &self.contacts[first];
                    let now = contact.p.0[l] - 0.5 * contact.w.0[l];
                    change.0[l] = factor * (curved.displacement(first) - now);
                }
            }
            self.p[*place] = self.p[*place] + change;
            self.moved[*place] = change;
            for (contact, factor) in contacts {
                let contact = &mut self.contacts[*contact];
                contact.p = contact.p + change * *factor;
            }
        }
    }
}

impl<const L: usize> Average<'_, L> {
    /// Moves the gaps over a step, in the trial values of the contacts.
    #[cold]
    pub(crate) fn move_gaps(&mut self, step: usize) {
        let Some(moving) = &mut self.moving else {
            return;
        };
        moving.advance(step);
        for (c, trial) in self.trial.iter_mut().enumerate() {
            let [by_r, by_rate] = moving.excess(c);
            let line = &self.contacts[c].line;
            for l in 0..L {
                // r* - c of a law of velocities is dt/2 rdot*.
                let of_rate = line.by_increment.0[l] == 0.5 && line.by_displacement.0[l] == 0.0;
                trial.0[l] += if of_rate { by_rate.0[l] } else { by_r.0[l] };
            }
        }
    }

    /// Adds the gaps after the step to the contacts.
    #[cold]
    pub(crate) fn add_gaps(&mut self) {
        let Some(moving) = &self.moving else {
            return;
        };
        for (contact, [gap, rate]) in self.contacts.iter_mut().zip(&moving.end) {
            let change = *rate * self.prepared.dt;
            contact.p = contact.p + (*gap + change * 0.5);
            contact.w = contact.w + change;
        }
    }
}

impl<const L: usize> Average<'_, L> {
    /// The right sides of the nodes without mass: p(i+1)/2 + K u(i)/2, of which the springs take K P.
    #[cold]
    pub(crate) fn prescribe_massless(&mut self, step: usize) {
        // The loads at the end of the step; the list is filled anew after it.
        self.moved.fill(Lane::splat(0.0));
        self.inputs.add_ends(step, &mut self.moved);
        for node in &self.prepared.massless {
            let mut sum = self.moved[node.place];
            for (at, k) in &node.row {
                sum = sum + (self.p[*at] - self.w[*at] * 0.5) * *k;
            }
            self.work[node.place] = sum * 0.5;
        }
    }

    /// The displacements of the nodes without mass after the solution, which moved them as others.
    #[cold]
    pub(crate) fn move_massless(&mut self) {
        self.moved.fill(Lane::splat(0.0));
        for Massless { place, .. } in &self.prepared.massless {
            let half = self.w[*place] * 0.5;
            self.p[*place] = self.p[*place] - half;
            self.w[*place] = Lane::splat(0.0);
            self.moved[*place] = half;
        }
    }
}
