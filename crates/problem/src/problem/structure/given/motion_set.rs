//! Sets of motions: the mean or the envelope of their spectra and a target, and the factor that all of them get.

use super::amount::Amount;
use super::strength::{Asked, Strengths};
use super::target_spectrum::{TargetSpectrum, values};
use crate::problem::numbers::parameter::Value;
use crate::problem::{Case, Violation};
use crate::system::loads::measures::Measure;
use crate::system::loads::pair::Component;
use crate::system::loads::target::{Fit, Target};
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// What of the spectra of a set is compared with the target.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Statistic {
    /// Their mean at each period.
    Mean,
    /// The largest one at each period.
    Envelope,
}

/// A set of motions with a rule for its spectrum.
#[derive(Debug, Clone)]
pub struct Set {
    /// The name of its rule, if it has one.
    pub rule: Option<&'static str>,
    /// The values that parameters have in the cases with each motion, by their rows.
    pub members: Vec<Vec<(usize, Value)>>,
    /// What is compared.
    pub statistic: Statistic,
    /// Of what of a pair.
    pub component: Option<Component>,
    /// The least ratio to the target.
    pub least: Amount,
    /// The least ratio of the largest accelerations to the target at T = 0, if there is such a rule.
    pub at_zero: Option<Amount>,
    /// The first and last period: a number times the least, and times the largest, of periods.
    pub between: [(f64, Vec<Amount>); 2],
    /// The target.
    pub target: TargetSpectrum,
    /// The factor; if none is given, that with which the rule holds exactly.
    pub factor: Option<Amount>,
    /// States by the bits of all numbers on which they depend.
    pub made: Made,
}

/// States that one of the cases computes while the others wait for it.
pub type Made = Arc<Mutex<BTreeMap<Vec<u64>, Arc<OnceLock<Result<State, Violation>>>>>>;

/// What a set is in a case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// The factor of all its motions.
    pub factor: f64,
    /// The least ratio of its spectrum with this factor to what the rule asks for: at least 1 where the rule holds.
    pub ratio: f64,
    /// The period of this ratio; 0 for the largest accelerations.
    pub period: f64,
}

/// The spectra of a set in a case, with the factors of its motions.
#[derive(Debug, Clone, PartialEq)]
pub struct SetSpectra {
    /// The ordinates of each motion.
    pub motions: Vec<Vec<f64>>,
    /// Their mean or envelope.
    pub statistic: Vec<f64>,
    /// The ordinates of the target.
    pub target: Vec<f64>,
    /// The least ratio to it.
    pub least: f64,
    /// The first and last period of the rule.
    pub between: [f64; 2],
    /// The damping ratio.
    pub ratio: f64,
    /// Of what of a pair.
    pub component: Option<Component>,
    /// Whether `statistic` is the envelope.
    pub is_envelope: bool,
    /// The set.
    pub state: State,
}

/// The motions of a set in a case, before they have its factor.
pub(super) struct Motions<'a> {
    pub strengths: &'a dyn Strengths,
    /// The own factor of the motion of a case.
    pub factor: &'a dyn Fn(&Case) -> Result<f64, Violation>,
    /// What identifies this factor.
    pub identity: &'a dyn Fn(&Case) -> Result<Vec<u64>, Violation>,
    /// Damping ratio, and unit of the target.
    pub ratio: f64,
    pub unit: f64,
    pub metre: f64,
}

impl Set {
    fn member(&self, values: &[(usize, Value)], case: &Case) -> Case {
        let mut case = case.clone();
        for (row, value) in values {
            case.values[*row] = Some(*value);
        }
        case
    }

    /// The first and last period in a case.
    fn bounds(&self, case: &Case) -> Result<[f64; 2], Violation> {
        let end = |(times, amounts): &(f64, Vec<Amount>), largest: bool| {
            let values = values(amounts, case)?;
            let first = values.first().copied().unwrap_or_default();
            let chosen = values.iter().fold(first, |a, b| match largest {
                true => a.max(*b),
                false => a.min(*b),
            });
            Ok(times * chosen)
        };
        let bounds = [end(&self.between[0], false)?, end(&self.between[1], true)?];
        match (bounds[0] < bounds[1], self.between[1].1.first()) {
            (false, Some(to)) => Err(to.violation("must be larger than from")),
            _ => Ok(bounds),
        }
    }

    /// Every number is in its range.
    pub(super) fn check(&self, case: &Case, ratio: f64) -> Result<(), Violation> {
        self.least.value(case)?;
        let both = self.at_zero.iter().chain(&self.factor);
        values(both, case)?;
        self.bounds(case)?;
        self.target.in_case(case, ratio).map(|_| ())
    }

    /// The set in a case.
    pub(super) fn state(&self, case: &Case, motions: &Motions) -> Result<State, Violation> {
        let bounds = self.between.iter().flat_map(|bound| &bound.1);
        let amounts = bounds.chain(self.target.amounts()).chain([&self.least]);
        let used = amounts.chain(&self.at_zero).chain(&self.factor);
        let numbers = values(used, case)?.into_iter().chain([motions.ratio]);
        let mut key: Vec<u64> = numbers.map(f64::to_bits).collect();
        for values in &self.members {
            let member = self.member(values, case);
            key.extend(motions.strengths.identity(&member)?);
            key.extend((motions.identity)(&member)?);
        }
        let cell = {
            let mut made = self.made.lock().unwrap_or_else(PoisonError::into_inner);
            made.entry(key).or_default().clone()
        };
        cell.get_or_init(|| self.computed(case, motions)).clone()
    }

    fn computed(&self, case: &Case, motions: &Motions) -> Result<State, Violation> {
        let target = self.target.in_case(case, motions.ratio)?;
        let periods = Fit::Logarithmic.periods(self.bounds(case)?);
        let least = self.least.value(case)?;
        let (_, statistic) = self.spectra(&periods, case, motions)?;
        let over = |least: f64, value: f64, period: f64| {
            (value / (least * motions.unit * target.at(period)), period)
        };
        let pairs = periods.iter().zip(&statistic);
        let mut ratios: Vec<(f64, f64)> = pairs
            .map(|(t, ordinate)| over(least, *ordinate, *t))
            .collect();
        if let Some(at_zero) = &self.at_zero {
            let peaks = self.each(Measure::PeakAcceleration, case, motions)?;
            ratios.push(over(at_zero.value(case)?, self.of(&peaks), 0.0));
        }
        let lowest = ratios.into_iter().min_by(|a, b| a.0.total_cmp(&b.0));
        let (ratio, period) = lowest.unwrap_or((f64::NAN, 0.0));
        let factor = match &self.factor {
            Some(factor) => factor.value(case)?,
            None => least_factor(ratio),
        };
        match (factor * ratio).is_finite() {
            true => Ok(State {
                factor,
                ratio: factor * ratio,
                period,
            }),
            false => Err(self.least.violation("the set has no finite factor")),
        }
    }

    /// A strength of each motion, with its own factor.
    fn each(
        &self,
        measure: Measure,
        case: &Case,
        motions: &Motions,
    ) -> Result<Vec<f64>, Violation> {
        let asked = Asked {
            measure,
            component: self.component,
        };
        let strength = |values: &Vec<(usize, Value)>| {
            let member = self.member(values, case);
            let unscaled = motions.strengths.strength(asked, &member, motions.metre)?;
            Ok(measure.scaled(unscaled, (motions.factor)(&member)?))
        };
        self.members.iter().map(strength).collect()
    }

    /// The mean or the largest one of values.
    fn of(&self, values: &[f64]) -> f64 {
        match self.statistic {
            Statistic::Mean => values.iter().sum::<f64>() / values.len() as f64,
            Statistic::Envelope => values.iter().copied().fold(0.0, f64::max),
        }
    }

    /// The ordinates of each motion, and their mean or envelope, before they have the factor of the set.
    fn spectra(
        &self,
        periods: &[f64],
        case: &Case,
        motions: &Motions,
    ) -> Result<(Vec<Vec<f64>>, Vec<f64>), Violation> {
        let ratio = motions.ratio;
        let spectral = |period: &f64| Measure::Spectral {
            period: *period,
            ratio,
        };
        let by_period = periods
            .iter()
            .map(|period| self.each(spectral(period), case, motions))
            .collect::<Result<Vec<Vec<f64>>, Violation>>()?;
        let of = |i: usize| by_period.iter().map(|values| values[i]).collect();
        let each = (0..self.members.len()).map(of).collect();
        Ok((
            each,
            by_period.iter().map(|values| self.of(values)).collect(),
        ))
    }

    /// The spectra at these periods in a case.
    pub(super) fn drawn(
        &self,
        periods: &[f64],
        case: &Case,
        motions: &Motions,
    ) -> Result<SetSpectra, Violation> {
        let state = self.state(case, motions)?;
        let scaled = |spectrum: Vec<f64>| spectrum.into_iter().map(|x| state.factor * x).collect();
        let (each, statistic) = self.spectra(periods, case, motions)?;
        let target: Target = self.target.in_case(case, motions.ratio)?;
        let wanted = periods.iter().map(|t| motions.unit * target.at(*t));
        Ok(SetSpectra {
            motions: each.into_iter().map(scaled).collect(),
            statistic: scaled(statistic),
            target: wanted.collect(),
            least: self.least.value(case)?,
            between: self.bounds(case)?,
            ratio: motions.ratio,
            component: self.component,
            is_envelope: self.statistic == Statistic::Envelope,
            state,
        })
    }
}

/// The least factor with which a ratio is at least 1, also after rounding.
fn least_factor(ratio: f64) -> f64 {
    let factor = 1.0 / ratio;
    match factor * ratio < 1.0 {
        true => factor.next_up(),
        false => factor,
    }
}
