//! Dampers that creep: S = c |rdot|^a sgn rdot with a < 1 is steep at rest.
//!
//! There S is what the other forces leave, and rdot follows at the rate b^T M^-1 b dS/drdot: explicit steps would have to be much
//! shorter than they change. Here S at the points of Radau is the unknown, with rdot = g(S), the inverse of the law, which is flat at
//! rest. The other forces follow by substitution. A step in two parts tells the error.

use super::structure::Moving;
use super::substitute::combine;
use crate::exact::adaptive::Flow;
use crate::exact::adaptive::radau::{NODES, POINTS, eliminate, weights};
use crate::exact::adaptive::watched::Motion;

/// Rates in a step from which on a damper creeps, and below which it does not.
const STEEP: f64 = 2.0;
const FAST: f64 = 0.3;

/// Change of S over the largest one so far, up to which it is sought.
const TARGET: f64 = 1e-14;

/// Most corrections: from above, one takes a part a of S away.
const CORRECTIONS: usize = 150;

/// Round-off of a relative velocity over the velocities.
const ROUND_OFF: f64 = 1e-15;

impl Moving<'_> {
    /// The dampers that creep.
    pub(crate) fn creeping(&self) -> Vec<usize> {
        let creeps = self.creeps.iter().enumerate();
        let creeping = creeps.filter(|(_, creep)| creep.as_ref().is_some_and(|creep| creep.creeps));
        creeping.map(|(contact, _)| contact).collect()
    }

    /// A step of h in one part and in two; the largest difference of their S at the end, and its round-off, by what it changes rdot in the
    /// step over the largest rdot: soon after rdot = 0 S is a power of time, and no better known than time is.
    pub(crate) fn creep(
        &mut self,
        [t, h]: [f64; 2],
        y: &[f64],
        [whole, end]: [&mut [f64]; 2],
    ) -> [f64; 2] {
        let contacts = self.creeping();
        let start = self.start_forces(&contacts);
        let half = 0.5 * h;
        let mut middle = vec![0.0; y.len()];
        let found = self
            .collocate([t, h], y, (&contacts, &start), whole)
            .and_then(|one| {
                let first = self.collocate([t, half], y, (&contacts, &start), &mut middle)?;
                let second = (&contacts[..], &first[..]);
                let two = self.collocate([t + half, half], &middle, second, end)?;
                Some([one, two])
            });
        let Some([one, two]) = found else {
            return [f64::INFINITY, 1.0];
        };
        let [mut error, mut round_off] = [0.0, 0.0];
        for (c, contact) in contacts.iter().enumerate() {
            let Motion { sizes, .. } = self.motion(*contact, t + h, end);
            let flexibility = self.model.own_flexibility(*contact);
            let Some(creep) = &mut self.creeps[*contact] else {
                continue;
            };
            creep.tried = two[c];
            let fastest = creep.fastest.max(sizes[1]).max(self.least[1]);
            let by_force = h * flexibility * (one[c] - two[c]).abs();
            error = f64::max(error, by_force / fastest.max(f64::MIN_POSITIVE));
            round_off = f64::max(round_off, ROUND_OFF * sizes[1] / fastest);
        }
        [error, round_off]
    }

    fn start_forces(&self, contacts: &[usize]) -> Vec<f64> {
        let forces = contacts
            .iter()
            .map(|contact| self.creeps[*contact].as_ref());
        forces
            .map(|creep| creep.map_or(0.0, |creep| creep.force))
            .collect()
    }

    /// The end of a step from these forces, and those at the end; `None` if no forces are found.
    fn collocate(
        &mut self,
        [t, h]: [f64; 2],
        y: &[f64],
        (contacts, start): (&[usize], &[f64]),
        end: &mut [f64],
    ) -> Option<Vec<f64>> {
        let weights = weights();
        let p = contacts.len();
        let m = p * POINTS;
        let flexibility = self.model.flexibility(contacts);
        let mut states = vec![y.to_vec(); POINTS];
        let mut forces = vec![start.to_vec(); POINTS];
        let mut rates = vec![vec![0.0; y.len()]; POINTS];
        let mut good = 0;
        for _ in 0..CORRECTIONS {
            for i in 0..POINTS {
                self.impose_creep(contacts, |c| Some(forces[i][c]));
                self.rates(t + NODES[i] * h, &states[i], &mut rates[i]);
            }
            self.impose_creep(contacts, |_| None);
            combine(&mut states, y, h, &weights, &rates);
            let (mut matrix, mut rest) = (vec![0.0; m * m], vec![0.0; m]);
            let mut is_small = vec![false; m];
            for i in 0..POINTS {
                let time = t + NODES[i] * h;
                for (c, contact) in contacts.iter().enumerate() {
                    let row = i * p + c;
                    let law = self.model.structure.contacts[*contact].law.as_given();
                    let [rate, slope] = law.properties().rate_under(forces[i][c])?;
                    let Motion { values, sizes } = self.motion(*contact, time, &states[i]);
                    rest[row] = values[1] - rate;
                    is_small[row] = rest[row].abs() <= ROUND_OFF * sizes[1];
                    for (j, weight) in weights[i].iter().enumerate() {
                        for other in 0..p {
                            let by_force = h * weight * flexibility[c * p + other];
                            matrix[row * m + j * p + other] = by_force;
                        }
                    }
                    matrix[row * m + row] += slope;
                }
            }
            if !eliminate(&mut matrix, &mut rest) {
                return None;
            }
            let mut is_near = true;
            for (row, change) in rest.into_iter().enumerate() {
                let (force, contact) = (&mut forces[row / p][row % p], contacts[row % p]);
                *force += change;
                let creep = self.creeps[contact].as_ref();
                let largest = creep.map_or(0.0, |creep| creep.largest).max(force.abs());
                is_near &= is_small[row] || change.abs() <= TARGET * largest;
            }
            good = if is_near { good + 1 } else { 0 };
            if good == 2 {
                end.copy_from_slice(&states[POINTS - 1]);
                return forces.pop();
            }
        }
        None
    }

    /// Takes the end of a step at a time: which dampers creep from there.
    pub(crate) fn commit_creeps(&mut self, t: f64, y: &[f64]) {
        let h = t - self.t;
        for contact in 0..self.creeps.len() {
            if self.creeps[contact].is_none() {
                continue;
            }
            let Motion { values, sizes } = self.motion(contact, t, y);
            let flexibility = self.model.own_flexibility(contact);
            let law = self.model.structure.contacts[contact].law.as_given();
            let follows = self.contacts[contact].force(values, None, None);
            let Some(creep) = &mut self.creeps[contact] else {
                continue;
            };
            creep.force = creep.force().unwrap_or(follows);
            creep.tried = creep.force;
            creep.largest = creep.largest.max(creep.force.abs());
            creep.fastest = creep.fastest.max(sizes[1]);
            let slope = law.properties().rate_under(creep.force);
            let rates = h * flexibility / slope.map_or(0.0, |[_, slope]| slope);
            // Not a number at rest at the start.
            let most = if creep.creeps { FAST } else { STEEP };
            creep.creeps = rates.is_nan() || rates > most;
        }
    }

    fn impose_creep(&mut self, contacts: &[usize], force: impl Fn(usize) -> Option<f64>) {
        for (c, contact) in contacts.iter().enumerate() {
            if let Some(creep) = &mut self.creeps[*contact] {
                creep.imposed = force(c);
            }
        }
    }
}
