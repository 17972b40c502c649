//! Energies of the state, and the work of its last step.

use super::stages::{General, predict};
use crate::lane::Lane;
use crate::methods::ContactWork;
use crate::solve::structure::Work;

/// What a step did.
#[derive(Debug, Clone, Copy)]
pub(in crate::solve::structure) struct StepWork<const L: usize> {
    /// Work of the loads less that of the dashpots and contacts, each with its mean over a sub-step.
    pub(in crate::solve::structure) supplied: Lane<L>,
    /// Work of the forces that the equations of the sub-steps leave unbalanced, on the displacements of these equations.
    pub(in crate::solve::structure) unbalanced: Lane<L>,
}

impl<const L: usize> General<'_, L> {
    /// The work of the last step; adds that of each contact to `contacts`, and gives the others to `each`. `room` has
    /// a number for each place.
    pub(in crate::solve::structure) fn work_of_step(
        &self,
        contacts: &mut [Lane<L>],
        room: &mut [Lane<L>],
        mut each: impl FnMut(Work, Lane<L>),
    ) -> StepWork<L> {
        let zero = Lane::splat(0.0);
        let (mut supplied, mut unbalanced) = (zero, zero);
        let parts = self.prepared.sub_steps.len();
        for (part, linear) in self.prepared.sub_steps.iter().enumerate() {
            let sub_step = &linear.sub_step;
            let number = (self.step - 1) * parts + part + 1;
            let (first, start) = (&self.stages[0], &self.stages[part]);
            let end = &self.stages[part + 1];
            let [w0, w1] = sub_step.weights;
            let [m0, m1] = sub_step.inertia;
            let [s0, s1] = sub_step.forces;
            // The displacement of the equation.
            let massless: Vec<usize> = self
                .prepared
                .massless
                .iter()
                .map(|node| node.place)
                .collect();
            let moved = |row: usize| {
                if massless.contains(&row) {
                    return end.nodes[row][0] - start.nodes[row][0];
                }
                let [mut du, _] = predict(sub_step, first.nodes[row], start.nodes[row]);
                if let Some(corrections) = &self.corrections {
                    du = du + corrections.moved[row];
                }
                du + end.nodes[row][2] * sub_step.d2
            };
            let by = |row: usize, k: usize| end.nodes[row][k] - start.nodes[row][k];
            room.fill(zero);
            self.inputs.add_loads(number, room);
            for (at, load) in room.iter().enumerate() {
                let work = *load * by(at, 0);
                each(Work::Loads, work);
                supplied = supplied + work;
            }
            room.fill(zero);
            self.inputs.add_weighted(number, room);
            for (at, mass) in self.prepared.mass.iter().enumerate() {
                let a = start.nodes[at][2] * m0 + end.nodes[at][2] * m1;
                unbalanced = unbalanced + (room[at] - a * *mass) * moved(at);
            }
            for (i, j, mass) in &self.prepared.coupled_mass {
                let a = |at: usize| start.nodes[at][2] * m0 + end.nodes[at][2] * m1;
                unbalanced = unbalanced - (a(*i) * moved(*j) + a(*j) * moved(*i)) * *mass;
            }
            for link in linear.elimination.all_links() {
                let [from, to] = link.ends();
                let difference = |of: &dyn Fn(usize) -> Lane<L>| of(to) - of(from);
                let du = difference(&moved);
                let u = difference(&|at| start.nodes[at][0]) + du * w1;
                let [v, v_end] = [start, end].map(|stage| difference(&|at| stage.nodes[at][1]));
                unbalanced = unbalanced - du * (u * link.k + (v * w0 + v_end * w1) * link.c);
                let mean = (v + v_end) * 0.5;
                let work = mean * difference(&|at| by(at, 0)) * link.c;
                each(Work::Damping, work);
                supplied = supplied - work;
            }
            for coupling in &linear.couplings {
                let [from, to] = coupling.ends();
                for (at, other) in [(from, to), (to, from)] {
                    let u = start.nodes[other][0] + moved(other) * w1;
                    let [v, v_end] = [start, end].map(|stage| stage.nodes[other][1]);
                    let force = u * coupling.k + (v * w0 + v_end * w1) * coupling.c;
                    unbalanced = unbalanced - moved(at) * force;
                    let work = (v + v_end) * by(at, 0) * (0.5 * coupling.c);
                    each(Work::Damping, work);
                    supplied = supplied - work;
                }
            }
            for (c, work) in contacts.iter_mut().enumerate() {
                let step = self.contact_work(part, c);
                *work = *work + step;
                supplied = supplied - step;
                if self.moving.is_some() {
                    let work = self.work_of_supports(part, c);
                    each(Work::Supports, work);
                    supplied = supplied + work;
                }
                let mut change = zero;
                for (at, factor) in self.prepared.along.list(c) {
                    change = change + moved(*at) * *factor;
                }
                let [s, s_end] = [start, end].map(|stage| stage.contacts[c][2]);
                let force = s * s0 + s_end * s1;
                unbalanced = unbalanced - force * change;
            }
        }
        StepWork {
            supplied,
            unbalanced,
        }
    }

    /// The work of the structure on a contact in a sub-step of the last step.
    #[inline(always)]
    fn contact_work(&self, part: usize, c: usize) -> Lane<L> {
        let ends = [part, part + 1].map(|stage| {
            let [r, rdot, _] = self.stages[stage].contacts[c];
            [r, rdot]
        });
        self.work_over(part, c, ends)
    }

    /// The work of the supports on a contact in a sub-step of the last step, by which they move its gap.
    fn work_of_supports(&self, part: usize, c: usize) -> Lane<L> {
        self.work_over(
            part,
            c,
            [part, part + 1].map(|stage| self.stages[stage].gaps[c]),
        )
    }

    /// The work of the force of a contact in a sub-step over displacements and velocities at its ends.
    #[inline(always)]
    fn work_over(&self, part: usize, c: usize, ends: [[Lane<L>; 2]; 2]) -> Lane<L> {
        let length = self.prepared.sub_steps[part].sub_step.length;
        let [[r, rdot], [r_end, rdot_end]] = ends;
        let [s, s_end] = [part, part + 1].map(|stage| self.stages[stage].contacts[c][2]);
        let by = |form: ContactWork<L>| {
            form.force([s, s_end]) * form.displacement([r, r_end], [rdot, rdot_end])
        };
        let mut step = by(ContactWork::Trapezoids);
        let impulse = by(ContactWork::Impulses(Lane::splat(length)));
        for (l, by_velocity) in self.contacts[c].by_velocity.iter().enumerate() {
            step.0[l] = if *by_velocity {
                impulse.0[l]
            } else {
                step.0[l]
            };
        }
        step
    }

    /// Adds the work on each contact in the last step.
    pub(in crate::solve::structure) fn add_contact_work(&self, works: &mut [Lane<L>]) {
        for part in 0..self.prepared.sub_steps.len() {
            for (c, work) in works.iter_mut().enumerate() {
                *work = *work + self.contact_work(part, c);
            }
        }
    }

    /// Kinetic and strain energy, without the contacts.
    pub(in crate::solve::structure) fn energy(&self) -> Lane<L> {
        self.add_twice_strain(self.twice_kinetic()) * 0.5
    }

    /// Both by themselves.
    pub(in crate::solve::structure) fn kinetic_and_strain(&self) -> [Lane<L>; 2] {
        [
            self.twice_kinetic() * 0.5,
            self.add_twice_strain(Lane::splat(0.0)) * 0.5,
        ]
    }

    #[inline(always)]
    fn twice_kinetic(&self) -> Lane<L> {
        let nodes = &self.last().nodes;
        let mut twice = Lane::splat(0.0);
        for ([_, v, _], mass) in nodes.iter().zip(&self.prepared.mass) {
            twice = twice + *v * *v * *mass;
        }
        for (i, j, mass) in &self.prepared.coupled_mass {
            twice = twice + nodes[*i][1] * nodes[*j][1] * (2.0 * mass);
        }
        twice
    }

    #[inline(always)]
    fn add_twice_strain(&self, mut twice: Lane<L>) -> Lane<L> {
        let nodes = &self.last().nodes;
        for link in self.prepared.sub_steps[0].elimination.all_links() {
            let [from, to] = link.ends();
            let change = nodes[to][0] - nodes[from][0];
            twice = twice + change * change * link.k;
        }
        for coupling in &self.prepared.sub_steps[0].couplings {
            let [u, other] = coupling.ends().map(|at| nodes[at][0]);
            twice = twice + u * other * (2.0 * coupling.k);
        }
        twice
    }

    /// Energy that the contacts store.
    pub(in crate::solve::structure) fn stored_energy(&self) -> Lane<L> {
        let mut twice = Lane::splat(0.0);
        for (contact, [_, _, s]) in self.contacts.iter().zip(&self.last().contacts) {
            twice = twice + *s * *s * contact.softness;
        }
        self.curved_energy(twice * 0.5)
    }
}
