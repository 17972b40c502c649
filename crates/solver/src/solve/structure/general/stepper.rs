//! A step of structures in lanes.

use super::contacts::{LaneContact, LaneLine};
use super::corrections::Corrections;
use super::impacts::Impacts;
use crate::lane::Lane;
use crate::methods::SubStep;
use crate::solve::Unsolvable;
use crate::solve::structure::Prepared;
use crate::solve::structure::curved::Curved;
use crate::solve::structure::forces::Forces;
use crate::solve::structure::laws::friction;
use crate::solve::structure::linear::Linear;
use crate::solve::structure::links::{Elimination, Link};
use crate::solve::structure::loads::Inputs;
use crate::solve::structure::moving::Moving;
use crate::solve::structure::static_friction::StaticFriction;

/// The state of L structures after a step.
#[derive(Debug)]
pub(in crate::solve::structure) struct General<'a, const L: usize> {
    pub(in crate::solve::structure) prepared: &'a Prepared,
    /// The motion at the start of the last step, and at the end of each of its sub-steps.
    pub(super) stages: Vec<Stage<L>>,
    pub(super) contacts: Vec<LaneContact<L>>,
    /// The lines of the contacts, and what finds their forces, for each sub-step.
    pub(super) lines: Vec<Vec<LaneLine<L>>>,
    pub(super) forces: Vec<Forces<L>>,
    /// The contacts of lanes with laws that are not clipped lines, for each sub-step; empty if there is none.
    pub(super) curved: Vec<Vec<Option<Curved>>>,
    pub(super) inputs: Inputs<L>,
    /// Rigid stops with impulses; `None` without any.
    pub(super) impacts: Option<Impacts<L>>,
    /// Rigid stops that correct displacements; `None` without any.
    pub(super) corrections: Option<Box<Corrections<L>>>,
    /// Whether a law gives S' before r' is known.
    pub(super) knows: bool,
    /// The last step.
    pub(super) step: usize,
    /// u* - u and v* - v, u_e and v_e, by place; the last one is the ground.
    pub(super) predicted: Vec<[Lane<L>; 2]>,
    pub(super) weighted: Vec<[Lane<L>; 2]>,
    /// Right side, then a'.
    pub(super) work: Vec<Lane<L>>,
    pub(super) trial: Vec<Lane<L>>,
    pub(super) force: Vec<Lane<L>>,
    /// Supports that move.
    pub(in crate::solve::structure) moving: Option<Moving<L>>,
    /// Why a lane cannot start.
    pub(super) refused: [Option<Unsolvable>; L],
    /// Friction with two limits.
    pub(super) two_limits: Option<StaticFriction>,
}

/// The motion at one time.
#[derive(Debug, Clone)]
pub(super) struct Stage<const L: usize> {
    /// u, v, a by place; the last one is the ground, which does not move.
    pub(super) nodes: Vec<[Lane<L>; 3]>,
    /// r, rdot, S of the contacts.
    pub(super) contacts: Vec<[Lane<L>; 3]>,
    /// What supports moved the gaps, and the rates of it; empty without supports that move.
    pub(super) gaps: Vec<[Lane<L>; 2]>,
}

/// u* - u and v* - v of a place.
#[inline(always)]
pub(super) fn predict<const L: usize>(
    sub_step: &SubStep,
    first: [Lane<L>; 3],
    [u, v, a]: [Lane<L>; 3],
) -> [Lane<L>; 2] {
    let mut du = v * sub_step.u_v + a * sub_step.u_a;
    let mut dv = a * sub_step.v_a;
    if let Some([by_u, by_v]) = sub_step.u_before {
        let moved = v - first[1];
        du = du + (u - first[0]) * by_u + moved * by_v;
        dv = dv + moved * sub_step.v_d;
    }
    [du, dv]
}

impl<const L: usize> General<'_, L> {
    /// One step; `step` is the number of its end.
    #[inline(always)]
    pub(in crate::solve::structure) fn step(&mut self, step: usize) {
        self.step = step;
        let parts = self.prepared.sub_steps.len();
        self.stages.swap(0, parts);
        for part in 0..parts {
            self.sub_step(part, (step - 1) * parts + part + 1);
        }
    }

    /// The sub-step `part` of a step; `end` is the number of its end among all sub-steps.
    #[inline(always)]
    fn sub_step(&mut self, part: usize, end: usize) {
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
            let start = &self.stages[part].contacts;
            let force = |contact: usize| start[contact][2];
            let nodes = &self.stages[part].nodes;
            let place = &self.prepared.place;
            let motion = |node: usize| [nodes[place[node]][0], nodes[place[node]][1]];
            for (contact, limit, slides) in self.inputs.limits(end, force, motion) {
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

    /// Bounds of contacts with two limits: S' is the mean over the step.
    #[cold]
    fn begin_friction(&mut self, part: usize) {
        for own in self.two_limits.iter_mut().flat_map(StaticFriction::all) {
            let bounds = own.begin(None);
            self.contacts[own.contact].bound_lane(own.lane, bounds);
            self.forces[part].bound_lane([own.contact, own.lane], bounds);
        }
        self.forces[part].hold();
    }

    /// Finds the forces again as long as contacts break loose.
    #[cold]
    fn break_loose(&mut self, part: usize, end: usize) {
        let Some(friction) = &mut self.two_limits else {
            return;
        };
        let (contacts, forces) = (&mut self.contacts, &mut self.forces[part]);
        for l in 0..L {
            loop {
                let bound = |c: usize, bounds: [f64; 2]| {
                    contacts[c].bound_lane(l, bounds);
                    forces.bound_lane([c, l], bounds);
                };
                if !friction.break_loose(l, |c| self.force[c].0[l], bound) {
                    break;
                }
                let size = |c: usize, l: usize| contacts[c].size.0[l];
                forces.solve_lane([l, end], &self.trial, &size, &mut self.force);
            }
        }
        for own in friction.all() {
            own.end(self.force[own.contact].0[own.lane]);
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
            let Link { from, to, k, c } = *link;
            let flow = flow(from, to, k, c);
            work[from] = work[from] + flow;
            work[to] = work[to] - flow;
        }
        for coupling in &linear.couplings {
            let Link { from, to, k, c } = *coupling;
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

    /// The forces S', and y with them.
    #[inline(always)]
    fn meet(&mut self, part: usize, end: usize) {
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
    fn know(&mut self, part: usize) {
        let forces = &mut self.forces[part];
        for (c, contact) in self.contacts.iter().enumerate() {
            let [mut low, mut high] = contact.bounds;
            for l in (0..L).filter(|l| contact.known[*l]) {
                let s = self.trial[c].0[l] / contact.softness.0[l];
                let s = if s < low.0[l] { low.0[l] } else { s };
                let s = if s > high.0[l] { high.0[l] } else { s };
                (low.0[l], high.0[l]) = (s, s);
            }
            forces.bound(c, [low, high]);
        }
        forces.hold();
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
