//! The balance of energy of a motion by a program: the books of the steps, by both ends of each.

use super::known::Known;
use crate::contact::StoredEnergy;
use crate::problem::structure::channels::channel::Energy;
use crate::problem::structure::motions::recorded::Energies;

/// Share of the largest energy by which it may be above what went in.
const GAIN: f64 = 0.01;

/// Energies at the instants.
pub(super) struct Balance {
    kinetic: Vec<f64>,
    strain: Vec<f64>,
    /// Dissipated by C since t = 0.
    damping: Vec<f64>,
    /// Work of the loads and the supports since t = 0.
    input: Vec<f64>,
    /// Work on each contact since t = 0, and what it stores.
    contacts: Vec<[Vec<f64>; 2]>,
}

impl Balance {
    /// That of a motion of which all u, v and S are known.
    pub(super) fn new(known: &Known) -> Balance {
        let structure = known.structure;
        let (n, count) = (structure.len(), known.steps + 1);
        let mass = structure.mass();
        let contacts = structure.contacts.len();
        let mut balance = Balance {
            kinetic: Vec::with_capacity(count),
            strain: Vec::with_capacity(count),
            damping: vec![0.0; count],
            input: vec![0.0; count],
            contacts: vec![[vec![0.0; count], vec![0.0; count]]; contacts],
        };
        let means: Vec<Vec<f64>> = structure
            .loads
            .iter()
            .map(|load| load.signal.step_means(known.dt, known.steps))
            .collect();
        let half = |matrix: &crate::system::structure::Symmetric, x: &[f64]| {
            let mut product = vec![0.0; n];
            matrix.add_product(x, &mut product);
            0.5 * dot(x, &product)
        };
        let (mut before, mut rate_before) = (vec![0.0; n], vec![0.0; n]);
        for i in 0..count {
            let u: Vec<f64> = (0..n).map(|node| known.rest(0, node, i)).collect();
            let v: Vec<f64> = (0..n).map(|node| known.rest(1, node, i)).collect();
            balance.kinetic.push(half(&mass, &v));
            balance.strain.push(half(&structure.stiffness, &u));
            for (c, contact) in structure.contacts.iter().enumerate() {
                let [r, s] = [known.relative(c, 0, i), known.force(c, i)];
                balance.contacts[c][1][i] = contact.law.law(1.0).stored_energy(r, s);
            }
            if i > 0 {
                let change: Vec<f64> = u
                    .iter()
                    .zip(&before)
                    .map(|(now, then)| now - then)
                    .collect();
                let mean: Vec<f64> = v
                    .iter()
                    .zip(&rate_before)
                    .map(|(a, b)| 0.5 * (a + b))
                    .collect();
                let mut drag = vec![0.0; n];
                structure.damping.add_product(&mean, &mut drag);
                balance.damping[i] = balance.damping[i - 1] + dot(&change, &drag);
                let loads = structure.loads.iter().zip(&means);
                let of_loads = loads.map(|(load, means)| {
                    let along = load.pattern.iter();
                    means[i] * along.map(|(node, x)| x * change[*node]).sum::<f64>()
                });
                let mut input = of_loads.sum::<f64>();
                for c in 0..contacts {
                    let force = 0.5 * (known.force(c, i - 1) + known.force(c, i));
                    let dr = known.relative(c, 0, i) - known.relative(c, 0, i - 1);
                    let of_contact = &mut balance.contacts[c][0];
                    of_contact[i] = of_contact[i - 1] + force * dr;
                    input += force * (known.moved_gap(c, 0, i) - known.moved_gap(c, 0, i - 1));
                }
                balance.input[i] = balance.input[i - 1] + input;
            }
            (before, rate_before) = (u, v);
        }
        balance
    }

    /// The largest energy: kinetic, strain, and in contacts.
    fn largest(&self) -> f64 {
        let instants = 0..self.kinetic.len();
        instants.fold(0.0, |most: f64, i| {
            most.max(self.kinetic[i] + self.elastic(i))
        })
    }

    fn stored(&self, i: usize) -> f64 {
        self.contacts.iter().map(|contact| contact[1][i]).sum()
    }

    fn elastic(&self, i: usize) -> f64 {
        self.strain[i] + self.stored(i)
    }

    /// What neither went in nor is anywhere.
    fn missing(&self, i: usize) -> f64 {
        let works = self.contacts.iter().map(|contact| contact[0][i]);
        let now = self.kinetic[i] + self.strain[i];
        let at_start = self.kinetic[0] + self.strain[0];
        at_start + self.input[i] - self.damping[i] - works.sum::<f64>() - now
    }

    /// Whether the energy is above what went in.
    pub(super) fn gains(&self) -> bool {
        let most = GAIN * self.largest();
        let energy = |i: usize| self.kinetic[i] + self.elastic(i);
        (1..self.kinetic.len()).any(|i| energy(i) - energy(0) - self.input[i] > most)
    }

    /// The largest difference of the books and the last one, over the largest energy.
    pub(super) fn energies(&self) -> Energies {
        let over = |part: f64| match self.largest() {
            0.0 => 0.0,
            largest => part / largest,
        };
        let instants = 0..self.kinetic.len();
        let error = instants.fold(0.0, |most: f64, i| most.max(self.missing(i).abs()));
        Energies {
            error: over(error),
            dissipation: over(self.missing(self.kinetic.len() - 1)),
        }
    }

    /// An energy at the instants.
    pub(super) fn series(&self, energy: Energy) -> Vec<f64> {
        let dissipated = |c: usize, i: usize| {
            let [work, stored] = &self.contacts[c];
            work[i] - (stored[i] - stored[0])
        };
        let value = |i: usize| match energy {
            Energy::Kinetic => self.kinetic[i],
            Energy::Elastic => self.elastic(i),
            Energy::Damping => self.damping[i],
            Energy::Contacts => (0..self.contacts.len()).map(|c| dissipated(c, i)).sum(),
            Energy::Method => self.missing(i),
            Energy::Input => self.kinetic[0] + self.elastic(0) + self.input[i],
            Energy::Contact(contact) => dissipated(contact, i),
        };
        (0..self.kinetic.len()).map(value).collect()
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
