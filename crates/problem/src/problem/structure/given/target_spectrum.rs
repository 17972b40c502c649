//! Target spectra of a study, and the periods between which motions are compared with them.

use super::amount::Amount;
use crate::problem::{Case, Violation};
use crate::system::loads::target::Target;

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

/// The values of amounts in a case.
pub(super) fn values<'a>(
    amounts: impl IntoIterator<Item = &'a Amount>,
    case: &Case,
) -> Result<Vec<f64>, Violation> {
    let values = amounts.into_iter().map(|amount| amount.value(case));
    values.collect()
}

impl TargetSpectrum {
    /// Its numbers in the order of its fields.
    pub(super) fn amounts(&self) -> Vec<&Amount> {
        match self {
            TargetSpectrum::Table(both) => both.iter().flatten().collect(),
            TargetSpectrum::En1998(amounts) => amounts.iter().collect(),
            TargetSpectrum::Asce7(amounts) => amounts.iter().collect(),
        }
    }

    /// The spectrum in a case.
    pub(super) fn in_case(&self, case: &Case, ratio: f64) -> Result<Target, Violation> {
        let rise = |values: &[f64], amounts: &[Amount]| {
            let wrong = (1..values.len()).find(|i| values[*i] <= values[i - 1]);
            wrong.map_or(Ok(()), |i| {
                Err(amounts[i].violation("the periods must rise"))
            })
        };
        match self {
            TargetSpectrum::Table([periods, ordinates]) => {
                let known = values(periods, case)?;
                rise(&known, periods)?;
                Ok(Target::Table {
                    periods: known,
                    ordinates: values(ordinates, case)?,
                })
            }
            TargetSpectrum::En1998(amounts) => {
                let values = values(amounts.iter(), case)?;
                rise(&values[2..], &amounts[2..])?;
                Ok(Target::En1998 {
                    ag: values[0],
                    soil: values[1],
                    corners: [values[2], values[3], values[4]],
                    ratio,
                })
            }
            TargetSpectrum::Asce7(amounts) => {
                let values = values(amounts.iter(), case)?;
                Ok(Target::Asce7 {
                    short: values[0],
                    one: values[1],
                    long: values[2],
                })
            }
        }
    }
}
