//! Rigid stops on which impulses act: which of them are active in a step, and the overlap that remains.

use super::contacts::LaneContact;
use super::stepper::General;
use crate::contact::CoupledForces;
use crate::lane::Lane;
use crate::solve::structure::Prepared;

/// What rigid stops and Coulomb friction of the method of Moreau and Jean need.
#[derive(Debug)]
pub(super) struct Impacts<const L: usize> {
    /// The stops that are active in the step.
    active: Vec<[bool; L]>,
    /// What separates overlaps, with B^T M^-1 B.
    separations: Vec<CoupledForces>,
    /// Numbers of one lane: d, low, high, size, force.
    scratch: [Vec<f64>; 5],
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
        let between = &prepared.between;
        let sign = |c: usize, place: usize| {
            let [i, j] = between[c];
            f64::from(u8::from(place == j)) - f64::from(u8::from(place == i))
        };
        let entry = |(a, b): (usize, usize)| -> f64 {
            let own = between[a].into_iter();
            let terms = own.filter_map(|place| {
                let mass = prepared.mass.get(place)?;
                Some(sign(a, place) * sign(b, place) / mass)
            });
            terms.sum()
        };
        let pairs = (0..m).flat_map(|a| (0..m).map(move |b| (a, b)));
        let matrix: Vec<f64> = pairs.map(entry).collect();
        Some(Impacts {
            active: vec![[false; L]; m],
            separations: vec![CoupledForces::new(matrix, m); L],
            scratch: std::array::from_fn(|_| vec![0.0; m]),
            with: (0..=prepared.nodes()).collect(),
        })
    }

    pub(super) fn is_active(&self, contact: usize, lane: usize) -> bool {
        self.active[contact][lane]
    }
}

impl<const L: usize> General<'_, L> {
    /// Makes the stops active that would overlap at the end of the step without forces.
    pub(super) fn activate(&mut self, part: usize) {
        let Some(impacts) = &mut self.impacts else {
            return;
        };
        let start = &self.stages[part].contacts;
        let mut changed = false;
        for (c, contact) in self.contacts.iter().enumerate() {
            let before = impacts.active[c];
            for l in (0..L).filter(|l| contact.stop[*l]) {
                impacts.active[c][l] = start[c][0].0[l] + contact.change.0[l] < 0.0;
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

    /// Makes the stops active, too, that overlap at the end of the step because of the forces on others. Each round has more active
    /// stops, so that there are at most as many rounds as stops.
    pub(super) fn activate_more(&mut self, part: usize, end: usize) {
        let linear = &self.prepared.sub_steps[part];
        let Some(impacts) = &mut self.impacts else {
            return;
        };
        if linear.sub_step.is_explicit() {
            // Forces do not move the ends of the step.
            return;
        }
        let m = self.contacts.len();
        let start = &self.stages[part].contacts;
        for l in 0..L {
            loop {
                let mut more = false;
                for (c, contact) in self.contacts.iter().enumerate() {
                    if !contact.stop[l] || impacts.active[c][l] {
                        continue;
                    }
                    let row = &linear.flexibility[c * m..(c + 1) * m];
                    let terms = row.iter().zip(&self.force).map(|(h, s)| h * s.0[l]);
                    let r = start[c][0].0[l] + contact.change.0[l] - terms.sum::<f64>();
                    if r < 0.0 {
                        impacts.active[c][l] = true;
                        let bounds = contact.bounds_with(&impacts.active[c]);
                        self.forces[part].rebound(c, bounds);
                        more = true;
                    }
                }
                if !more {
                    break;
                }
                self.forces[part].hold();
                let contacts = &self.contacts;
                let size = |c: usize, l: usize| contacts[c].size.0[l];
                self.forces[part].solve_lane([l, end], &self.trial, &size, &mut self.force);
            }
        }
    }

    /// After a step: contacts at rest have equal velocities, and stops do not overlap.
    pub(super) fn rest(&mut self, part: usize, end: usize) {
        let mut moved = false;
        for l in 0..L {
            moved |= self.join(part, l);
        }
        if moved {
            self.touch(part + 1);
        }
        let mut separated = false;
        for l in 0..L {
            separated |= self.separate([part, l, end]);
        }
        if separated {
            self.touch(part + 1);
        }
    }

    /// Moves nodes of stops that overlap by more than round-off apart, by as little as possible in the norm of M: M u changes by
    /// -B Y with Y <= 0 <= r, and Y = 0 where r > 0.
    fn separate(&mut self, [part, l, end]: [usize; 3]) -> bool {
        let Some(impacts) = &mut self.impacts else {
            return false;
        };
        let between = &self.prepared.between;
        let stage = &mut self.stages[part + 1];
        let [d, low, high, sizes, out] = &mut impacts.scratch;
        let mut overlaps = false;
        for (c, contact) in self.contacts.iter().enumerate() {
            let stop = contact.stop[l];
            let [i, j] = between[c].map(|place| stage.nodes[place][0].0[l].abs());
            let size = i + j + contact.gap.0[l].abs();
            let r = stage.contacts[c][0].0[l];
            overlaps |= stop && r < -4.0 * f64::EPSILON * size;
            (d[c], sizes[c]) = (r, size);
            (low[c], high[c]) = (if stop { f64::NEG_INFINITY } else { 0.0 }, 0.0);
        }
        if !overlaps {
            return false;
        }
        if let Err(why) = impacts.separations[l].solve(d, low, high, sizes, out) {
            // A motion that is not finite is no fault of the contacts.
            if d.iter().all(|d| d.is_finite()) {
                self.forces[part].fail(l, end, why);
            }
            return false;
        }
        for (y, places) in out.iter().zip(between) {
            for (place, sign) in places.iter().zip([1.0, -1.0]) {
                if let Some(mass) = self.prepared.mass.get(*place) {
                    stage.nodes[*place][0].0[l] += sign * y / mass;
                }
            }
        }
        true
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
