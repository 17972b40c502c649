//! A step of structures in lanes.

use super::stages::{General, Stage, predict};
use crate::lane::Lane;
use crate::methods::SubStep;
use crate::solve::structure::contacts::laws::friction;
use crate::solve::structure::linear_part::linear::Linear;
use crate::solve::structure::linear_part::links::{Elimination, Link};
use slipgap_contact::for_wide;

impl<const L: usize> General<'_, L> {
    /// One step; `step` is the number of its end.
    pub(in crate::solve::structure) fn step(&mut self, step: usize) {
        self.step = step;
        let parts = self.prepared.sub_steps.len();
        self.stages.swap(0, parts);
        for part in 0..parts {
            let end = (step - 1) * parts + part + 1;
            match self.pressing.take() {
                Some(pressing) => self.repeat(part, end, pressing),
                None => self.sub_step(part, end),
            }
        }
    }

    /// The sub-step `part` of a step with the limits that are known; `end` is the number of its end among all sub-steps.
    pub(super) fn sub_step(&mut self, part: usize, end: usize) {
        // A constant, so that no form is compiled that is not used.
        match const { L == 1 } {
            true => sub_step_alone(self, part, end),
            false => sub_step_wide(self, part, end),
        }
    }

    #[inline(always)]
    fn compute(&mut self, part: usize, end: usize) {
        self.prescribe(part, end);
        self.eliminate(part);
        self.meet(part, end);
        self.substitute(part);
        self.touch(part + 1);
        if !self.prepared.between.is_empty() {
            self.move_between(part);
        }
        if self.impacts.is_some() {
            self.rest(part);
        }
    }

    /// Loads, limits, and the motion without a'.
    #[inline(always)]
    fn prescribe(&mut self, part: usize, end: usize) {
        let linear: &Linear = &self.prepared.sub_steps[part];
        let sub_step = &linear.sub_step;
        if let Some(moving) = &mut self.moving {
            moving.advance(end);
            self.stages[part + 1].gaps.clone_from(&moving.end);
        }
        if end > 1 && self.inputs.loads_jump() {
            self.jump(part, end - 1);
        }
        if self.corrections.is_some() {
            self.correct(part, end);
        }
        let moved = self
            .corrections
            .as_ref()
            .map(|corrections| &corrections.moved);
        let (first, start) = (&self.stages[0], &self.stages[part]);
        let [w, m0] = [sub_step.weights[1], sub_step.inertia[0]];
        for (i, mass) in self.prepared.mass.iter().enumerate() {
            let [u, v, a] = start.nodes[i];
            let [mut du, dv] = predict(sub_step, first.nodes[i], [u, v, a]);
            if let Some(moved) = moved {
                du = du + moved[i];
            }
            self.predicted[i] = [du, dv];
            self.weighted[i] = [u + du * w, v + dv * w];
            self.work[i] = a * (-m0 * mass);
        }
        if !self.prepared.coupled_mass.is_empty() {
            self.add_coupled_inertia(part, -m0);
        }
        self.inputs.add_weighted(end, &mut self.work);
        let s0 = sub_step.forces[0];
        if s0 != 0.0 {
            let along = self.prepared.along.iter();
            for ([_, _, force], along) in self.stages[part].contacts.iter().zip(along) {
                let part = *force * s0;
                for (at, factor) in along {
                    self.work[*at] = self.work[*at] - part * *factor;
                }
            }
        }
        if !self.prepared.massless.is_empty() {
            self.prescribe_massless(part, end);
        }
        if self.inputs.limits_vary() {
            let forces = &mut self.forces[part];
            for (number, (contact, slides)) in self.inputs.varying().enumerate() {
                let limit = match &self.pressing {
                    Some(pressing) => pressing.limit(number),
                    None => self.inputs.limit(number, end, |_, _| 0.0, |_, _| [0.0; 2]),
                };
                let [mut low, mut high] = self.contacts[contact].bounds;
                for (l, _) in slides.iter().enumerate().filter(|(_, slides)| **slides) {
                    [low.0[l], high.0[l]] = friction(limit.0[l]);
                }
                self.contacts[contact].bounds = [low, high];
                forces.bound(contact, [low, high]);
                let curved = self.curved.get_mut(part).into_iter().flatten().enumerate();
                for (l, curved) in curved {
                    if let (Some(curved), true) = (curved, slides[l]) {
                        curved.limit(contact, limit.0[l]);
                    }
                }
                if let Some(friction) = &mut self.two_limits {
                    friction.limit(contact, limit);
                }
            }
            forces.hold();
        }
        if self.two_limits.is_some() {
            self.begin_friction(part);
        }
    }

    /// A jump of the loads changes the accelerations at the start of a sub-step.
    #[cold]
    fn jump(&mut self, part: usize, end: usize) {
        self.work.fill(Lane::splat(0.0));
        self.inputs.add_jumps(end, &mut self.work);
        self.divide_by_mass();
        for (node, jump) in self.stages[part].nodes.iter_mut().zip(&self.work) {
            node[2] = node[2] + *jump;
        }
    }

    /// L y = w0 p + w1 p' - B s0 S - m0 M a - C v_e - K u_e.
    #[inline(always)]
    fn eliminate(&mut self, part: usize) {
        let linear = &self.prepared.sub_steps[part];
        let (at, work) = (&self.weighted[..], &mut self.work[..]);
        let flow = |from: usize, to: usize, k: f64, c: f64| {
            let ([u0, v0], [u1, v1]) = (at[from], at[to]);
            (u1 - u0) * k + (v1 - v0) * c
        };
        for link in &linear.elimination.links {
            let ([from, to], Link { k, c, .. }) = (link.ends(), *link);
            let flow = flow(from, to, k, c);
            work[from] = work[from] + flow;
            work[to] = work[to] - flow;
        }
        for coupling in &linear.couplings {
            let ([from, to], Link { k, c, .. }) = (coupling.ends(), *coupling);
            let force = |of: usize| at[of][0] * k + at[of][1] * c;
            work[from] = work[from] - force(to);
            work[to] = work[to] - force(from);
        }
        let Elimination {
            rows, more, blocks, ..
        } = &linear.elimination;
        for (i, row) in rows.iter().enumerate() {
            let flow = flow(i, row.to, row.k, row.c);
            let q = work[i] + flow;
            work[i] = q;
            work[row.to] = work[row.to] - flow - q * row.l;
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

    /// D L^T a' = y, and the motion at the end.
    #[inline(always)]
    fn substitute(&mut self, part: usize) {
        let prepared = self.prepared;
        let linear = &prepared.sub_steps[part];
        let SubStep { d1, d2, .. } = linear.sub_step;
        if let Some(ground) = self.work.last_mut() {
            *ground = Lane::splat(0.0);
        }
        let work = &mut self.work[..];
        let (before, after) = self.stages.split_at_mut(part + 1);
        let (start, end) = (&before[part].nodes[..], &mut after[0].nodes[..]);
        let predicted = &self.predicted;
        let moved = |i: usize, a: Lane<L>| {
            let ([u, v, _], [du, dv]) = (start[i], predicted[i]);
            [u + (du + a * d2), v + (dv + a * d1), a]
        };
        let Elimination {
            rows, more, blocks, ..
        } = &linear.elimination;
        if let Some(blocks) = blocks {
            blocks.substitute(work);
            for (i, a) in work.iter().enumerate() {
                end[i] = moved(i, *a);
            }
        }
        for (i, row) in rows.iter().enumerate().rev() {
            let mut a = work[i] * row.reciprocal - work[row.to] * row.l;
            if row.more {
                for entry in more.column(i) {
                    a = a - work[entry.at] * entry.value;
                }
            }
            work[i] = a;
            end[i] = moved(i, a);
        }
        for node in &prepared.massless {
            let [u, _, _] = start[node.place];
            let change = self.work[node.place] * d2;
            let rate = change * (1.0 / linear.sub_step.length);
            end[node.place] = [u + change, rate, Lane::splat(0.0)];
        }
        let contacts = after[0].contacts.iter_mut();
        for ([_, _, s], force) in contacts.zip(&self.force) {
            *s = *force;
        }
    }

    /// The contacts at a stage.
    #[inline(always)]
    pub(super) fn touch(&mut self, stage: usize) {
        let Stage {
            nodes,
            contacts,
            gaps: moved,
        } = &mut self.stages[stage];
        let gaps = self.contacts.iter().zip(self.prepared.along.iter());
        for ([r, rdot, _], (contact, along)) in contacts.iter_mut().zip(gaps) {
            let [mut u, mut v] = [Lane::splat(0.0); 2];
            for (at, factor) in along {
                u = u + nodes[*at][0] * *factor;
                v = v + nodes[*at][1] * *factor;
            }
            (*r, *rdot) = (u + contact.gap, v);
        }
        for ([r, rdot, _], [gap, rate]) in contacts.iter_mut().zip(moved) {
            (*r, *rdot) = (*r + *gap, *rdot + *rate);
        }
    }
}

// Functions of their own: every caller would compile the sub-step again.
for_wide! {
    fn sub_step_wide<const L: usize>(state: &mut General<L>, part: usize, end: usize) {
        state.compute(part, end);
    }
}

/// One structure by itself gains nothing from wide instructions; its large blocks take them by themselves.
#[inline(never)]
fn sub_step_alone<const L: usize>(state: &mut General<L>, part: usize, end: usize) {
    state.compute(part, end);
}
