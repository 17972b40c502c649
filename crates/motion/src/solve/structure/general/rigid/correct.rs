//! Rigid stops that correct displacements before a step: the contact-stabilised Newmark method.
//!
//! u + dt v is moved by s = -dt^2 M^-1 B Lambda, so that no stop overlaps: Lambda <= 0 at stops that would, 0 at the others. Velocities
//! stay. The problem is that of contact forces with dt^2 B^T M^-1 B as flexibility.

use crate::lane::Lane;
use crate::solve::structure::general::held::corrections::Corrections;
use crate::solve::structure::general::stages::General;

impl<const L: usize> General<'_, L> {
    /// Moves the displacements predicted for a step, `dt v`, so that no rigid stop overlaps; `end` is the number of its end.
    pub(crate) fn correct(&mut self, part: usize, end: usize) {
        let Some(corrections) = &mut self.corrections else {
            return;
        };
        let prepared = self.prepared;
        let start = &self.stages[part];
        let dt = prepared.sub_steps[part].sub_step.length;
        for (c, [r, _, _]) in start.contacts.iter().enumerate() {
            let mut change = Lane::splat(0.0);
            for (at, factor) in prepared.along.list(c) {
                change = change + start.nodes[*at][1] * (dt * factor);
            }
            if let Some(moving) = &self.moving {
                change = change + (moving.end[c][0] - moving.start[c][0]);
            }
            corrections.trial[c] = *r + change;
            corrections.size[c] = r.map(f64::abs) + change.map(f64::abs);
        }
        let Corrections {
            columns,
            forces,
            trial,
            lambda,
            size,
            moved,
        } = &mut **corrections;
        forces.solve(end, trial, |c, l| size[c].0[l], lambda);
        moved.fill(Lane::splat(0.0));
        for (column, lambda) in columns.iter().zip(lambda) {
            for (at, value) in column {
                moved[*at] = moved[*at] - *lambda * *value;
            }
        }
    }
}
