//! What a study does to the function of a motion: a part of it, its baseline, its strength and its delay, in this order.

use super::amount::Amount;
use super::scale_to::ScaleTo;
use super::signal_cache::SignalCache;
use super::source::Source;
use super::strength::Strengths;
use crate::problem::{Case, Violation};
use crate::system::loads::STANDARD_GRAVITY;
use crate::system::loads::cut::{cut, delayed, without_baseline};
use crate::system::loads::cycles::Cycles;
use crate::system::loads::measures::Measure;
use crate::system::structure::{Baseline, NoEnd, Signal, Table};
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// What is done to a function. Cases with the same numbers share the result.
#[derive(Debug, Clone, Default)]
pub struct Shape {
    /// Where the motion begins, in the time of the function; none for 0.
    pub start: Option<Amount>,
    /// Where it ends; none for the last point.
    pub end: Option<Amount>,
    /// What is removed from the part.
    pub baseline: Baseline,
    /// The strength that it gets; none for its own.
    pub scale_to: Option<Arc<ScaleTo>>,
    /// The pair of the station that gets this strength in its place.
    pub pair: Option<Arc<dyn Strengths>>,
    /// Time by which all of it is later, >= 0; none for 0.
    pub delay: Option<Amount>,
    made: Arc<Mutex<Made>>,
}

/// The results so far.
#[derive(Debug, Default)]
struct Made {
    signals: SignalCache,
    /// Measures of motions by the bits of all numbers on which they depend.
    measures: BTreeMap<Vec<u64>, Option<f64>>,
}

/// Most measures that are kept.
const MOST_MEASURES: usize = 1 << 18;

impl Shape {
    /// Whether nothing is done.
    pub fn is_plain(&self) -> bool {
        let amounts = [&self.start, &self.end, &self.delay];
        let none = amounts.into_iter().all(|amount| amount.is_none());
        none && self.baseline == Baseline::None && self.scale_to.is_none()
    }

    fn made(&self) -> MutexGuard<'_, Made> {
        self.made.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Start, end and delay in a case.
    fn times(&self, case: &Case) -> Result<[Option<f64>; 3], Violation> {
        let of = |amount: &Option<Amount>| amount.as_ref().map(|x| x.value(case)).transpose();
        let times = [of(&self.start)?, of(&self.end)?, of(&self.delay)?];
        if let ([start, Some(end), _], Some(until)) = (times, &self.end)
            && end <= start.unwrap_or(0.0)
        {
            return Err(until.violation("must be later than the start"));
        }
        Ok(times)
    }

    /// Every number of the shape is in its range.
    fn check_numbers(&self, case: &Case) -> Result<(), Violation> {
        self.times(case)?;
        match &self.scale_to {
            Some(scale_to) => scale_to.check(case),
            None => Ok(()),
        }
    }

    /// What identifies the part of a function.
    pub(super) fn key(&self, scaled: &Scaled, case: &Case) -> Result<Vec<u64>, Violation> {
        let [start, end, _] = self.times(case)?;
        let mut key = scaled.source.key(case)?;
        let bits = |time: Option<f64>| time.unwrap_or(f64::NAN).to_bits();
        key.extend([bits(start), bits(end)]);
        Ok(key)
    }

    /// The part of a function without its baseline, before its delay; and what identifies it.
    fn part(&self, scaled: &Scaled, case: &Case, metre: f64) -> Result<Part, Violation> {
        let signal = scaled.source.signal(case, metre)?;
        let [start, end, _] = self.times(case)?;
        let key = self.key(scaled, case)?;
        let table = points(&signal, &scaled.source)?;
        if start.is_none() && end.is_none() && self.baseline == Baseline::None {
            return Ok(Part { signal, key });
        }
        let cell = self.made().signals.cell(&key, table.times().len());
        let make = || {
            let part = match start.is_some() || end.is_some() {
                true => cut(table, start, end),
                false => Some(table.clone()),
            };
            let why = "has no points from start to end";
            let part = part.ok_or_else(|| scaled.source.violation(why))?;
            let level = without_baseline(part, self.baseline).map_err(|NoEnd| {
                scaled
                    .source
                    .violation("a baseline needs a function with an end after t = 0")
            })?;
            Ok(Arc::new(Signal::Table(level)))
        };
        let signal = cell.get_or_init(make).clone()?;
        Ok(Part { signal, key })
    }

    /// A measure of the part of a function; computed once.
    pub(super) fn measure(
        &self,
        scaled: &Scaled,
        measure: Measure,
        case: &Case,
        metre: f64,
    ) -> Result<Option<f64>, Violation> {
        let mut key = self.key(scaled, case)?;
        key.extend(identity(measure));
        if let Some(known) = self.made().measures.get(&key) {
            return Ok(*known);
        }
        let part = self.part(scaled, case, metre)?;
        let table = points(&part.signal, &scaled.source)?;
        let value = measure.of(table, STANDARD_GRAVITY / metre);
        let mut made = self.made();
        if made.measures.len() >= MOST_MEASURES {
            made.measures.clear();
        }
        made.measures.insert(key, value);
        Ok(value)
    }
}

/// A part of a function, and what identifies it among the parts of this function.
pub(super) struct Part {
    signal: Arc<Signal>,
    key: Vec<u64>,
}

/// The points of a signal.
fn points<'a>(signal: &'a Signal, source: &Source) -> Result<&'a Table, Violation> {
    match signal {
        Signal::Table(table) => Ok(table),
        Signal::Sine { .. } | Signal::Motion(..) => Err(source.violation(
            "start, end, baseline, scale_to and delay need a function with points; a sine has none",
        )),
    }
}

/// What identifies a measure.
pub(super) fn identity(measure: Measure) -> [u64; 3] {
    let kind = match measure {
        Measure::PeakAcceleration => 1,
        Measure::PeakVelocity => 2,
        Measure::PeakDisplacement => 3,
        Measure::Arias => 4,
        Measure::Duration => 5,
        Measure::MeanPeriod => 6,
        Measure::Spectral { period, ratio } => return [7, period.to_bits(), ratio.to_bits()],
    };
    [kind, 0, 0]
}

impl Scaled {
    /// Every rule that the function breaks in a case; neither samples nor the factor of its strength are computed.
    pub fn check(&self, case: &Case, metre: f64) -> Result<(), Violation> {
        self.source.check(case, metre)?;
        if !self.shape.is_plain() {
            self.shape.check_numbers(case)?;
            if !self.source.is_sampled() {
                self.shape.part(self, case, metre)?;
            }
        }
        self.scale
            .as_ref()
            .map_or(Ok(()), |scale| scale.value(case).map(|_| ()))
    }

    /// The signal in a case, and its factor.
    pub fn in_case(&self, case: &Case, metre: f64) -> Result<(Arc<Signal>, f64), Violation> {
        let scale = self
            .scale
            .as_ref()
            .map_or(Ok(1.0), |scale| scale.value(case));
        if self.shape.is_plain() {
            return Ok((self.source.signal(case, metre)?, scale?));
        }
        let (signal, factor) = self.shaped(case, metre)?;
        Ok((signal, scale? * factor))
    }

    /// A measure of the function in a case; `None` if it has none.
    ///
    /// # Errors
    /// The first rule that the function breaks.
    pub fn measure(
        &self,
        measure: Measure,
        case: &Case,
        metre: f64,
    ) -> Result<Option<f64>, Violation> {
        let shape = &self.shape;
        let value = shape.measure(self, measure, case, metre)?;
        let scale = self
            .scale
            .as_ref()
            .map_or(Ok(1.0), |scale| scale.value(case));
        let factor = scale? * self.factor(case, metre)?;
        Ok(value.map(|value| measure.scaled(value, factor)))
    }

    /// The whole cycles of the function in a case.
    pub fn cycles(&self, case: &Case) -> Result<Vec<Cycles>, Violation> {
        let [start, end, delay] = self.shape.times(case)?;
        let part = [start.unwrap_or(0.0), end.unwrap_or(f64::INFINITY)];
        let later = delay.unwrap_or(0.0) - part[0];
        let cycles = self.source.cycles(case)?.into_iter();
        let shown = cycles.map(|cycles| cycles.within(part).delayed(later));
        Ok(shown.collect())
    }

    /// The part of the function that has a strength.
    pub(super) fn part(&self, case: &Case, metre: f64) -> Result<Part, Violation> {
        self.shape.part(self, case, metre)
    }

    /// The points of this part.
    pub(super) fn points<'a>(&self, part: &'a Part) -> Result<&'a Table, Violation> {
        points(&part.signal, &self.source)
    }

    /// The signal in a case with all that is done to it, and the factor of its strength.
    fn shaped(&self, case: &Case, metre: f64) -> Result<(Arc<Signal>, f64), Violation> {
        let shape = &self.shape;
        let mut part = shape.part(self, case, metre)?;
        let factor = self.factor(case, metre)?;
        let [.., delay] = shape.times(case)?;
        let Some(delay) = delay else {
            return Ok((part.signal, factor));
        };
        let table = points(&part.signal, &self.source)?;
        part.key.push(delay.to_bits());
        let cell = shape.made().signals.cell(&part.key, table.times().len());
        let make = || {
            let late = delayed(table, delay)
                .ok_or_else(|| self.source.violation("the delay is too large"))?;
            Ok(Arc::new(Signal::Table(late)))
        };
        Ok((cell.get_or_init(make).clone()?, factor))
    }
}

/// A function of time, times a factor.
#[derive(Debug, Clone)]
pub struct Scaled {
    /// The function.
    pub source: Source,
    /// The factor; none for 1.
    pub scale: Option<Amount>,
    /// What is done to the function before.
    pub shape: Box<Shape>,
}
