//! The strength that a study gives a motion.

use super::amount::Amount;
use crate::problem::{Case, Violation};
use crate::system::loads::measures::Measure;
use crate::system::loads::target::{self, Target};

/// The strength that a motion gets.
#[derive(Debug, Clone)]
pub struct ScaleTo {
    /// What becomes of the motion.
    pub goal: Goal,
    /// Unit of the goal's accelerations in the study's units; 1 for these.
    pub unit: f64,
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
        /// Damping ratio; none for 0.05.
        ratio: Option<Amount>,
    },
    /// The least sum of squares of its pseudo-accelerations minus those of a target.
    Spectrum {
        /// The target.
        target: TargetSpectrum,
        /// The periods between which they are compared.
        between: [Amount; 2],
        /// Damping ratio; none for 0.05.
        ratio: Option<Amount>,
    },
}

/// A target spectrum of a study.
#[derive(Debug, Clone)]
pub enum TargetSpectrum {
    /// Periods and ordinates.
    Table([Vec<Amount>; 2]),
    /// a_g, S, T_B, T_C and T_D.
    En1998(Box<[Amount; 5]>),
    /// S_DS, S_D1 and T_L.
    Asce7(Box<[Amount; 3]>),
}

/// Damping ratio of spectra without one.
pub const RATIO: f64 = 0.05;

/// Of the periods of a target spectrum, each so many-th is looked at in every case: all of them would take longer than the case.
const EVERY: usize = 25;

/// The value of a measure of the motion.
type Own<'a> = &'a dyn Fn(Measure) -> Result<f64, Violation>;

/// A damping ratio in a case.
fn damping(ratio: &Option<Amount>, case: &Case) -> Result<f64, Violation> {
    ratio.as_ref().map_or(Ok(RATIO), |ratio| ratio.value(case))
}

/// The two periods in a case, the second one larger.
fn bounds([from, to]: &[Amount; 2], case: &Case) -> Result<[f64; 2], Violation> {
    let bounds = [from.value(case)?, to.value(case)?];
    match bounds[0] < bounds[1] {
        true => Ok(bounds),
        false => Err(to.violation("must be larger than from")),
    }
}

impl ScaleTo {
    /// The factor with which a motion with these measures reaches its strength.
    ///
    /// # Errors
    /// The first rule that a number breaks.
    pub fn factor(&self, case: &Case, own: Own) -> Result<f64, Violation> {
        let ScaleTo { goal, unit } = self;
        match goal {
            Goal::PeakAcceleration(value) => {
                Ok(unit * value.value(case)? / own(Measure::PeakAcceleration)?)
            }
            Goal::Spectral {
                value,
                period,
                ratio,
            } => {
                let measure = Measure::Spectral {
                    period: period.value(case)?,
                    ratio: damping(ratio, case)?,
                };
                Ok(unit * value.value(case)? / own(measure)?)
            }
            Goal::Spectrum {
                target,
                between,
                ratio,
            } => {
                let ratio = damping(ratio, case)?;
                let target = target.in_case(case, ratio)?;
                let periods = target::periods(bounds(between, case)?);
                let spectral = |period: &f64| {
                    own(Measure::Spectral {
                        period: *period,
                        ratio,
                    })
                };
                let ordinates = periods.iter().map(spectral);
                let ordinates = ordinates.collect::<Result<Vec<f64>, Violation>>()?;
                let wanted: Vec<f64> = periods.iter().map(|t| unit * target.at(*t)).collect();
                Ok(target::nearest(&ordinates, &wanted))
            }
        }
    }

    /// Periods of oscillators, and their damping ratio, whose pseudo-accelerations the motion is scaled to; of a target spectrum a
    /// few. `None` if a number breaks a rule.
    pub fn periods(&self, case: &Case) -> Option<(Vec<f64>, f64)> {
        match &self.goal {
            Goal::PeakAcceleration(_) => Some((Vec::new(), RATIO)),
            Goal::Spectral { period, ratio, .. } => {
                Some((vec![period.value(case).ok()?], damping(ratio, case).ok()?))
            }
            Goal::Spectrum { between, ratio, .. } => {
                let all = target::periods(bounds(between, case).ok()?);
                let few = all.into_iter().step_by(EVERY).collect();
                Some((few, damping(ratio, case).ok()?))
            }
        }
    }

    /// Every number is in its range.
    ///
    /// # Errors
    /// The first rule that a number breaks.
    pub fn check(&self, case: &Case) -> Result<(), Violation> {
        match &self.goal {
            Goal::PeakAcceleration(value) => value.value(case).map(|_| ()),
            Goal::Spectral {
                value,
                period,
                ratio,
            } => {
                damping(ratio, case)?;
                value.value(case).and(period.value(case)).map(|_| ())
            }
            Goal::Spectrum {
                target,
                between,
                ratio,
            } => {
                bounds(between, case)?;
                target.in_case(case, damping(ratio, case)?).map(|_| ())
            }
        }
    }
}

impl TargetSpectrum {
    /// The spectrum in a case.
    fn in_case(&self, case: &Case, ratio: f64) -> Result<Target, Violation> {
        let all = |amounts: &[Amount]| {
            let values = amounts.iter().map(|amount| amount.value(case));
            values.collect::<Result<Vec<f64>, Violation>>()
        };
        let rise = |values: &[f64], amounts: &[Amount]| {
            let wrong = (1..values.len()).find(|i| values[*i] <= values[i - 1]);
            wrong.map_or(Ok(()), |i| {
                Err(amounts[i].violation("the periods must rise"))
            })
        };
        match self {
            TargetSpectrum::Table([periods, ordinates]) => {
                let values = all(periods)?;
                rise(&values, periods)?;
                Ok(Target::Table {
                    periods: values,
                    ordinates: all(ordinates)?,
                })
            }
            TargetSpectrum::En1998(amounts) => {
                let values = all(&**amounts)?;
                rise(&values[2..], &amounts[2..])?;
                Ok(Target::En1998 {
                    ag: values[0],
                    soil: values[1],
                    corners: [values[2], values[3], values[4]],
                    ratio,
                })
            }
            TargetSpectrum::Asce7(amounts) => {
                let values = all(&**amounts)?;
                Ok(Target::Asce7 {
                    short: values[0],
                    one: values[1],
                    long: values[2],
                })
            }
        }
    }
}
