//! Functions of time in a study, as signals.

use super::amount::{self, Amount};
use super::chosen::{self, Chosen};
use super::signal_cache::SignalCache;
use crate::problem::numbers::parameter::{Value, shortest};
use crate::problem::{Case, Violation};
use crate::system::loads::cycles::Cycles;
use crate::system::loads::pulse::{Pulse, PulseFault};
use crate::system::loads::synthetic;
use crate::system::structure::{Signal, Table};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// A function of time. Cases with the same numbers share its signal, so that its samples are computed once.
#[derive(Debug, Clone)]
pub struct Source {
    kind: Kind,
    /// Byte offset and path in the study.
    place: (usize, String),
    made: Arc<Mutex<SignalCache>>,
}

/// The kinds of functions.
#[derive(Debug, Clone)]
pub enum Kind {
    /// amplitude sin(omega t + phase).
    Sine {
        /// Amplitude.
        amplitude: Amount,
        /// Circular frequency.
        omega: Amount,
        /// Phase; none for 0.
        phase: Option<Amount>,
    },
    /// Straight lines between points, constant beyond.
    Table {
        /// Times.
        t: Vec<Amount>,
        /// Values.
        f: Vec<Amount>,
    },
    /// A recorded acceleration in the study's units.
    Record {
        /// The file.
        name: Chosen,
        /// Rows of the parameters that choose the file, or how it is read.
        rows: Vec<usize>,
        /// All signals that a case may choose, by the values of these parameters.
        records: Vec<(Vec<Value>, Arc<Signal>)>,
    },
    /// A pulse of a form, with its numbers.
    Pulse(&'static Pulse, Vec<Amount>),
    /// A synthetic acceleration.
    Synthetic {
        /// Seed.
        seed: Amount,
        /// Circular frequency of the ground filter in rad/s; none for firm ground.
        omega: Option<Amount>,
    },
}

/// Largest seed of a synthetic acceleration.
pub const LARGEST_SEED: u32 = u32::MAX;

impl Source {
    /// A function at a place of the study.
    pub fn new(kind: Kind, origin: (usize, String)) -> Source {
        Source {
            kind,
            place: origin,
            made: Arc::default(),
        }
    }

    /// The kind of function.
    pub fn kind(&self) -> &Kind {
        &self.kind
    }

    /// Rows of the parameters that its seed contains.
    pub fn seed_rows(&self) -> &[usize] {
        match &self.kind {
            Kind::Synthetic { seed, .. } => match &seed.source {
                amount::Source::Expression(seed) => seed.formula.uses(),
                amount::Source::Number(_) => &[],
            },
            Kind::Sine { .. } | Kind::Table { .. } | Kind::Record { .. } | Kind::Pulse(..) => &[],
        }
    }

    /// The signal in a case. `metre` is the study's unit of length in m.
    pub fn signal(&self, case: &Case, metre: f64) -> Result<Arc<Signal>, Violation> {
        if let Kind::Record { rows, records, .. } = &self.kind {
            let chosen = chosen::place(rows, records, case);
            let none = || self.violation("no record with these parameters");
            return chosen.map(|i| records[i].1.clone()).ok_or_else(none);
        }
        let numbers = self.numbers(case)?;
        let points = self.points(&numbers)?;
        let cell = self.made().cell(&key(&numbers), points);
        let make = || {
            if self.is_sampled() {
                self.made().count += 1;
            }
            self.make(&numbers, metre).map(Arc::new)
        };
        cell.get_or_init(make).clone()
    }

    /// The whole cycles of the function in a case; none for one that does not oscillate in a known way.
    pub fn cycles(&self, case: &Case) -> Result<Vec<Cycles>, Violation> {
        let numbers = self.numbers(case)?;
        Ok(match (&self.kind, &numbers[..]) {
            (Kind::Sine { .. }, &[_, omega, phase]) => {
                Cycles::of_sine(omega, phase).into_iter().collect()
            }
            (Kind::Pulse(pulse, _), numbers) => pulse.cycles(numbers),
            _ => Vec::new(),
        })
    }

    /// What identifies the signal in a case among those of the function.
    pub fn key(&self, case: &Case) -> Result<Vec<u64>, Violation> {
        match &self.kind {
            Kind::Record { rows, records, .. } => {
                let chosen = chosen::place(rows, records, case);
                Ok(vec![chosen.unwrap_or(records.len()) as u64])
            }
            Kind::Sine { .. } | Kind::Table { .. } | Kind::Pulse(..) | Kind::Synthetic { .. } => {
                Ok(key(&self.numbers(case)?))
            }
        }
    }

    /// Every rule that the function breaks in a case; samples are not computed.
    pub fn check(&self, case: &Case, metre: f64) -> Result<(), Violation> {
        match self.is_sampled() {
            true => self.samples(case).map(|_| ()),
            false => self.signal(case, metre).map(|_| ()),
        }
    }

    /// Whether its signal is computed sample by sample.
    pub fn is_sampled(&self) -> bool {
        matches!(self.kind, Kind::Pulse(..) | Kind::Synthetic { .. })
    }

    /// What identifies the signal of a sampled function in a case, and its number of points.
    pub fn samples(&self, case: &Case) -> Result<(Vec<u64>, usize), Violation> {
        let numbers = self.numbers(case)?;
        Ok((key(&numbers), self.points(&numbers)?))
    }

    /// Cost of making a signal with so many points, in steps times modes. Measured: 3 ms for a synthetic motion, 50 ns for a point of
    /// a pulse.
    pub fn sampling_work(&self, points: usize) -> u64 {
        match self.kind {
            Kind::Synthetic { .. } => 1_500_000,
            Kind::Sine { .. } | Kind::Table { .. } | Kind::Record { .. } | Kind::Pulse(..) => {
                25 * points as u64
            }
        }
    }

    /// Number of sampled signals that were made so far.
    pub fn made_so_far(&self) -> u64 {
        self.made().count
    }

    fn made(&self) -> MutexGuard<'_, SignalCache> {
        self.made.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Most points of the function with these numbers.
    fn points(&self, numbers: &[f64]) -> Result<usize, Violation> {
        let text = |fault: PulseFault| fault.to_string();
        let points = match (&self.kind, numbers) {
            (Kind::Table { t, .. }, _) => Ok(t.len()),
            (Kind::Pulse(pulse, _), numbers) => pulse.points(numbers).map_err(text),
            (Kind::Synthetic { .. }, &[_, omega]) => {
                match omega == synthetic::FIRM_GROUND || synthetic::passes(omega) {
                    true => Ok(synthetic::POINTS),
                    false => Err(no_motion(omega)),
                }
            }
            _ => Ok(0),
        };
        points.map_err(|why| self.violation(why))
    }

    /// The numbers of the function in a case, in the order of its fields.
    fn numbers(&self, case: &Case) -> Result<Vec<f64>, Violation> {
        let of = |amounts: &[&Amount]| amounts.iter().map(|amount| amount.value(case)).collect();
        match &self.kind {
            Kind::Sine {
                amplitude,
                omega,
                phase,
            } => {
                let mut numbers = vec![amplitude.value(case)?, omega.value(case)?];
                let phase = phase.as_ref().map_or(Ok(0.0), |phase| phase.value(case));
                numbers.push(phase?);
                Ok(numbers)
            }
            Kind::Table { t, f } => of(&t.iter().chain(f).collect::<Vec<_>>()),
            Kind::Record { .. } => Ok(Vec::new()),
            Kind::Pulse(_, numbers) => of(&numbers.iter().collect::<Vec<_>>()),
            Kind::Synthetic { seed, omega } => {
                let seed = seed.whole(case, 0, LARGEST_SEED)?;
                let given_omega = omega.as_ref().map(|omega| omega.value(case));
                let omega = given_omega.unwrap_or(Ok(synthetic::FIRM_GROUND))?;
                Ok(vec![f64::from(seed), omega])
            }
        }
    }

    fn make(&self, numbers: &[f64], metre: f64) -> Result<Signal, Violation> {
        let text = |fault: PulseFault| fault.to_string();
        let none = || "the function has no finite values".to_owned();
        let made = match (&self.kind, numbers) {
            (Kind::Sine { .. }, &[amplitude, omega, phase]) => {
                return Ok(Signal::Sine {
                    amplitude,
                    omega,
                    phase,
                });
            }
            (Kind::Table { t, .. }, numbers) => {
                let (times, values) = numbers.split_at(t.len());
                let table = Table::new(times.to_vec(), values.to_vec());
                let rise = "times must rise; two equal times make a jump";
                return table.map(Signal::Table).ok_or_else(|| self.violation(rise));
            }
            (Kind::Pulse(pulse, _), numbers) => pulse.table(numbers).map_err(text),
            (Kind::Synthetic { .. }, &[seed, omega]) => {
                let record =
                    synthetic::synthetic(seed as u64, omega).ok_or_else(|| no_motion(omega));
                record.and_then(|record| record.scaled(1.0 / metre).ok_or_else(none))
            }
            _ => Err(none()),
        };
        let table = made.map_err(|why| self.violation(why))?;
        Ok(Signal::Table(table))
    }

    /// A broken rule at its place.
    pub fn violation(&self, message: impl Into<String>) -> Violation {
        Violation {
            parameter: self.place.1.clone().into(),
            message: message.into(),
            at: Some(self.place.0),
        }
    }
}

/// The bits of numbers.
fn key(numbers: &[f64]) -> Vec<u64> {
    numbers.iter().map(|x| x.to_bits()).collect()
}

fn no_motion(omega: f64) -> String {
    let omega = shortest(omega);
    format!("no motion from 1/30 to 25 Hz passes a ground filter of omega = {omega} rad/s")
}
