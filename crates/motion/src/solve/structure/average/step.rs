//! A step by the constant average acceleration method, in lanes.

use super::lane_state::{Average, ContactState};
use crate::lane::Lane;
use crate::solve::structure::contacts::laws::friction;
use crate::solve::structure::contacts::static_friction::StaticFriction;
use crate::solve::structure::contacts::static_in_plane::Admissible;
use crate::solve::structure::linear_part::links::{Elimination, Link};

impl<const L: usize> Average<'_, L> {
    /// The step with the limits that are known.
    #[inline(always)]
    pub(super) fn compute(&mut self, step: usize) {
        self.prescribe(step);
        self.eliminate();
        self.meet(step);
        self.substitute();
        self.touch();
        if !self.prepared.between.is_empty() {
            self.move_between();
        }
    }

    /// Loads and limits.
    #[inline(always)]
    fn prescribe(&mut self, step: usize) {
        self.work.fill(Lane::splat(0.0));
        self.inputs.add_loads(step, &mut self.work);
        for (contact, along) in self.contacts.iter().zip(self.prepared.along.iter()) {
            let mean = contact.force * 0.5;
            for (at, factor) in along {
                self.work[*at] = self.work[*at] - mean * *factor;
            }
        }
        if !self.prepared.massless.is_empty() {
            self.prescribe_massless(step);
        }
        if self.inputs.limits_vary() {
            for (number, (contact, slides)) in self.inputs.varying().enumerate() {
                let limit = match &self.pressing {
                    Some(pressing) => pressing.limit(number),
                    None => self.inputs.limit(number, step, |_, _| 0.0, |_, _| [0.0; 2]),
                };
                let [mut low, mut high] = self.forces.bounds(contact);
                for (l, _) in slides.iter().enumerate().filter(|(_, slides)| **slides) {
                    [low.0[l], high.0[l]] = friction(limit.0[l]);
                }
                self.forces.bound(contact, [low, high]);
                for (l, curved) in self.curved.iter_mut().enumerate() {
                    if let (Some(curved), true) = (curved, slides[l]) {
                        curved.limit(contact, limit.0[l]);
                    }
                }
                if let Some(friction) = &mut self.two_limits {
                    friction.limit(contact, limit);
                }
            }
            self.forces.hold();
        }
        if self.two_limits.is_some() {
            self.begin_friction();
        }
    }

    /// Bounds of contacts with two limits.
    #[cold]
    fn begin_friction(&mut self) {
        let Some(friction) = &mut self.two_limits else {
            return;
        };
        for limits in friction.all() {
            let (c, l) = (limits.contact, limits.lane);
            let bounds = limits.begin(Some(self.contacts[c].force.0[l]));
            self.forces.bound_lane([c, l], bounds);
            if let Some(Some(curved)) = self.curved.get_mut(l) {
                curved.bound(c, Admissible::Between(bounds));
            }
        }
        for limits in friction.planes() {
            let (first, l) = (limits.first, limits.lane);
            let start = [first, first + 1].map(|c| self.contacts[c].force.0[l]);
            if let Some(Some(curved)) = self.curved.get_mut(l) {
                curved.bound(first, Admissible::Disc(limits.begin(Some(start))));
            }
        }
        self.forces.hold();
    }

    /// Finds the forces again as long as contacts break loose, of lanes whose laws are clipped lines.
    #[cold]
    fn break_loose(&mut self, step: usize) {
        let Some(friction) = &mut self.two_limits else {
            return;
        };
        let contacts = &self.contacts;
        let size = |c: usize, l: usize| size(&contacts[c], l);
        let lines = |l: usize| !matches!(self.curved.get(l), Some(Some(_)));
        for l in (0..L).filter(|l| lines(*l)) {
            while friction.break_loose(
                l,
                |c| self.force[c].0[l],
                |c, bounds| {
                    self.forces.bound_lane([c, l], bounds);
                },
            ) {
                self.forces
                    .solve_lane([l, step], &self.trial, &size, &mut self.force);
            }
        }
    }

    /// The mean forces of contacts with two limits, which the next step starts with.
    #[cold]
    fn end_friction(&mut self) {
        for limits in self.two_limits.iter_mut().flat_map(StaticFriction::all) {
            let force = &mut self.contacts[limits.contact].force.0[limits.lane];
            *force = limits.end(*force);
        }
        for limits in self.two_limits.iter_mut().flat_map(StaticFriction::planes) {
            let (first, l) = (limits.first, limits.lane);
            let force = limits.end([first, first + 1].map(|c| self.contacts[c].force.0[l]));
            for (contact, force) in self.contacts[first..].iter_mut().zip(force) {
                contact.force.0[l] = force;
            }
        }
    }

    /// L y = (p(i) + p(i+1))/2 - B S(i)/2 - K P(i) - C W(i)/dt.
    #[inline(always)]
    fn eliminate(&mut self) {
        let prepared = self.prepared;
        let (p, w, work) = (&self.p[..], &self.w[..], &mut self.work[..]);
        for link in &prepared.elimination.links {
            let ([from, to], Link { k, c, .. }) = (link.ends(), *link);
            let flow = (p[to] - p[from]) * k + (w[to] - w[from]) * c;
            work[from] = work[from] + flow;
            work[to] = work[to] - flow;
        }
        for coupling in &prepared.couplings {
            let ([from, to], Link { k, c, .. }) = (coupling.ends(), *coupling);
            work[from] = work[from] - (p[to] * k + w[to] * c);
            work[to] = work[to] - (p[from] * k + w[from] * c);
        }
        let Elimination {
            rows, more, blocks, ..
        } = &prepared.elimination;
        for (i, row) in rows.iter().enumerate() {
            let to = row.to;
            let flow = (p[to] - p[i]) * row.k + (w[to] - w[i]) * row.c;
            let q = work[i] + flow;
            work[i] = q;
            work[to] = work[to] - flow - q * row.l;
            if row.more {
                for entry in more.column(i).iter().rev() {
                    work[entry.at] = work[entry.at] - q * entry.value;
                }
            }
        }
        if let Some(blocks) = blocks {
            blocks.eliminate(work);
        }
    }

    /// The forces S(i+1), and y of the whole step.
    #[inline(always)]
    fn meet(&mut self, step: usize) {
        let reduced = &self.prepared.reduced;
        for (c, contact) in self.contacts.iter_mut().enumerate() {
            let mut change = Lane::splat(0.0);
            for entry in reduced.list(c) {
                change = change + self.work[entry.at] * entry.by_pivot;
            }
            let line = &contact.line;
            contact.change = change;
            self.trial[c] = change * 0.5
                + contact.w * line.by_increment
                + (contact.p * line.by_displacement + contact.force * line.by_force);
        }
        if self.moving.is_some() {
            self.move_gaps(step);
        }
        if !self.curved.is_empty() {
            self.try_lines();
        }
        let contacts = &self.contacts;
        let size = |c: usize, l: usize| size(&contacts[c], l);
        self.forces.solve(step, &self.trial, size, &mut self.force);
        if self.two_limits.is_some() {
            self.break_loose(step);
        }
        if !self.curved.is_empty() {
            self.meet_curved(step);
        }
        for (c, contact) in self.contacts.iter_mut().enumerate() {
            let force = self.force[c];
            contact.force = force;
            let mean = force * 0.5;
            for entry in reduced.list(c) {
                self.work[entry.at] = self.work[entry.at] - mean * entry.value;
            }
        }
        if self.two_limits.is_some() {
            self.end_friction();
        }
    }

    /// D L^T (W(i+1) - W(i)) = y.
    #[inline(always)]
    fn substitute(&mut self) {
        let prepared = self.prepared;
        // The ground does not move.
        if let Some(ground) = self.work.last_mut() {
            *ground = Lane::splat(0.0);
        }
        let (p, w, work) = (&mut self.p[..], &mut self.w[..], &mut self.work[..]);
        let Elimination {
            rows, more, blocks, ..
        } = &prepared.elimination;
        if let Some(blocks) = blocks {
            blocks.substitute(work);
            for ((p, w), x) in p.iter_mut().zip(w.iter_mut()).zip(&*work) {
                *w = *w + *x;
                *p = *p + *w;
            }
        }
        for (i, row) in rows.iter().enumerate().rev() {
            let mut x = work[i] * row.reciprocal - work[row.to] * row.l;
            if row.more {
                for entry in more.column(i) {
                    x = x - work[entry.at] * entry.value;
                }
            }
            work[i] = x;
            w[i] = w[i] + x;
            p[i] = p[i] + w[i];
        }
        if !prepared.massless.is_empty() {
            self.move_massless();
        }
    }

    /// The contacts after the step.
    #[inline(always)]
    pub(crate) fn touch(&mut self) {
        for (contact, along) in self.contacts.iter_mut().zip(self.prepared.along.iter()) {
            let (mut p, mut w) = (Lane::splat(0.0), Lane::splat(0.0));
            for (at, factor) in along {
                p = p + self.p[*at] * *factor;
                w = w + self.w[*at] * *factor;
            }
            (contact.p, contact.w) = (p + contact.gap, w);
        }
        if self.moving.is_some() {
            self.add_gaps();
        }
    }
}

/// The size of the terms of d of a contact in a lane.
#[inline(always)]
pub(crate) fn size<const L: usize>(contact: &ContactState<L>, l: usize) -> f64 {
    let line = &contact.line;
    let terms = [
        contact.change * 0.5,
        contact.w * line.by_increment,
        contact.p * line.by_displacement,
        contact.force * line.by_force,
    ];
    terms.iter().map(|x| x.0[l].abs()).sum()
}
