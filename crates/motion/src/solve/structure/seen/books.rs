//! Energy books of a run, and the work of each contact.

use super::step_view::Kind;
use crate::lane::Lane;
use crate::solve::structure::State;
use crate::solve::structure::average::lane_state::Average;
use crate::solve::structure::linear_part::links::Link;
use crate::solve::structure::linear_part::massless::Massless;

/// Energy books of L structures. For the kinetic and strain energy E without the contacts
///
/// ```text
/// E(i+1) - E(i) = du^T p_mean - du^T C v_mean - S_mean^T dr - (numerical dissipation of the step)
/// ```
///
/// with the means of both ends of a step (of each sub-step). With supports that move, u is the rest w beside what the supports carry,
/// and the work of the supports on moving gaps, S_mean^T dG, is added on the right. The constant average acceleration method has no numerical dissipation:
/// both sides differ by round-off for any forces. An impulse does its work on the mean of the velocities before and after it.
///
/// For the other methods the energy error is the work of the unbalanced forces of the equations that they solve, which is round-off,
/// too.
#[derive(Debug, Clone)]
pub struct Books<const L: usize> {
    /// The change of u over the last step, and dt v after it.
    nodes: Vec<[Lane<L>; 2]>,
    /// Means of the loads by place over the last step.
    loads: Vec<Lane<L>>,
    /// r and S of the contacts after the last step.
    contacts: Vec<[Lane<L>; 2]>,
    /// Energy at t = 0.
    start: Lane<L>,
    /// Energy after the last step.
    energy: Lane<L>,
    /// Sum of the right sides.
    supplied: Lane<L>,
    /// Sum of the works of unbalanced forces.
    unbalanced: Lane<L>,
    /// Largest error, summed up to a step.
    difference: Lane<L>,
    /// Largest energy, at least that of [`State::least_energy`].
    largest: Lane<L>,
    work: Vec<Lane<L>>,
}

/// A kind of work in the books besides that of contacts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Work {
    /// Of the loads on the structure.
    Loads,
    /// Of supports on gaps that they move.
    Supports,
    /// Of the structure on dashpots.
    Damping,
}

impl<const L: usize> Books<L> {
    /// Books from the state at t = 0 on.
    pub fn new(start: &State<L>) -> Self {
        let zero = Lane::splat(0.0);
        let energy = start.energy();
        let (nodes, contacts) = match &start.0 {
            Kind::Average(start) => (
                start.w.iter().map(|w| [zero, *w]).collect(),
                start.contact_states().collect(),
            ),
            // Their state has both ends of the last step.
            Kind::General(_) => (Vec::new(), Vec::new()),
        };
        Books {
            nodes,
            loads: vec![zero; start.nodes() + 1],
            contacts,
            start: energy,
            energy,
            supplied: zero,
            unbalanced: zero,
            difference: zero,
            largest: energy + start.stored_energy(),
            work: vec![zero; start.contacts()],
        }
    }

    /// Adds the step to `state`.
    #[inline(always)]
    pub fn add(&mut self, state: &State<L>) {
        self.add_by_kind(state, |_, _| {});
    }

    /// Adds the step to `state`; `each` gets its works by kind, but those of contacts ([`Books::work`]).
    #[inline(always)]
    pub fn add_by_kind(&mut self, state: &State<L>, each: impl FnMut(Work, Lane<L>)) {
        let difference = match &state.0 {
            Kind::Average(state) => self.add_average(state, each),
            Kind::General(state) => {
                let done = state.work_of_step(&mut self.work, &mut self.loads, each);
                self.supplied = self.supplied + done.supplied;
                self.unbalanced = self.unbalanced + done.unbalanced;
                self.energy = state.energy();
                self.unbalanced
            }
        };
        self.difference = self.difference.larger(difference.map(f64::abs));
        let energy = self.energy + state.stored_energy();
        self.largest = self.largest.larger(energy).larger(state.least_energy());
    }

    /// Adds a step by the constant average acceleration method. Returns the difference of both sides.
    #[inline(always)]
    fn add_average(&mut self, state: &Average<L>, mut each: impl FnMut(Work, Lane<L>)) -> Lane<L> {
        let prepared = state.prepared;
        for ([change, w], now) in self.nodes.iter_mut().zip(&state.w) {
            // du = dt v_mean
            (*change, *w) = ((*w + *now) * 0.5, *now);
        }
        // Those of nodes without mass are no states.
        for Massless { place, .. } in &prepared.massless {
            self.nodes[*place][0] = state.moved[*place];
        }
        let mut supplied = self.supplied;
        let change = |row: usize| self.nodes[row][0];
        self.loads.fill(Lane::splat(0.0));
        state.inputs.add_loads(state.step, &mut self.loads);
        for (load, [change, _]) in self.loads.iter().zip(&self.nodes) {
            let work = *load * *change;
            each(Work::Loads, work);
            supplied = supplied + work;
        }
        // Work and strain energy in one pass: one addition does not wait for the other.
        let energy =
            state.add_twice_strain(state.twice_kinetic(), |[from, to], link, is_spring| {
                let work = match is_spring {
                    true => {
                        let change = change(to) - change(from);
                        change * change * link.c
                    }
                    false => change(from) * change(to) * (2.0 * link.c),
                };
                each(Work::Damping, work);
                supplied = supplied - work;
            });
        let contacts = self.contacts.iter_mut().zip(&mut self.work);
        for (c, ((before, work), [r, s])) in contacts.zip(state.contact_states()).enumerate() {
            let mean = state.mean_force(c, [before[1], s]);
            let step = mean * (r - before[0]);
            *work = *work + step;
            supplied = supplied - step;
            if let Some(moving) = &state.moving {
                // Supports do the part of the work by which they move the gap.
                let work = mean * (moving.end[c][0] - moving.start[c][0]);
                each(Work::Supports, work);
                supplied = supplied + work;
            }
            *before = [r, s];
        }
        self.supplied = supplied;
        self.energy = energy * 0.5;
        self.energy - self.start - supplied
    }

    /// Largest error of the books at any step, over the largest energy: kinetic, strain, and what the contacts store, but at least a
    /// share of what the contact forces take from the motion in a step, so that a structure whose contacts stick has no ratio of
    /// round-offs. 0 if there never is any energy; NaN if an energy overflows.
    pub fn energy_error(&self) -> Lane<L> {
        self.over_largest(self.difference)
    }

    /// Energy that the method took from the structure up to the last step; below 0 where it added energy. Round-off for the constant
    /// average acceleration method.
    pub fn numerical_dissipation(&self) -> Lane<L> {
        self.start + self.supplied - self.energy
    }

    /// The same over the largest energy; 0 if there never is any energy, NaN if an energy overflows.
    pub fn relative_dissipation(&self) -> Lane<L> {
        self.over_largest(self.numerical_dissipation())
    }

    /// A part of the largest energy. A sum that overflowed is not finite any more, but a largest number ignores NaN: so the sums
    /// decide, too.
    fn over_largest(&self, part: Lane<L>) -> Lane<L> {
        let mut quotient = Lane::splat(f64::NAN);
        for (l, quotient) in quotient.0.iter_mut().enumerate() {
            let sums = [self.energy, self.supplied, self.unbalanced, self.largest];
            if sums.iter().all(|sum| sum.0[l].is_finite()) {
                *quotient = match self.largest.0[l] {
                    0.0 => 0.0,
                    largest => part.0[l] / largest,
                };
            }
        }
        quotient
    }

    /// Work of the structure on a contact, the integral of S dr, with the mean force of each step.
    pub fn work(&self, contact: usize) -> Lane<L> {
        self.work[contact]
    }
}

impl<const L: usize> Average<'_, L> {
    /// Kinetic and strain energy, without the contacts.
    #[inline(always)]
    pub(crate) fn energy(&self) -> Lane<L> {
        self.add_twice_strain(self.twice_kinetic(), |_, _, _| {}) * 0.5
    }

    /// Both by themselves.
    pub(crate) fn kinetic_and_strain(&self) -> [Lane<L>; 2] {
        [
            self.twice_kinetic() * 0.5,
            self.add_twice_strain(Lane::splat(0.0), |_, _, _| {}) * 0.5,
        ]
    }

    #[inline(always)]
    fn twice_kinetic(&self) -> Lane<L> {
        let mut twice = Lane::splat(0.0);
        for (w, inertia) in self.w.iter().zip(&self.prepared.inertia) {
            twice = twice + *w * *w * *inertia;
        }
        for (i, j, inertia) in &self.prepared.coupled_mass {
            twice = twice + self.w[*i] * self.w[*j] * (2.0 * inertia);
        }
        twice
    }

    /// `each` gets the ends of all springs, and then of all couplings.
    #[inline(always)]
    fn add_twice_strain(
        &self,
        mut twice: Lane<L>,
        mut each: impl FnMut([usize; 2], &Link, bool),
    ) -> Lane<L> {
        let u = |row: usize| self.p[row] - self.w[row] * 0.5;
        self.prepared.elimination.all_links().for_each(|link| {
            let [from, to] = link.ends();
            let change = u(to) - u(from);
            twice = twice + change * change * link.k;
            each([from, to], &link, true);
        });
        for coupling in &self.prepared.couplings {
            let [from, to] = coupling.ends();
            twice = twice + u(from) * u(to) * (2.0 * coupling.k);
            each([from, to], coupling, false);
        }
        twice
    }

    /// Energy that the contacts store.
    #[inline(always)]
    pub(crate) fn stored_energy(&self) -> Lane<L> {
        let mut twice = Lane::splat(0.0);
        for contact in &self.contacts {
            let line = &contact.line;
            // Springs: displacement-control, impact.
            let compliance = line.by_force + line.by_displacement * line.compliance;
            twice = twice + contact.force * contact.force * compliance;
        }
        let mut energy = twice * 0.5;
        for (l, curved) in self.curved.iter().enumerate() {
            if let Some(curved) = curved {
                let states = self.contact_states();
                energy.0[l] = curved.stored_energy(states.map(|state| state.map(|x| x.0[l])));
            }
        }
        energy
    }

    /// r and S of the contacts.
    #[inline(always)]
    fn contact_states(&self) -> impl Iterator<Item = [Lane<L>; 2]> + '_ {
        let states = self.contacts.iter();
        states.map(|contact| [contact.p - contact.w * 0.5, contact.force])
    }
}
