//! What an answer gives of a motion, and the quantities that follow from it.

use super::answer::Answer;
use super::asked::{Asked, S, U, V};
use crate::contact::ClippedLine;
use crate::problem::structure::channels::channel::{Energy, Number, Quantity};
use crate::problem::structure::motions::derived;
use crate::problem::structure::motions::recorded::Recorded;
use crate::solve::Unsolvable;
use crate::system::structure::Structure;

/// Share of the motion that is still rest, and of the forces that is still equilibrium.
const REST: f64 = 1e-6;
const HELD: f64 = 0.01;

/// A motion by a program, as far as it was asked for. What was not is 0.
pub(super) struct Known<'a> {
    pub(super) structure: &'a Structure,
    pub(super) dt: f64,
    pub(super) steps: usize,
    /// u and v of the nodes and S of the contacts at the instants; empty where it was not asked for.
    series: [Vec<Vec<f64>>; 3],
    /// u, v and a of the supports at the instants.
    supports: Vec<[Vec<f64>; 3]>,
}

impl<'a> Known<'a> {
    /// The channels of an answer.
    ///
    /// # Errors
    /// One is missing, or has another length.
    pub(super) fn new(
        structure: &'a Structure,
        asked: &Asked,
        (dt, steps): (f64, usize),
        answer: &mut Answer,
    ) -> Result<Known<'a>, String> {
        let (nodes, contacts) = (structure.len(), structure.contacts.len());
        let mut series = [nodes, nodes, contacts].map(|count| vec![Vec::new(); count]);
        for (kind, index, name) in asked.channels(structure) {
            series[kind][index] = answer.take(&name, steps + 1)?;
        }
        let supports = structure.supports.iter().map(|support| {
            let at: Vec<[f64; 3]> = (0..=steps)
                .map(|i| support.motion.at(i as f64 * dt))
                .collect();
            [0, 1, 2].map(|which| at.iter().map(|motion| motion[which]).collect())
        });
        Ok(Known {
            structure,
            dt,
            steps,
            supports: supports.collect(),
            series,
        })
    }

    fn value(&self, kind: usize, index: usize, i: usize) -> f64 {
        self.series[kind][index].get(i).copied().unwrap_or(0.0)
    }

    /// u (`which` = 0) or v (1) of a node, or of a support after the nodes.
    fn total(&self, which: usize, node: usize, i: usize) -> f64 {
        match node.checked_sub(self.structure.len()) {
            Some(support) => self.supports[support][which][i],
            None => self.value([U, V][which], node, i),
        }
    }

    /// The same of a node beside what the supports carry.
    pub(super) fn rest(&self, which: usize, node: usize, i: usize) -> f64 {
        let supports = self.structure.supports.iter().zip(&self.supports);
        let carried = supports.map(|(support, motion)| support.carried[node] * motion[which][i]);
        carried.fold(self.value([U, V][which], node, i), |rest, x| rest - x)
    }

    /// What supports add to r or rdot of a contact beside what they carry.
    pub(super) fn moved_gap(&self, contact: usize, which: usize, i: usize) -> f64 {
        let supports = self.structure.supports.iter().zip(&self.supports);
        let moved = supports.map(|(support, motion)| support.gaps[contact] * motion[which][i]);
        moved.sum()
    }

    /// r or rdot of a contact.
    pub(super) fn relative(&self, contact: usize, which: usize, i: usize) -> f64 {
        let of_contact = &self.structure.contacts[contact];
        let along = of_contact.along.iter();
        let sum = along.fold(0.0, |sum, (node, x)| sum + x * self.rest(which, *node, i));
        let gap = if which == 0 { of_contact.gap } else { 0.0 };
        sum + gap + self.moved_gap(contact, which, i)
    }

    /// S of a contact.
    pub(super) fn force(&self, contact: usize, i: usize) -> f64 {
        self.value(S, contact, i)
    }

    /// These quantities of the motion, of which `energies` gives the energies.
    ///
    /// # Errors
    /// One does not follow from it.
    pub(super) fn recorded(
        &self,
        numbers: &[Number],
        energies: &dyn Fn(Energy) -> Vec<f64>,
    ) -> Result<Recorded, Unsolvable> {
        let derived: Vec<_> = numbers.iter().filter_map(Number::derived).collect();
        let mut terms = derived::terms(self.structure, &derived)?.into_iter();
        let mut all_series = Vec::with_capacity(numbers.len());
        for number in numbers {
            let instants = 0..=self.steps;
            all_series.push(match number {
                Number::Derived(_) => {
                    let sum = terms.next().unwrap_or_default();
                    let of_time = sum.at_steps(self.dt, self.steps);
                    let value = |i: usize| {
                        sum.value(
                            |node| self.rest(0, node, i),
                            |node| self.rest(1, node, i),
                            |contact| self.force(contact, i),
                            of_time[i],
                        )
                    };
                    instants.map(value).collect()
                }
                Number::Energy(energy) => energies(*energy),
                Number::Displacement(_)
                | Number::Velocity(_)
                | Number::Acceleration(_)
                | Number::Contact(..) => match self.given(*number) {
                    Some(values) => values.to_vec(),
                    None => instants.map(|i| self.number(*number, i)).collect(),
                },
            });
        }
        Ok(Recorded::new(numbers, all_series, self.steps + 1))
    }

    /// A quantity that a channel of the answer is.
    fn given(&self, number: Number) -> Option<&[f64]> {
        let series = match number {
            Number::Displacement(node) => self.series[U].get(node),
            Number::Velocity(node) => self.series[V].get(node),
            Number::Contact(contact, Quantity::Force | Quantity::Size)
                if number.directions().is_none() =>
            {
                Some(&self.series[S][contact])
            }
            Number::Contact(..)
            | Number::Acceleration(_)
            | Number::Derived(_)
            | Number::Energy(_) => None,
        };
        series
            .map(Vec::as_slice)
            .filter(|values| !values.is_empty())
    }

    /// A quantity at an instant.
    fn number(&self, number: Number, i: usize) -> f64 {
        if let Some([first, second]) = number.directions() {
            return libm::hypot(self.number(first, i), self.number(second, i));
        }
        match number {
            Number::Displacement(node) => self.total(0, node, i),
            Number::Velocity(node) => self.total(1, node, i),
            Number::Acceleration(support) => {
                let motion = &self.structure.supports[support].motion;
                motion.shown_acceleration_at(i as f64 * self.dt)
            }
            Number::Derived(_) | Number::Energy(_) => f64::NAN,
            Number::Contact(contact, quantity) => {
                let law = &self.structure.contacts[contact].law;
                match quantity {
                    Quantity::Displacement | Quantity::Distance => self.relative(contact, 0, i),
                    Quantity::Velocity | Quantity::Speed => self.relative(contact, 1, i),
                    Quantity::Force | Quantity::Size => self.force(contact, i),
                    Quantity::Slip | Quantity::SlipDistance => {
                        let r = self.relative(contact, 0, i);
                        match law.line() {
                            Some(ClippedLine::Elastic { stiffness }) => {
                                r - self.force(contact, i) / stiffness
                            }
                            _ => r,
                        }
                    }
                    Quantity::Limit => law.limit().map_or(0.0, |limit| {
                        let motion = |node| [self.rest(0, node, i), self.rest(1, node, i)];
                        limit.pressed_in(i as f64 * self.dt, |c| self.force(c, i), motion)
                    }),
                }
            }
        }
    }

    /// Whether a channel has no value at some instant.
    pub(super) fn has_null(&self) -> bool {
        let mut values = self.series.iter().flatten().flatten();
        values.any(|x| x.is_nan())
    }

    /// Whether a body rests at the end although the forces on it are not in equilibrium.
    pub(super) fn has_unheld(&self) -> bool {
        let structure = self.structure;
        let (n, last) = (structure.len(), self.steps);
        let start = last - (last / 10).max(2).min(last);
        let peak = |node: usize, range: std::ops::RangeInclusive<usize>| {
            range.fold(0.0, |peak: f64, i| peak.max(self.value(V, node, i).abs()))
        };
        let fastest = (0..n).fold(0.0, |most: f64, node| most.max(peak(node, 0..=last)));
        let mut missing = vec![0.0; n];
        let mut sizes = vec![0.0; n];
        let mut add = |node: usize, force: f64| {
            missing[node] += force;
            sizes[node] += f64::abs(force);
        };
        let t = last as f64 * self.dt;
        for load in &structure.loads {
            let value = load.signal.at(t);
            load.pattern
                .iter()
                .for_each(|(node, x)| add(*node, x * value));
        }
        for (which, matrix) in [(0, &structure.stiffness), (1, &structure.damping)] {
            for ((i, j), value) in matrix.entries() {
                add(i, -value * self.rest(which, j, last));
                if i != j {
                    add(j, -value * self.rest(which, i, last));
                }
            }
        }
        for (c, contact) in structure.contacts.iter().enumerate() {
            let force = self.force(c, last);
            contact
                .along
                .iter()
                .for_each(|(node, x)| add(*node, -x * force));
        }
        (0..n).any(|node| {
            structure.nodes[node].mass > 0.0
                && peak(node, start..=last) <= REST * fastest
                && missing[node].abs() > HELD * sizes[node]
        })
    }
}
