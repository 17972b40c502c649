//! Intensity measures of a ground acceleration that is straight between its points.

use super::spectrum::{arias, spectrum};
use crate::system::structure::Table;
use libm::{cos, sin};
use std::f64::consts::PI;

/// An intensity measure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Measure {
    /// Largest |a|.
    PeakAcceleration,
    /// Largest |v| of the acceleration integrated from rest, also between the points.
    PeakVelocity,
    /// Largest |u| of the acceleration integrated twice from rest, also between the points.
    PeakDisplacement,
    /// Arias intensity.
    Arias,
    /// Time from 5 to 95 % of the Arias intensity.
    Duration,
    /// Pseudo-acceleration of an oscillator.
    Spectral {
        /// Its period without damping.
        period: f64,
        /// Its damping ratio.
        ratio: f64,
    },
    /// Mean period.
    MeanPeriod,
}

/// Frequencies between which the mean period is a mean, in 1/s `[Rathje et al. 1998]`.
const FREQUENCIES: [f64; 2] = [0.25, 20.0];

/// Most products of points and frequencies of a mean period.
const MOST: f64 = 1e10;

impl Measure {
    /// Its value for an acceleration; g in the unit of length of the acceleration. `None` if it has none, because the acceleration
    /// is 0 or has too many points, or because the oscillator is none.
    pub fn of(self, acceleration: &Table, gravity: f64) -> Option<f64> {
        let value = match self {
            Measure::PeakAcceleration => peak(acceleration.values().iter().copied()),
            Measure::PeakVelocity => from_rest(acceleration)[0],
            Measure::PeakDisplacement => from_rest(acceleration)[1],
            Measure::Arias => arias(acceleration, gravity),
            Measure::Duration => duration(acceleration)?,
            Measure::Spectral { period, ratio } => {
                let ordinates = spectrum(acceleration, &[period], ratio)?;
                ordinates.first()?.pseudo_acceleration()
            }
            Measure::MeanPeriod => mean_period(acceleration)?,
        };
        value.is_finite().then_some(value)
    }

    /// Its value for `factor` times an acceleration for which it is `value`.
    pub fn scaled(self, value: f64, factor: f64) -> f64 {
        match self {
            Measure::PeakAcceleration
            | Measure::PeakVelocity
            | Measure::PeakDisplacement
            | Measure::Spectral { .. } => value * factor.abs(),
            Measure::Arias => value * (factor * factor),
            Measure::Duration | Measure::MeanPeriod => value,
        }
    }
}

/// The largest magnitude.
fn peak(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, |peak: f64, x| peak.max(x.abs()))
}

/// Largest |v| and |u| from rest at the first point: extremes of a parabola and a cubic on each interval.
fn from_rest(acceleration: &Table) -> [f64; 2] {
    let (times, values) = (acceleration.times(), acceleration.values());
    let [mut u, mut v, mut top_u, mut top_v] = [0.0_f64; 4];
    for i in 1..times.len() {
        let h = times[i] - times[i - 1];
        let (a, step) = (values[i - 1], values[i] - values[i - 1]);
        // tau from 0 to 1.
        let speed = |tau: f64| v + h * tau * (a + 0.5 * tau * step);
        let displacement = |tau: f64| u + h * tau * (v + h * tau * (0.5 * a + tau * step / 6.0));
        let turn = -a / step;
        if turn > 0.0 && turn < 1.0 {
            top_v = top_v.max(speed(turn).abs());
        }
        for tau in zeros([v, h * a, 0.5 * h * step]) {
            if tau > 0.0 && tau < 1.0 {
                top_u = top_u.max(displacement(tau).abs());
            }
        }
        [u, v] = [displacement(1.0), speed(1.0)];
        [top_u, top_v] = [top_u.max(u.abs()), top_v.max(v.abs())];
    }
    [top_v, top_u]
}

/// The zeros of c0 + c1 x + c2 x^2; NaN or infinite where there are less than two.
fn zeros([c0, c1, c2]: [f64; 3]) -> [f64; 2] {
    let root = (c1 * c1 - 4.0 * c2 * c0).sqrt();
    // Without a difference of nearly equal numbers.
    let q = -0.5 * (c1 + root.copysign(c1));
    [q / c2, c0 / q]
}

/// The time from 5 to 95 % of the integral of a^2 by trapezoids, straight between the points.
fn duration(acceleration: &Table) -> Option<f64> {
    let (t, a) = (acceleration.times(), acceleration.values());
    let mut sums = vec![0.0];
    let mut sum = 0.0;
    for i in 1..t.len() {
        sum += (t[i] - t[i - 1]) * (a[i - 1] * a[i - 1] + a[i] * a[i]) / 2.0;
        sums.push(sum);
    }
    if sum <= 0.0 {
        return None;
    }
    let reached = |part: f64| {
        let wanted = part * sum;
        let next = sums.partition_point(|sum| *sum < wanted).max(1);
        let [before, after] = [*sums.get(next - 1)?, *sums.get(next)?];
        Some(t[next - 1] + (t[next] - t[next - 1]) * ((wanted - before) / (after - before)))
    };
    Some(reached(0.95)? - reached(0.05)?)
}

/// The mean of 1/f weighted by the squared Fourier amplitudes at f = k/T from 0.25 to 20 Hz `[Rathje et al. 1998]`.
///
/// T is the time that the points cover, each of them up to the next one, the last one as long as the one before. Of points at equal
/// distances these are the frequencies and amplitudes of the discrete Fourier transform.
fn mean_period(acceleration: &Table) -> Option<f64> {
    let (t, a) = acceleration.own_points();
    let n = t.len();
    let mut widths: Vec<f64> = t.windows(2).map(|pair| pair[1] - pair[0]).collect();
    widths.push(*widths.last()?);
    let whole = t[n - 1] - t[0] + widths[n - 1];
    // Round-off of a multiple.
    let first = (FREQUENCIES[0] * whole * (1.0 - 1e-12)).ceil().max(1.0);
    let last = (FREQUENCIES[1] * whole * (1.0 + 1e-12)).floor();
    if (last - first) * n as f64 > MOST {
        return None;
    }
    let [mut sum, mut weighted] = [0.0; 2];
    for k in first as u64..=last as u64 {
        let f = k as f64 / whole;
        let square = power(t, a, &widths, 2.0 * PI * f);
        sum += square;
        weighted += square / f;
    }
    (sum > 0.0).then(|| weighted / sum)
}

/// The squared magnitude of the sum of a exp(-i omega t) times the widths.
fn power(t: &[f64], a: &[f64], widths: &[f64], omega: f64) -> f64 {
    let [mut re, mut im] = [0.0; 2];
    // One angle for each width that differs from the one before: points at equal distances turn by one.
    let mut turn = [1.0, 0.0];
    let mut width = f64::NAN;
    let mut unit = [1.0, 0.0];
    for (i, (a, piece_width)) in a.iter().zip(widths).enumerate() {
        // Round-off of products is lost now and then.
        if i % 256 == 0 {
            let angle = omega * (t[i] - t[0]);
            unit = [cos(angle), sin(angle)];
        }
        re += a * piece_width * unit[0];
        im += a * piece_width * unit[1];
        if piece_width.to_bits() != width.to_bits() {
            width = *piece_width;
            turn = [cos(omega * piece_width), sin(omega * piece_width)];
        }
        unit = [
            unit[0] * turn[0] - unit[1] * turn[1],
            unit[0] * turn[1] + unit[1] * turn[0],
        ];
    }
    re * re + im * im
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::loads::STANDARD_GRAVITY;

    fn table(points: &[[f64; 2]]) -> Table {
        let column = |j: usize| points.iter().map(|point| point[j]).collect();
        Table::new(column(0), column(1)).unwrap()
    }

    fn of(measure: Measure, table: &Table) -> f64 {
        measure.of(table, STANDARD_GRAVITY).unwrap()
    }

    fn near(a: f64, b: f64, tolerance: f64) {
        assert!((a - b).abs() <= tolerance * b.abs(), "{a} {b}");
    }

    #[test]
    fn peaks_between_points_count() {
        // a = 2 - 4 t on [0, 1]: v = 2 t - 2 t^2 with 1/2 at t = 1/2, u = t^2 - 2 t^3/3 with 1/3 at the end. Then a = -2 + 1.5 s
        // on 2 s: v = -2 s + 0.75 s^2, extreme -4/3 at s = 4/3, and u = 1/3 - s^2 + s^3/4 falls up to s = 2 with 1/3 - 2.
        let motion = table(&[[0.0, 2.0], [1.0, -2.0], [3.0, 1.0]]);
        near(of(Measure::PeakAcceleration, &motion), 2.0, 0.0);
        near(of(Measure::PeakVelocity, &motion), 4.0 / 3.0, 1e-15);
        near(of(Measure::PeakDisplacement, &motion), 5.0 / 3.0, 1e-15);
        // a = 1 for 1 s, then -2 for 1 s: v is 0 at 1.5 s, where u = 1/2 + 1/2 - 1/4.
        let turned = table(&[[0.0, 1.0], [1.0, 1.0], [1.0, -2.0], [2.0, -2.0]]);
        near(of(Measure::PeakDisplacement, &turned), 0.75, 1e-15);
    }

    #[test]
    fn the_duration_of_a_constant_is_nine_tenths_of_it() {
        let motion = table(&[[1.0, 3.0], [2.0, 3.0], [5.0, 3.0]]);
        near(of(Measure::Duration, &motion), 0.9 * 4.0, 1e-14);
        assert_eq!(
            Measure::Duration.of(&table(&[[0.0, 0.0], [1.0, 0.0]]), 9.81),
            None
        );
    }

    #[test]
    fn the_mean_period_of_cosines_is_weighted_by_their_squares() {
        // Whole cycles: 2 Hz with the amplitude 3, 5 Hz with 1, and 0.1 Hz and 30 Hz, which do not count.
        let point = |i: u32| {
            let t = f64::from(i) * 0.01;
            let wave = |f: f64| (2.0 * PI * f * t).cos();
            [
                t,
                3.0 * wave(2.0) + wave(5.0) + 4.0 * wave(0.1) + 2.0 * wave(30.0),
            ]
        };
        let points: Vec<[f64; 2]> = (0..1000).map(point).collect();
        let motion = table(&points);
        let expected = (9.0 / 2.0 + 1.0 / 5.0) / 10.0;
        // Sums of 1000 terms.
        near(of(Measure::MeanPeriod, &motion), expected, 1e-11);
        // A jump to 0 at the end is none of the points.
        let ended = table(&[&points[..], &[[9.99, 0.0]]].concat());
        assert_eq!(
            of(Measure::MeanPeriod, &ended),
            of(Measure::MeanPeriod, &motion)
        );
    }

    #[test]
    fn measures_follow_the_scale() {
        let motion = table(&[[0.0, 0.0], [0.2, 1.0], [0.5, -2.0], [0.9, 0.7], [1.3, 0.0]]);
        let scaled = motion.clone().scaled(-3.0).unwrap();
        let spectral = Measure::Spectral {
            period: 0.6,
            ratio: 0.05,
        };
        for measure in [
            Measure::PeakAcceleration,
            Measure::PeakVelocity,
            Measure::PeakDisplacement,
            Measure::Arias,
            Measure::Duration,
            spectral,
        ] {
            let expected = measure.scaled(of(measure, &motion), -3.0);
            near(of(measure, &scaled), expected, 1e-13);
        }
        assert_eq!(
            Measure::Spectral {
                period: -1.0,
                ratio: 0.05
            }
            .of(&motion, 9.81),
            None
        );
    }
}
