//! The strength that a study gives a motion, or the motions of a station together.

use super::amount::Amount;
use super::motion_set::{Motions, Set, SetSpectra, State};
use super::strength::{Asked, Strengths};
use super::target_spectrum::{TargetSpectrum, values};
use crate::problem::{Case, Violation};
use crate::system::loads::measures::Measure;
use crate::system::loads::pair::Component;
use crate::system::loads::target::Fit;

/// The strength that a motion gets.
#[derive(Debug, Clone)]
pub struct ScaleTo {
    /// What becomes of the motion.
    pub goal: Goal,
    /// Unit of the goal's accelerations in the study's units; 1 for these.
    pub unit: f64,
    /// Damping ratio of spectra; none for 0.05.
    pub ratio: Option<Amount>,
    /// The least squares of a target spectrum.
    pub fit: Fit,
    /// Which strength of a pair; none for a motion in one direction.
    pub component: Option<Component>,
    /// The set whose factor comes on top.
    pub set: Option<Box<Set>>,
}

/// What a motion is scaled to.
#[derive(Debug, Clone)]
pub enum Goal {
    /// This largest acceleration.
    PeakAcceleration(Amount),
    /// This pseudo-acceleration of an oscillator.
    Spectral {
        /// The pseudo-acceleration.
        value: Amount,
        /// Period of the oscillator.
        period: Amount,
    },
    /// The least sum of squares of its pseudo-accelerations minus those of a target.
    Spectrum {
        /// The target.
        target: TargetSpectrum,
        /// The periods between which they are compared.
        between: [Amount; 2],
    },
    /// This factor.
    Factor(Amount),
}

/// Damping ratio of spectra without one.
pub const RATIO: f64 = 0.05;

/// Of the periods of a target spectrum, each so many-th is looked at in every case: all of them would take longer than the case.
const EVERY: usize = 25;

/// The two periods in a case, the second one larger.
fn bounds([from, to]: &[Amount; 2], case: &Case) -> Result<[f64; 2], Violation> {
    let bounds = [from.value(case)?, to.value(case)?];
    match bounds[0] < bounds[1] {
        true => Ok(bounds),
        false => Err(to.violation("must be larger than from")),
    }
}

impl ScaleTo {
    /// The damping ratio in a case.
    fn damping(&self, case: &Case) -> Result<f64, Violation> {
        let ratio = self.ratio.as_ref();
        ratio.map_or(Ok(RATIO), |ratio| ratio.value(case))
    }

    /// The factor with which a motion with these strengths reaches its own, that of its set included.
    ///
    /// # Errors
    /// The first rule that a number breaks.
    pub fn factor(
        &self,
        case: &Case,
        metre: f64,
        strengths: &dyn Strengths,
    ) -> Result<f64, Violation> {
        let alone = self.own_factor(case, metre, strengths)?;
        match self.state(case, metre, strengths)? {
            None => Ok(alone),
            Some(state) => Ok(alone * state.factor),
        }
    }

    /// The set in a case, if there is one.
    ///
    /// # Errors
    /// The first rule that a number breaks.
    pub fn state(
        &self,
        case: &Case,
        metre: f64,
        strengths: &dyn Strengths,
    ) -> Result<Option<State>, Violation> {
        self.with_set(case, metre, strengths, |set, motions| {
            set.state(case, motions)
        })
    }

    /// The spectra of the set in a case, if there is one.
    ///
    /// # Errors
    /// The first rule that a number breaks.
    pub fn set_spectra(
        &self,
        periods: &[f64],
        case: &Case,
        metre: f64,
        strengths: &dyn Strengths,
    ) -> Result<Option<SetSpectra>, Violation> {
        self.with_set(case, metre, strengths, |set, motions| {
            set.drawn(periods, case, motions)
        })
    }

    /// What is computed of the set and its motions.
    fn with_set<T>(
        &self,
        case: &Case,
        metre: f64,
        strengths: &dyn Strengths,
        of: impl FnOnce(&Set, &Motions) -> Result<T, Violation>,
    ) -> Result<Option<T>, Violation> {
        let Some(set) = &self.set else {
            return Ok(None);
        };
        let bits = |case: &Case| {
            let values = values(self.goal.amounts(), case)?;
            Ok(values.into_iter().map(f64::to_bits).collect())
        };
        let motions = Motions {
            strengths,
            factor: &|case| self.own_factor(case, metre, strengths),
            identity: &bits,
            ratio: self.damping(case)?,
            unit: self.unit,
            metre,
        };
        of(set, &motions).map(Some)
    }

    /// The factor of a motion without that of its set.
    fn own_factor(
        &self,
        case: &Case,
        metre: f64,
        strengths: &dyn Strengths,
    ) -> Result<f64, Violation> {
        let strength = |measure| {
            let asked = Asked {
                measure,
                component: self.component,
            };
            strengths.strength(asked, case, metre)
        };
        let unit = self.unit;
        match &self.goal {
            Goal::Factor(value) => value.value(case),
            Goal::PeakAcceleration(value) => {
                Ok(unit * value.value(case)? / strength(Measure::PeakAcceleration)?)
            }
            Goal::Spectral { value, period } => {
                let measure = Measure::Spectral {
                    period: period.value(case)?,
                    ratio: self.damping(case)?,
                };
                Ok(unit * value.value(case)? / strength(measure)?)
            }
            Goal::Spectrum { target, between } => {
                let ratio = self.damping(case)?;
                let target = target.in_case(case, ratio)?;
                let periods = self.fit.periods(bounds(between, case)?);
                let spectral = |period: &f64| {
                    strength(Measure::Spectral {
                        period: *period,
                        ratio,
                    })
                };
                let by_period = periods.iter().map(spectral);
                let ordinates = by_period.collect::<Result<Vec<f64>, Violation>>()?;
                let wanted: Vec<f64> = periods.iter().map(|t| unit * target.at(*t)).collect();
                Ok(self.fit.nearest(&ordinates, &wanted))
            }
        }
    }

    /// Periods of oscillators, and their damping ratio, whose pseudo-accelerations the motion is scaled to; of a target spectrum a
    /// few. `None` if a number breaks a rule.
    pub fn periods(&self, case: &Case) -> Option<(Vec<f64>, f64)> {
        let ratio = self.damping(case).ok()?;
        match &self.goal {
            Goal::PeakAcceleration(_) | Goal::Factor(_) => Some((Vec::new(), RATIO)),
            Goal::Spectral { period, .. } => Some((vec![period.value(case).ok()?], ratio)),
            Goal::Spectrum { between, .. } => {
                let periods = self.fit.periods(bounds(between, case).ok()?);
                Some((periods.into_iter().step_by(EVERY).collect(), ratio))
            }
        }
    }

    /// Every number is in its range.
    ///
    /// # Errors
    /// The first rule that a number breaks.
    pub fn check(&self, case: &Case) -> Result<(), Violation> {
        let ratio = self.damping(case)?;
        match &self.goal {
            Goal::PeakAcceleration(_) | Goal::Factor(_) | Goal::Spectral { .. } => {
                values(self.goal.amounts(), case).map(|_| ())
            }
            Goal::Spectrum { target, between } => {
                bounds(between, case)?;
                target.in_case(case, ratio).map(|_| ())
            }
        }?;
        self.set
            .as_ref()
            .map_or(Ok(()), |set| set.check(case, ratio))
    }
}

impl Goal {
    /// Its numbers.
    pub fn amounts(&self) -> Vec<&Amount> {
        match self {
            Goal::PeakAcceleration(value) | Goal::Factor(value) => vec![value],
            Goal::Spectral { value, period } => vec![value, period],
            Goal::Spectrum { target, between } => {
                target.amounts().into_iter().chain(between).collect()
            }
        }
    }
}
