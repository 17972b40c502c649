//! Pulse-like ground accelerations, sampled.

use super::signal::zero_beyond;
use crate::system::structure::Table;
use libm::{exp, sin};
use std::f64::consts::PI;
use std::fmt;

/// Points that a pulse may have; more are a slip of the study.
const MOST: f64 = 1e7;

/// Why numbers make no pulse.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PulseFault {
    /// A number, by its name, that is not > 0 and finite.
    NotPositive(&'static str, f64),
    /// So many intervals from its start to its end.
    TooManyPoints(f64),
    /// An acceleration that is not finite.
    NotFinite,
}

impl fmt::Display for PulseFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PulseFault::NotPositive(name, value) => write!(f, "{name} must be > 0, got {value}"),
            PulseFault::TooManyPoints(intervals) => {
                write!(
                    f,
                    "sampled must give at most {MOST} points, got {intervals}"
                )
            }
            PulseFault::NotFinite => f.write_str("the pulse must be finite"),
        }
    }
}

impl std::error::Error for PulseFault {}

/// A Ricker wavelet a (1 - 2x) exp(-x) with x = (pi f (t - at))^2 `[Ricker 1953]` for amplitude a and frequency f, from 0 to 2 at.
///
/// Its peak a is at t = `at`. It is straight between samples at distances `sampled`, and 0 after 2 at.
pub fn ricker(amplitude: f64, frequency: f64, at: f64, sampled: f64) -> Result<Table, PulseFault> {
    ricker_points(amplitude, frequency, at, sampled)?;
    table(2.0 * at, sampled, |t| {
        let root = PI * frequency * (t - at);
        let x = root * root;
        // Above 746 exp(-x) is 0, but an infinite x makes 1 - 2x infinite.
        if x > 746.0 {
            0.0
        } else {
            amplitude * (1.0 - 2.0 * x) * exp(-x)
        }
    })
}

/// One sine cycle of acceleration, amplitude sin(2 pi t/period) from 0 to `period`, so that the velocity is 1 - cos.
///
/// It is straight between samples at distances `sampled`, and 0 after the period.
pub fn cosine(amplitude: f64, period: f64, sampled: f64) -> Result<Table, PulseFault> {
    cosine_points(amplitude, period, sampled)?;
    table(period, sampled, |t| {
        if t < period {
            amplitude * sin(2.0 * PI * (t / period))
        } else {
            0.0
        }
    })
}

/// Most points of [`ricker`] with these numbers.
///
/// # Errors
/// It does not make a pulse of them.
pub fn ricker_points(
    amplitude: f64,
    frequency: f64,
    at: f64,
    sampled: f64,
) -> Result<usize, PulseFault> {
    positive("frequency", frequency)?;
    positive("at", at)?;
    points(amplitude, 2.0 * at, sampled)
}

/// Most points of [`cosine`] with these numbers.
///
/// # Errors
/// It does not make a pulse of them.
pub fn cosine_points(amplitude: f64, period: f64, sampled: f64) -> Result<usize, PulseFault> {
    positive("period", period)?;
    points(amplitude, period, sampled)
}

/// The intervals, their ends, and a jump.
fn points(amplitude: f64, end: f64, sampled: f64) -> Result<usize, PulseFault> {
    let intervals = intervals(end, sampled)?;
    match amplitude.abs() <= LARGEST {
        true => Ok(intervals + 2),
        false => Err(PulseFault::NotFinite),
    }
}

/// Largest amplitude of a pulse: the factor 1 - 2x of a wavelet does not overflow.
const LARGEST: f64 = 1e300;

/// Samples of a function from 0 to `end`, which is the last one also where it is no multiple of `sampled`.
fn table(end: f64, sampled: f64, value: impl Fn(f64) -> f64) -> Result<Table, PulseFault> {
    let inner = (0..intervals(end, sampled)?).map(|i| i as f64 * sampled);
    let times: Vec<f64> = inner.chain([end]).collect();
    let values = times.iter().map(|t| value(*t)).collect();
    zero_beyond(times, values).ok_or(PulseFault::NotFinite)
}

/// Number of intervals from 0 to `end`.
fn intervals(end: f64, sampled: f64) -> Result<usize, PulseFault> {
    positive("sampled", sampled)?;
    // A quotient just above a whole number is round-off, not a further interval.
    let intervals = (end / sampled * (1.0 - 1e-12)).ceil();
    match intervals <= MOST {
        true => Ok(intervals as usize),
        false => Err(PulseFault::TooManyPoints(intervals)),
    }
}

/// Refuses a number that is not > 0 and finite.
fn positive(name: &'static str, value: f64) -> Result<(), PulseFault> {
    if value > 0.0 && value.is_finite() {
        return Ok(());
    }
    Err(PulseFault::NotPositive(name, value))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The integral of a table.
    fn integral(table: &Table) -> f64 {
        let (t, a) = (table.times(), table.values());
        (1..t.len())
            .map(|i| (t[i] - t[i - 1]) * (a[i] + a[i - 1]) / 2.0)
            .sum()
    }

    #[test]
    fn a_ricker_wavelet_has_its_printed_points_and_no_velocity_left() {
        let (f, at) = (2.0, 1.0);
        let pulse = ricker(3.0, f, at, 0.001).unwrap();
        assert_eq!(pulse.at(at), 3.0);
        // Zeros at t - at = 1/(sqrt 2 pi f), troughs -2 a exp(-3/2) at sqrt(3/2)/(pi f). Points are 1e-3 apart, so the chord
        // differs by at most (1e-3)^2/8 times the largest curvature 6 a (pi f)^2 = 711, which is 9e-5.
        let zero = 1.0 / (2f64.sqrt() * PI * f);
        let trough = 1.5f64.sqrt() / (PI * f);
        for side in [-1.0, 1.0] {
            assert!(pulse.at(at + side * zero).abs() < 9e-5);
            assert!((pulse.at(at + side * trough) + 6.0 * (-1.5f64).exp()).abs() < 9e-5);
        }
        // The integral of the whole wavelet is 0; beyond +-1 it is (t - at) a exp(-x) < 3 exp(-39). The trapezium rule is exact to
        // round-off for a smooth function that vanishes at its ends: 2000 terms below 3e-3.
        assert!(integral(&pulse).abs() < 1e-14, "{}", integral(&pulse));
        assert_eq!(pulse.at(2.1), 0.0);
    }

    #[test]
    fn a_wavelet_that_is_cut_off_jumps_to_zero() {
        let pulse = ricker(1.0, 0.1, 1.0, 0.3).unwrap();
        let x = (PI * 0.1) * (PI * 0.1);
        let cut = (1.0 - 2.0 * x) * (-x).exp();
        // Two roundings in the test's own form.
        assert!((pulse.at(0.0) - cut).abs() < 1e-15 && (pulse.at(2.0 - 1e-15) - cut).abs() < 1e-14);
        assert_eq!([pulse.at(2.0), pulse.at(3.0)], [0.0, 0.0]);
        assert_eq!(pulse.times().len(), 9); // 0, 0.3 .. 1.8, 2 and the jump.
    }

    #[test]
    fn a_cosine_pulse_is_a_sine_cycle_of_acceleration() {
        let pulse = cosine(2.0, 4.0, 0.5).unwrap();
        assert_eq!(pulse.times(), [0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0]);
        let expected = [
            0.0,
            2f64.sqrt(),
            2.0,
            2f64.sqrt(),
            0.0,
            -(2f64.sqrt()),
            -2.0,
            -(2f64.sqrt()),
            0.0,
        ];
        // Round-off of the sine.
        let near = |(a, b): (&f64, f64)| (a - b).abs() < 1e-15;
        assert!(pulse.values().iter().zip(expected).all(near), "{pulse:?}");
    }

    #[test]
    fn an_end_that_is_a_multiple_up_to_roundoff_has_no_short_interval() {
        // In floating point 0.3/0.1 is just below 3, 2.1/0.3 just above 7 and 2.7/0.3 just above 9.
        for (end, sampled, intervals) in
            [(0.3, 0.1, 3), (2.1, 0.3, 7), (2.7, 0.3, 9), (2.0, 0.3, 7)]
        {
            let times = cosine(1.0, end, sampled).unwrap().times().to_vec();
            assert_eq!((times.len(), times[intervals]), (intervals + 1, end));
        }
    }

    #[test]
    fn numbers_that_make_no_pulse_are_refused() {
        for (pulse, fault) in [
            (ricker(1.0, -1.0, 1.0, 0.1), "frequency must be > 0, got -1"),
            (ricker(1.0, 1.0, 0.0, 0.1), "at must be > 0, got 0"),
            (ricker(f64::NAN, 1.0, 1.0, 0.1), "the pulse must be finite"),
            (
                cosine(1.0, f64::INFINITY, 0.1),
                "period must be > 0, got inf",
            ),
            (cosine(1.0, 1.0, f64::NAN), "sampled must be > 0, got NaN"),
            (
                cosine(1.0, 1.0, 1e-8),
                "sampled must give at most 10000000 points, got 100000000",
            ),
        ] {
            assert_eq!(pulse.unwrap_err().to_string(), fault);
        }
        // Far from the peak the wavelet is 0, also where x overflows.
        assert_eq!(
            ricker(1.0, 1e200, 1.0, 0.5).unwrap().values(),
            [0.0, 0.0, 1.0, 0.0, 0.0]
        );
    }
}
