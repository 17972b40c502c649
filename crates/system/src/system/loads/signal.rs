//! Accelerations as signals.

use super::Unit;
use super::record::Record;
use crate::system::structure::{Signal, Table};
use std::fmt;
use std::sync::Arc;

/// Why a record is no signal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SignalFault {
    /// Neither the file nor the study has a unit.
    NoUnit,
    /// The file and the study have different units.
    TwoUnits {
        /// Unit of the file.
        file: Unit,
        /// Unit of the study.
        study: Unit,
    },
    /// The scaled values are too large for a number.
    NotFinite,
}

impl fmt::Display for SignalFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SignalFault::NoUnit => {
                write!(f, "the record has no unit; give {}", Unit::names())
            }
            SignalFault::TwoUnits { file, study } => {
                write!(
                    f,
                    "the unit is {study}, but the file is in {file}; give {file} or no unit"
                )
            }
            SignalFault::NotFinite => {
                f.write_str("the scaled record is not finite; use a smaller scale")
            }
        }
    }
}

/// `scale` times the acceleration of a record, in m/s2: straight between its points, 0 before the first and after the last one.
///
/// `unit` is the one of the study. It may be left out if the file has one; if both have one, they must agree.
pub fn signal(record: &Record, unit: Option<Unit>, scale: f64) -> Result<Arc<Signal>, SignalFault> {
    let unit = match (record.unit, unit) {
        (Some(file), Some(study)) if file != study => {
            return Err(SignalFault::TwoUnits { file, study });
        }
        (file, study) => file.or(study).ok_or(SignalFault::NoUnit)?,
    };
    let factor = unit.in_m_s2() * scale;
    let values = record.values.iter().map(|a| a * factor).collect();
    let table = zero_beyond(record.times.clone(), values).ok_or(SignalFault::NotFinite)?;
    Ok(Arc::new(Signal::Table(table)))
}

/// A table that is 0 before its first point (if this is after t = 0, when motions start) and after its last point.
///
/// A table is constant beyond its points, so a value that is not 0 there becomes a jump: a second point at the same time. The value
/// at the time of the last point is then 0. No line leads to 0, because it would add a load that the points do not have.
///
/// `None` unless all numbers are finite and the times rise.
pub(super) fn zero_beyond(mut times: Vec<f64>, mut values: Vec<f64>) -> Option<Table> {
    let first = (*times.first()?, *values.first()?);
    let last = (*times.last()?, *values.last()?);
    if first.0 > 0.0 && first.1 != 0.0 {
        times.insert(0, first.0);
        values.insert(0, 0.0);
    }
    if last.1 != 0.0 {
        times.push(last.0);
        values.push(0.0);
    }
    Table::new(times, values)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(unit: Option<Unit>) -> Record {
        Record {
            times: vec![1.0, 1.5, 2.0],
            values: vec![4.0, 2.0, -2.0],
            unit,
            removed_mean: None,
            doubts: Vec::new(),
        }
    }

    #[test]
    fn a_record_is_zero_before_and_after_and_straight_between() {
        let signal = signal(&record(None), Some(Unit::G), 0.5).unwrap();
        let at = [0.0, 0.999, 1.0, 1.25, 1.75, 2.0, 9.0].map(|t| signal.at(t));
        let g = 9.80665;
        assert_eq!(at, [0.0, 0.0, 2.0 * g, 1.5 * g, 0.0, 0.0, 0.0]);
        // Just before its last time it still has its last value; 1e-9 is the distance times the slope and g.
        assert!((signal.at(2.0 - 1e-12) + g).abs() < 1e-9);
    }

    #[test]
    fn a_motion_that_starts_at_zero_time_or_ends_at_zero_has_no_extra_point() {
        let table = zero_beyond(vec![0.0, 1.0], vec![3.0, 0.0]).unwrap();
        assert_eq!(
            (table.times(), table.values()),
            (&[0.0, 1.0][..], &[3.0, 0.0][..])
        );
        assert_eq!(zero_beyond(vec![], vec![]), None);
    }

    #[test]
    fn the_file_or_the_study_has_the_unit() {
        let (gal, g) = (Unit::CentimetrePerSecond2, Unit::G);
        let at_start = |file, study| signal(&record(file), study, 1.0).map(|signal| signal.at(1.0));
        assert_eq!(at_start(Some(gal), None), Ok(0.04));
        assert_eq!(at_start(Some(gal), Some(gal)), Ok(0.04));
        assert_eq!(at_start(None, None), Err(SignalFault::NoUnit));
        let fault = at_start(Some(gal), Some(g)).unwrap_err();
        assert_eq!(
            fault.to_string(),
            "the unit is g, but the file is in cm/s2; give cm/s2 or no unit"
        );
        let fault = signal(&record(Some(g)), None, 1e308).unwrap_err();
        assert_eq!(
            fault.to_string(),
            "the scaled record is not finite; use a smaller scale"
        );
    }
}
