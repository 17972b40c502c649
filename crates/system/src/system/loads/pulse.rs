//! Pulse-like ground accelerations, sampled.

use super::cycles::{self, Cycles};
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
    /// A number of frequencies that is not whole, or out of its range.
    NoSteps(f64),
    /// So many intervals from its start to its end.
    TooManyPoints(f64),
    /// An acceleration that is not finite.
    NotFinite,
}

impl fmt::Display for PulseFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PulseFault::NotPositive(name, value) => write!(f, "{name} must be > 0, got {value}"),
            PulseFault::NoSteps(value) => {
                write!(
                    f,
                    "steps must be a whole number from 2 to {MOST_STEPS}, got {value}"
                )
            }
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

/// A form of pulse: a function of time with numbers, from t = 0 to its end.
///
/// The first number is the amplitude, the last one the time between samples; all others are > 0. It is straight between samples, the
/// last of which is at its end, and 0 after it.
#[derive(Debug, Clone, Copy)]
pub struct Pulse {
    /// Its name in a study.
    pub name: &'static str,
    /// What it is, in one line.
    pub meaning: &'static str,
    /// Its numbers in this order, with their meanings.
    pub numbers: &'static [(&'static str, &'static str)],
    end: fn(&[f64]) -> f64,
    value: fn(&[f64], f64) -> f64,
    cycles: fn(&[f64]) -> Vec<Cycles>,
}

/// Meaning of `sampled`. The last sample is at the end also where the end is no multiple.
const SAMPLED: (&str, &str) = (
    "sampled",
    "time between samples, straight between, the last one at the end; then 0",
);

/// All forms.
pub const PULSES: [Pulse; 6] = [
    // [Ricker 1953]; its peak is at t = `at`.
    Pulse {
        name: "ricker",
        meaning: "a (1 - 2 x) exp(-x), x = (pi f (t - at))^2, from 0 to 2 at",
        numbers: &[
            ("amplitude", "a"),
            ("frequency", "f"),
            ("at", "time of the peak"),
            SAMPLED,
        ],
        end: |numbers| 2.0 * numbers[2],
        value: |numbers, t| {
            let root = PI * numbers[1] * (t - numbers[2]);
            let x = root * root;
            // Above 746 exp(-x) is 0, but an infinite x makes 1 - 2x infinite.
            if x > 746.0 {
                0.0
            } else {
                numbers[0] * (1.0 - 2.0 * x) * exp(-x)
            }
        },
        cycles: |_| Vec::new(),
    },
    // The velocity is 1 - cos.
    Pulse {
        name: "cosine",
        meaning: "one sine cycle",
        numbers: &[
            ("amplitude", "amplitude"),
            ("period", "length of the cycle"),
            SAMPLED,
        ],
        end: |numbers| numbers[1],
        value: |numbers, t| match t < numbers[1] {
            true => numbers[0] * sin(2.0 * PI * (t / numbers[1])),
            // Without the round-off of the sine.
            false => 0.0,
        },
        cycles: |_| Vec::new(),
    },
    Pulse {
        name: "half_sine",
        meaning: "a sin(pi t/duration)",
        numbers: &[("amplitude", "a"), DURATION, SAMPLED],
        end: |numbers| numbers[1],
        value: |numbers, t| match t < numbers[1] {
            true => numbers[0] * sin(PI * (t / numbers[1])),
            false => 0.0,
        },
        cycles: |_| Vec::new(),
    },
    Pulse {
        name: "haversine",
        meaning: "a sin(pi t/duration)^2",
        numbers: &[("amplitude", "a"), DURATION, SAMPLED],
        end: |numbers| numbers[1],
        value: |numbers, t| {
            let root = sin(PI * (t / numbers[1]));
            match t < numbers[1] {
                true => numbers[0] * (root * root),
                false => 0.0,
            }
        },
        cycles: |_| Vec::new(),
    },
    Pulse {
        name: "sweep",
        meaning: "a sine whose frequency changes evenly: a sin(2 pi (from t + (to - from) t^2/(2 duration)))",
        numbers: &[
            ("amplitude", "a"),
            ("from", "frequency at t = 0"),
            ("to", "frequency at the end"),
            DURATION,
            SAMPLED,
        ],
        end: |numbers| numbers[3],
        value: |numbers, t| {
            let [amplitude, from, to, duration] = numbers[..4] else {
                return 0.0;
            };
            let cycles = t * (from + 0.5 * (to - from) * (t / duration));
            amplitude * sin(2.0 * PI * cycles)
        },
        cycles: cycles::of_sweep,
    },
    Pulse {
        name: "stepped_sweep",
        meaning: "a sine with evenly spaced frequencies, each for the same time, without jumps, for figures of the kind response",
        numbers: &[
            ("amplitude", "amplitude"),
            ("from", "first frequency"),
            ("to", "last frequency"),
            (STEPS, "number of frequencies, at least 2"),
            DURATION,
            SAMPLED,
        ],
        end: |numbers| numbers[4],
        value: |numbers, t| {
            let [amplitude, from, to, steps, duration, _] = *numbers else {
                return 0.0;
            };
            let number = (t / duration * steps).floor().min(steps - 1.0);
            let [frequency, begin, phase] = cycles::step([from, to, steps, duration], number);
            amplitude * sin(2.0 * PI * (phase + frequency * (t - begin)))
        },
        cycles: cycles::of_stepped_sweep,
    },
];

/// The number that is whole, and its largest value.
const STEPS: &str = "steps";
const MOST_STEPS: f64 = 1e6;

/// The duration of a pulse.
const DURATION: (&str, &str) = ("duration", "its end");

impl Pulse {
    /// Most points of the pulse with these numbers: the intervals, their ends, and a jump.
    ///
    /// # Errors
    /// [`Pulse::table`] makes no pulse of them.
    pub fn points(&self, numbers: &[f64]) -> Result<usize, PulseFault> {
        let [amplitude, inner @ .., sampled] = numbers else {
            return Err(PulseFault::NotFinite);
        };
        for ((name, _), number) in self.numbers[1..].iter().zip(inner) {
            positive(name, *number)?;
            let is_whole = number.fract() == 0.0 && (2.0..=MOST_STEPS).contains(number);
            if *name == STEPS && !is_whole {
                return Err(PulseFault::NoSteps(*number));
            }
        }
        let intervals = intervals((self.end)(numbers), *sampled)?;
        match amplitude.abs() <= LARGEST {
            true => Ok(intervals + 2),
            false => Err(PulseFault::NotFinite),
        }
    }

    /// The whole cycles of the pulse with these numbers; none for a pulse that does not oscillate.
    pub fn cycles(&self, numbers: &[f64]) -> Vec<Cycles> {
        (self.cycles)(numbers)
    }

    /// The pulse with these numbers.
    ///
    /// # Errors
    /// A number is not > 0 or not finite, or it has too many points.
    pub fn table(&self, numbers: &[f64]) -> Result<Table, PulseFault> {
        self.points(numbers)?;
        let end = (self.end)(numbers);
        let sampled = numbers.last().copied().unwrap_or(end);
        let inner = (0..intervals(end, sampled)?).map(|i| i as f64 * sampled);
        let times: Vec<f64> = inner.chain([end]).collect();
        let values = times.iter().map(|t| (self.value)(numbers, *t)).collect();
        zero_beyond(times, values).ok_or(PulseFault::NotFinite)
    }
}

/// Largest amplitude of a pulse: the factor 1 - 2x of a wavelet does not overflow.
const LARGEST: f64 = 1e300;

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

    fn named(name: &str, numbers: &[f64]) -> Result<Table, PulseFault> {
        let pulse = PULSES.iter().find(|pulse| pulse.name == name).unwrap();
        assert_eq!(pulse.numbers.len(), numbers.len());
        pulse.table(numbers)
    }

    fn ricker(amplitude: f64, frequency: f64, at: f64, sampled: f64) -> Result<Table, PulseFault> {
        named("ricker", &[amplitude, frequency, at, sampled])
    }

    fn cosine(amplitude: f64, period: f64, sampled: f64) -> Result<Table, PulseFault> {
        named("cosine", &[amplitude, period, sampled])
    }

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
    fn half_sine_and_haversine_have_their_areas_and_end_at_zero() {
        // 2 a T/pi and a T/2. The trapezium rule of n intervals loses pi^2/12/n^2 of the first, nothing of the second, whose slopes
        // are 0 at both ends.
        let (a, duration) = (3.0, 0.5);
        let half = named("half_sine", &[a, duration, 1e-3]).unwrap();
        let exact = 2.0 * a * duration / PI;
        let lost = PI * PI / 12.0 / 500.0f64.powi(2);
        assert!((integral(&half) / exact - 1.0 + lost).abs() < 1e-9);
        let haversine = named("haversine", &[a, duration, 1e-3]).unwrap();
        assert!((integral(&haversine) / (0.5 * a * duration) - 1.0).abs() < 1e-13);
        for pulse in [half, haversine] {
            assert_eq!(pulse.values().last(), Some(&0.0));
            // The peak in the middle, which is a point.
            assert!((pulse.at(0.25) - a).abs() < 1e-15 * a);
        }
    }

    #[test]
    fn a_sweep_has_the_cycles_of_its_mean_frequency() {
        // From 1 to 3 per time in 10: 20 cycles, of which the k-th ends where t + t^2/10 = k, t = 5 (sqrt(1 + 0.4 k) - 1).
        let sweep = named("sweep", &[2.0, 1.0, 3.0, 10.0, 1e-3]).unwrap();
        for k in 0..=20 {
            let t = 5.0 * ((1.0 + 0.4 * f64::from(k)).sqrt() - 1.0);
            // A chord of 1e-3 is below the curve by up to (2 pi 3 1e-3)^2/8 of 2, and 0 is at the zero but for the slope of its chord.
            assert!(sweep.at(t).abs() < 1e-4, "{k}: {}", sweep.at(t));
        }
        let signs = sweep.values().windows(2);
        let changes = signs.filter(|pair| pair[0] * pair[1] < 0.0).count();
        // Zeros at points are no changes of sign: those at t = 0 and the end.
        assert!((37..=39).contains(&changes), "{changes}");
        // Down as well as up.
        let down = named("sweep", &[2.0, 3.0, 1.0, 10.0, 1e-3]).unwrap();
        for t in [0.3, 4.0, 7.7] {
            assert!((down.at(10.0 - t) + sweep.at(t)).abs() < 1e-3, "{t}");
        }
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
                named("stepped_sweep", &[1.0, 1.0, 2.0, 2.5, 9.0, 0.1]),
                "steps must be a whole number from 2 to 1000000, got 2.5",
            ),
            (
                named("stepped_sweep", &[1.0, 1.0, 2.0, 1.0, 9.0, 0.1]),
                "steps must be a whole number from 2 to 1000000, got 1",
            ),
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
