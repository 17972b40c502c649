//! Energy books of a run, and the work of each contact.

use super::State;
use crate::lane::Lane;

/// Energy books of L structures: the method fulfils, with the means over a step,
///
/// ```text
/// E(i+1) - E(i) = du^T p_mean - dt v_mean^T C v_mean - S_mean^T dr
/// ```
///
/// for the kinetic and strain energy E without the contacts, to round-off and for any forces.
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
    /// Sum of the right sides.
    supplied: Lane<L>,
    /// Largest difference of both sides, summed up to a step.
    difference: Lane<L>,
    /// Largest energy.
    largest: Lane<L>,
    work: Vec<Lane<L>>,
}

impl<const L: usize> Books<L> {
    /// Books from the state at t = 0 on.
    pub fn new(start: &State<L>) -> Self {
        let zero = Lane::splat(0.0);
        let energy = start.energy();
        Books {
            nodes: start.w.iter().map(|w| [zero, *w]).collect(),
            loads: vec![zero; start.w.len()],
            contacts: start.contact_states().collect(),
            start: energy,
            supplied: zero,
            difference: zero,
            largest: energy + start.stored_energy(),
            work: vec![zero; start.contacts()],
        }
    }

    /// Adds the step to `state`.
    #[inline(always)]
    pub fn add(&mut self, state: &State<L>) {
        let prepared = state.prepared;
        for ([change, w], now) in self.nodes.iter_mut().zip(&state.w) {
            // du = dt v_mean
            (*change, *w) = ((*w + *now) * 0.5, *now);
        }
        let mut supplied = self.supplied;
        let change = |place: usize| self.nodes[place][0];
        self.loads.fill(Lane::splat(0.0));
        state.inputs.add_loads(state.step, &mut self.loads);
        for (load, [change, _]) in self.loads.iter().zip(&self.nodes) {
            supplied = supplied + *load * *change;
        }
        for link in prepared.all_links() {
            let change = change(link.to) - change(link.from);
            supplied = supplied - change * change * link.c;
        }
        let contacts = self.contacts.iter_mut().zip(&mut self.work);
        for ((before, work), [r, s]) in contacts.zip(state.contact_states()) {
            let step = (before[1] + s) * 0.5 * (r - before[0]);
            *work = *work + step;
            supplied = supplied - step;
            *before = [r, s];
        }
        self.supplied = supplied;
        let energy = state.energy();
        let difference = energy - self.start - supplied;
        self.difference = self.difference.larger(difference.map(f64::abs));
        self.largest = self.largest.larger(energy + state.stored_energy());
    }

    /// Largest difference of the books at any step, over the largest energy: kinetic, strain, and what the contacts store. NaN
    /// if there never is any energy.
    pub fn energy_error(&self) -> Lane<L> {
        self.difference.zip(self.largest, |d, e| d / e)
    }

    /// Work of the structure on a contact, the integral of S dr, with the mean force of each step.
    pub fn work(&self, contact: usize) -> Lane<L> {
        self.work[contact]
    }
}

impl<const L: usize> State<'_, L> {
    /// Kinetic and strain energy, without the contacts.
    #[inline(always)]
    pub fn energy(&self) -> Lane<L> {
        let u = |place: usize| self.p[place] - self.w[place] * 0.5;
        let mut twice = Lane::splat(0.0);
        for (w, inertia) in self.w.iter().zip(&self.prepared.inertia) {
            twice = twice + *w * *w * *inertia;
        }
        for link in self.prepared.all_links() {
            let change = u(link.to) - u(link.from);
            twice = twice + change * change * link.k;
        }
        twice * 0.5
    }

    /// Energy that the contacts store.
    #[inline(always)]
    pub fn stored_energy(&self) -> Lane<L> {
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
