//! The contact forces of a sub-step.

use super::stages::General;
use crate::lane::Lane;
use crate::methods::SubStep;

impl<const L: usize> General<'_, L> {
    /// The forces S', and y with them.
    #[inline(always)]
    pub(super) fn meet(&mut self, part: usize, end: usize) {
        let prepared = self.prepared;
        let linear = &prepared.sub_steps[part];
        let SubStep { d1, d2, forces, .. } = linear.sub_step;
        let start = &self.stages[part];
        for (c, contact) in self.contacts.iter_mut().enumerate() {
            let mut a = Lane::splat(0.0);
            for entry in linear.reduced.list(c) {
                a = a + self.work[entry.at] * entry.by_pivot;
            }
            let [mut du, mut dv] = [Lane::splat(0.0); 2];
            for (at, factor) in prepared.along.list(c) {
                let [u, v] = self.predicted[*at];
                (du, dv) = (du + u * *factor, dv + v * *factor);
            }
            if let Some(moving) = &self.moving {
                let ([g0, v0], [g1, v1]) = (moving.start[c], moving.end[c]);
                (du, dv) = (du + (g1 - g0), dv + (v1 - v0));
            }
            let [r, rdot, s] = start.contacts[c];
            let line = &self.lines[part][c];
            let (change, rate) = (du + a * d2, rdot + dv + a * d1);
            (contact.change, contact.rate) = (change, rate);
            let [of_r, of_s] = [r * line.by_displacement, s * line.by_force];
            let of_bounce = rdot * line.by_bounce;
            self.trial[c] =
                change * line.by_change + rate * line.by_rate + (of_r + of_s + of_bounce);
            let terms = [of_r, of_s, of_bounce].map(|x| x.map(f64::abs));
            let [du, dv, rdot, a] = [du, dv, rdot, a].map(|x| x.map(f64::abs));
            contact.size = (du + a * d2) * line.by_change
                + (rdot + dv + a * d1) * line.by_rate
                + (terms[0] + terms[1] + terms[2]);
        }
        if self.knows {
            self.know(part);
        }
        if self.impacts.is_some() {
            self.activate(part);
        }
        let contacts = &self.contacts;
        let size = |c: usize, l: usize| contacts[c].size.0[l];
        self.forces[part].solve(end, &self.trial, size, &mut self.force);
        if self.two_limits.is_some() {
            self.break_loose(part, end);
        }
        if !self.curved.is_empty() {
            self.meet_curved(part, end);
        }
        for (c, force) in self.force.iter().enumerate() {
            let part = *force * forces[1];
            for entry in linear.reduced.list(c) {
                self.work[entry.at] = self.work[entry.at] - part * entry.value;
            }
        }
    }

    /// The forces of laws that know r'.
    pub(super) fn know(&mut self, part: usize) {
        let forces = &mut self.forces[part];
        for (c, contact) in self.contacts.iter().enumerate() {
            let [mut low, mut high] = contact.bounds;
            for l in (0..L).filter(|l| contact.known[*l]) {
                let (least, most) = (low.0[l], high.0[l]);
                let free = self.trial[c].0[l] / contact.softness.0[l];
                let raised = if free < least { least } else { free };
                let s = if raised > most { most } else { raised };
                (low.0[l], high.0[l]) = (s, s);
            }
            forces.bound(c, [low, high]);
        }
        forces.hold();
    }
}
