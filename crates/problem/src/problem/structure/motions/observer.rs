//! Accelerations, forces and energies of a run by time steps, where a channel needs them.

use super::derived;
use super::terms::Terms;
use crate::lane::Lane;
use crate::problem::structure::channels::channel::{Derived, Energy, Number};
use crate::solve::Unsolvable;
use crate::solve::structure::{Ledger, State};
use crate::system::structure::Structure;

/// The quantities of L structures that are more than a part of their state.
pub struct Observer<'a, const L: usize> {
    structures: &'a [&'a Structure; L],
    sums: Vec<Sum<L>>,
    /// Energies with their places in a row of quantities.
    energies: Vec<(usize, Energy)>,
    ledger: Option<Ledger<'a, L>>,
}

/// A quantity that is a sum in each lane.
struct Sum<const L: usize> {
    /// Its place in a row of quantities.
    place: usize,
    terms: [Terms; L],
    /// Its functions of time at the steps.
    of_time: [Vec<f64>; L],
}

impl<'a, const L: usize> Observer<'a, L> {
    /// Those among these quantities, at 0, dt, .. steps dt; `None` if there are none.
    ///
    /// # Errors
    /// For each lane why one of them has no such quantity, or why another one has none.
    pub fn new(
        structures: &'a [&'a Structure; L],
        numbers: &[Number],
        dt: f64,
        steps: usize,
    ) -> Result<Option<Observer<'a, L>>, [Unsolvable; L]> {
        let places = || numbers.iter().enumerate();
        let wanted: Vec<(usize, Derived)> = places()
            .filter_map(|(column, number)| Some((column, number.derived()?)))
            .collect();
        let energies: Vec<(usize, Energy)> = places()
            .filter_map(|(column, number)| match number {
                Number::Energy(energy) => Some((column, *energy)),
                Number::Displacement(_)
                | Number::Velocity(_)
                | Number::Acceleration(_)
                | Number::Contact(..)
                | Number::Derived(_) => None,
            })
            .collect();
        if wanted.is_empty() && energies.is_empty() {
            return Ok(None);
        }
        let derived: Vec<Derived> = wanted.iter().map(|one| one.1).collect();
        let mut lanes = Vec::with_capacity(L);
        for structure in structures {
            // All have the same linear part, and so the same fault.
            let terms = derived::terms(structure, &derived)
                .map_err(|why| std::array::from_fn(|_| why.clone()))?;
            lanes.push(terms.into_iter());
        }
        let sums = wanted.iter().map(|(column, _)| {
            let mut of_lanes = lanes.iter_mut().map(|lane| lane.next().unwrap_or_default());
            let terms: [Terms; L] = std::array::from_fn(|_| of_lanes.next().unwrap_or_default());
            Sum {
                place: *column,
                of_time: std::array::from_fn(|l| terms[l].at_steps(dt, steps)),
                terms,
            }
        });
        Ok(Some(Observer {
            structures,
            sums: sums.collect(),
            energies,
            ledger: None,
        }))
    }

    /// Writes the quantities after a step to their places in a row.
    pub fn fill(&mut self, step: usize, state: &State<L>, row: &mut [Lane<L>]) {
        for sum in &self.sums {
            for (l, terms) in sum.terms.iter().enumerate() {
                row[sum.place].0[l] = terms.value(
                    |node| state.rest_displacement(node).0[l],
                    |node| state.rest_velocity(node).0[l],
                    |contact| state.contact(contact).force.0[l],
                    sum.of_time[l][step],
                );
            }
        }
        if self.energies.is_empty() {
            return;
        }
        let ledger = match &mut self.ledger {
            Some(ledger) => {
                ledger.add(state);
                ledger
            }
            none => none.insert(Ledger::new(self.structures, state)),
        };
        for (column, energy) in &self.energies {
            row[*column] = match energy {
                Energy::Kinetic => ledger.kinetic(),
                Energy::Elastic => ledger.elastic(),
                Energy::Damping => ledger.damping(),
                Energy::Contacts => ledger.contacts(),
                Energy::Method => ledger.method(),
                Energy::Input => ledger.input(),
                Energy::Contact(contact) => ledger.dissipated(*contact),
            };
        }
    }
}
