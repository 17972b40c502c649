//! Energies by kind over a run.

use crate::contact::StoredEnergy;
use crate::lane::Lane;
use crate::solve::structure::{Books, State, Work};
use crate::system::structure::Structure;

/// Energies by kind of L structures after each step. Their sum is the energy at t = 0 and the work of the loads and supports since.
#[derive(Debug)]
pub struct Ledger<'a, const L: usize> {
    structures: &'a [&'a Structure; L],
    books: Books<L>,
    /// Work of the loads, and that of supports on gaps that they move.
    input: Lane<L>,
    /// Work on dashpots.
    damping: Lane<L>,
    kinetic: Lane<L>,
    strain: Lane<L>,
    /// Energy that each contact stores at t = 0 and now.
    stored: Vec<[Lane<L>; 2]>,
    /// Kinetic and elastic energy at t = 0.
    start: Lane<L>,
}

impl<'a, const L: usize> Ledger<'a, L> {
    /// From the state of these structures at t = 0 on.
    pub fn new(structures: &'a [&'a Structure; L], start: &State<L>) -> Self {
        let zero = Lane::splat(0.0);
        let [kinetic, strain] = start.kinetic_and_strain();
        let mut ledger = Ledger {
            structures,
            books: Books::new(start),
            input: zero,
            damping: zero,
            kinetic,
            strain,
            stored: vec![[zero; 2]; start.contacts()],
            start: zero,
        };
        ledger.store(start);
        for [first, now] in &mut ledger.stored {
            *first = *now;
        }
        ledger.start = ledger.kinetic() + ledger.elastic();
        ledger
    }

    /// Adds the step to `state`.
    pub fn add(&mut self, state: &State<L>) {
        let (mut input, mut damping) = (self.input, self.damping);
        self.books.add_by_kind(state, |kind, work| match kind {
            Work::Loads | Work::Supports => input = input + work,
            Work::Damping => damping = damping + work,
        });
        (self.input, self.damping) = (input, damping);
        [self.kinetic, self.strain] = state.kinetic_and_strain();
        self.store(state);
    }

    /// What each contact stores.
    fn store(&mut self, state: &State<L>) {
        for (c, [_, now]) in self.stored.iter_mut().enumerate() {
            let step = state.contact(c);
            for (l, structure) in self.structures.iter().enumerate() {
                let law = structure.contacts[c].law.law(1.0);
                now.0[l] = law.stored_energy(step.displacement.0[l], step.force.0[l]);
            }
        }
    }

    /// Kinetic energy.
    pub fn kinetic(&self) -> Lane<L> {
        self.kinetic
    }

    /// Energy of K and of the contacts.
    pub fn elastic(&self) -> Lane<L> {
        let stored = self.stored.iter();
        stored.fold(self.strain, |sum, [_, now]| sum + *now)
    }

    /// Energy that C dissipated.
    pub fn damping(&self) -> Lane<L> {
        self.damping
    }

    /// Energy that a contact dissipated.
    pub fn dissipated(&self, contact: usize) -> Lane<L> {
        let [first, now] = self.stored[contact];
        self.books.work(contact) - (now - first)
    }

    /// Energy that all contacts dissipated.
    pub fn contacts(&self) -> Lane<L> {
        let contacts = 0..self.stored.len();
        contacts.fold(Lane::splat(0.0), |sum, c| sum + self.dissipated(c))
    }

    /// Energy that the method took.
    pub fn method(&self) -> Lane<L> {
        self.books.numerical_dissipation()
    }

    /// The energy at t = 0 and the work of loads and supports.
    pub fn input(&self) -> Lane<L> {
        self.start + self.input
    }
}
