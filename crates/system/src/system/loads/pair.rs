//! The two horizontal components of a station as one: strengths of a pair, and the peaks of its motion turned by angles.
//!
//! RotDnn `[Boore 2010]`: the response to the motion turned by an angle is the sum of the responses to the components times cosine and
//! sine, and RotD50 and RotD100 are the median and the largest of its peaks over the angles 0, 1, .., 179 degrees.

use super::measures::Measure;
use super::spectrum::{ANGLES, StraightPiece, directions, spectrum, turned_responses};
use crate::system::structure::Table;
use libm::hypot;

/// The strength of a pair.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Component {
    /// The square root of the product of both.
    GeometricMean,
    /// The square root of the sum of both squares.
    Srss,
    /// The median over the angles.
    RotD50,
    /// The largest one over the angles.
    RotD100,
}

impl Component {
    /// All of them.
    pub const ALL: [Component; 4] = [
        Component::GeometricMean,
        Component::Srss,
        Component::RotD50,
        Component::RotD100,
    ];

    /// Its name in studies.
    pub fn name(self) -> &'static str {
        match self {
            Component::GeometricMean => "geometric-mean",
            Component::Srss => "srss",
            Component::RotD50 => "rotd50",
            Component::RotD100 => "rotd100",
        }
    }

    /// The largest acceleration or the pseudo-acceleration of a pair; `None` for other measures, and if the pair has none.
    pub fn of(self, pair: [&Table; 2], measure: Measure) -> Option<f64> {
        let each = || -> Option<[f64; 2]> {
            let one = |table: &Table| match measure {
                Measure::PeakAcceleration => Some(peak(table.values().iter().copied())),
                Measure::Spectral { period, ratio } => {
                    let ordinates = spectrum(table, &[period], ratio)?;
                    Some(ordinates.first()?.pseudo_acceleration())
                }
                Measure::PeakVelocity
                | Measure::PeakDisplacement
                | Measure::Arias
                | Measure::Duration
                | Measure::MeanPeriod => None,
            };
            Some([one(pair[0])?, one(pair[1])?])
        };
        let value = match self {
            Component::GeometricMean => each().map(|[a, b]| (a * b).sqrt()),
            Component::Srss => each().map(|[a, b]| hypot(a, b)),
            Component::RotD50 => turned(pair, measure).map(median),
            Component::RotD100 => turned(pair, measure).map(|peaks| peak(peaks.into_iter())),
        };
        value.filter(|value| value.is_finite())
    }
}

/// The largest acceleration or pseudo-acceleration of a pair for each angle from 0 to 179 degrees.
fn turned(pair: [&Table; 2], measure: Measure) -> Option<Vec<f64>> {
    let pieces = pieces(pair);
    match measure {
        Measure::PeakAcceleration => {
            let mut peaks = vec![0.0_f64; ANGLES];
            let ends = pieces.iter().flat_map(|piece| piece.accelerations);
            for [a, b] in ends {
                for (peak, [c, s]) in peaks.iter_mut().zip(directions()) {
                    *peak = peak.max((c * a + s * b).abs());
                }
            }
            Some(peaks)
        }
        Measure::Spectral { period, ratio } => {
            let rest = pair.map(|table| table.values().last().copied().unwrap_or_default());
            turned_responses(&pieces, rest, [period, ratio])
        }
        Measure::PeakVelocity
        | Measure::PeakDisplacement
        | Measure::Arias
        | Measure::Duration
        | Measure::MeanPeriod => None,
    }
}

/// The pieces of two accelerations between the points of both; 0 before the own first point, constant after the last one.
fn pieces(pair: [&Table; 2]) -> Vec<StraightPiece> {
    let mut times = [pair[0].times(), pair[1].times()].concat();
    times.sort_unstable_by(f64::total_cmp);
    times.dedup();
    let mut next = [0, 0];
    let piece = |ends: &[f64]| {
        for (next, table) in next.iter_mut().zip(pair) {
            while table.times().get(*next).is_some_and(|t| *t <= ends[0]) {
                *next += 1;
            }
        }
        let at = |t: f64| [0, 1].map(|i| value(pair[i], next[i], t));
        StraightPiece {
            times: [ends[0], ends[1]],
            accelerations: [at(ends[0]), at(ends[1])],
        }
    };
    times.windows(2).map(piece).collect()
}

/// The value at a time of the piece before the point `next`; before a jump at its end.
fn value(table: &Table, next: usize, t: f64) -> f64 {
    let (times, values) = (table.times(), table.values());
    match (next.checked_sub(1), times.get(next)) {
        (None, _) => 0.0,
        (Some(before), None) => values[before],
        (Some(_), Some(end)) if *end == t => values[next],
        (Some(before), Some(end)) => {
            let part = (t - times[before]) / (end - times[before]);
            values[before] + (values[next] - values[before]) * part
        }
    }
}

/// The largest magnitude.
fn peak(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, |peak: f64, x| peak.max(x.abs()))
}

/// The mean of the two middle ones of an even number of values.
fn median(mut values: Vec<f64>) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    let middle = values.len() / 2;
    0.5 * (values[middle - 1] + values[middle])
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    const RATIO: f64 = 0.05;

    fn near(a: f64, b: f64, tolerance: f64) {
        assert!((a - b).abs() <= tolerance * b.abs(), "{a} {b}");
    }

    fn table(points: impl Iterator<Item = (f64, f64)>) -> Table {
        let (times, values) = points.unzip();
        Table::new(times, values).unwrap()
    }

    /// A motion with several frequencies, at points `dt` apart; it ends with a jump.
    fn motion(dt: f64, phase: f64) -> Table {
        let count = (12.0 / dt).round() as usize;
        let at =
            |t: f64| (3.0 * t + phase).sin() + 0.7 * (7.1 * t - phase).cos() * (-0.1 * t).exp();
        let points = (0..=count).map(|i| (i as f64 * dt, at(i as f64 * dt)));
        table(points.chain([(count as f64 * dt, 0.0)]))
    }

    fn spectral(period: f64) -> Measure {
        Measure::Spectral {
            period,
            ratio: RATIO,
        }
    }

    fn both(pair: [&Table; 2]) -> impl Fn(Component, Measure) -> f64 {
        move |component, measure| component.of(pair, measure).unwrap()
    }

    #[test]
    fn equal_components_have_closed_forms() {
        // u (cos a + sin a) = sqrt(2) u cos(a - 45): largest sqrt(2) Sa, the SRSS, and the median of |cos| is cos 45, so Sa.
        let record = motion(0.01, 0.4);
        let of = both([&record, &record]);
        for measure in [spectral(0.3), spectral(2.0), Measure::PeakAcceleration] {
            let alone = measure.of(&record, 9.81).unwrap();
            // Round-off of cosine and sine.
            near(
                of(Component::RotD100, measure),
                2.0_f64.sqrt() * alone,
                1e-14,
            );
            near(of(Component::Srss, measure), 2.0_f64.sqrt() * alone, 1e-14);
            near(of(Component::RotD50, measure), alone, 1e-14);
            near(of(Component::GeometricMean, measure), alone, 1e-14);
        }
    }

    #[test]
    fn one_component_alone_is_the_largest_one_at_its_own_angle() {
        let (moving, still) = (
            motion(0.01, 1.0),
            table([(0.0, 0.0), (9.0, 0.0)].into_iter()),
        );
        for pair in [[&moving, &still], [&still, &moving]] {
            let of = both(pair);
            let alone = spectral(0.7).of(&moving, 9.81).unwrap();
            near(of(Component::RotD100, spectral(0.7)), alone, 1e-14);
            near(
                of(Component::RotD50, spectral(0.7)),
                alone / 2.0_f64.sqrt(),
                1e-14,
            );
            near(of(Component::Srss, spectral(0.7)), alone, 1e-14);
            assert_eq!(of(Component::GeometricMean, spectral(0.7)), 0.0);
        }
    }

    #[test]
    fn a_circle_is_the_same_at_all_angles() {
        // A point for each degree, slowly begun. The free vibration from the end of the slow start is 3 % of the steady one; after 12
        // periods, with exp(-0.2 2 pi 12) = 3e-7 of it left, it is in phase: 1e-8 of the peaks.
        let ramp = |i: u32| (f64::from(i) / 360.0 / 30.0).min(1.0);
        let wave = |f: fn(f64) -> f64| {
            let degree = |i: u32| f(f64::from(i) * PI / 180.0);
            let points = (0..360 * 60).map(|i| (f64::from(i) / 360.0, ramp(i) * degree(i)));
            table(points.chain([(60.0, 0.0)]))
        };
        let (x, y) = (wave(f64::cos), wave(f64::sin));
        let of = both([&x, &y]);
        near(of(Component::RotD50, Measure::PeakAcceleration), 1.0, 1e-14);
        near(
            of(Component::RotD100, Measure::PeakAcceleration),
            1.0,
            1e-14,
        );
        let at_resonance = Measure::Spectral {
            period: 1.0,
            ratio: 0.2,
        };
        let [median, most] =
            [Component::RotD50, Component::RotD100].map(|component| of(component, at_resonance));
        near(median, most, 1e-8);
        // 1/(2 zeta), and straight lines between points x apart have the amplitude (sin(x/2)/(x/2))^2; their other frequencies are from
        // 359 on, with 1e-5 of the amplitude and 1e-5 of the response.
        let half = PI / 360.0;
        near(most, (half.sin() / half).powi(2) / 0.4, 1e-8);
    }

    #[test]
    fn the_peaks_are_those_of_the_turned_motions() {
        // The second component begins later, with a jump, and has points of its own.
        let early = motion(0.013, 0.7);
        let late_times = early.times().iter().map(|t| t + 0.5);
        let late = late_times.zip(early.values().iter().copied());
        let pair = [
            &motion(0.01, 0.0),
            &table([(0.5, 0.0)].into_iter().chain(late)),
        ];
        let turned_peaks = turned(pair, spectral(0.4)).unwrap();
        for degrees in [0, 31, 90, 145, 179] {
            let [c, s] = directions().nth(degrees).unwrap();
            let pieces = pieces(pair);
            let sum = |[a, b]: [f64; 2]| c * a + s * b;
            let ends = pieces.iter().flat_map(|piece| {
                let [from, to] = piece.accelerations.map(sum);
                [(piece.times[0], from), (piece.times[1], to)]
            });
            let mut points: Vec<(f64, f64)> = ends.collect();
            points.dedup();
            points.push((points[points.len() - 1].0 + 1.0, 0.0));
            let before = points.len() - 2;
            points.insert(before + 1, (points[before].0 + 1e-9, 0.0));
            let alone = spectral(0.4).of(&table(points.into_iter()), 9.81).unwrap();
            // The last jump takes 1e-9 s.
            near(turned_peaks[degrees], alone, 1e-9);
        }
        // The values of the pieces are those of the tables.
        for piece in pieces(pair) {
            let middle = 0.5 * (piece.times[0] + piece.times[1]);
            for (i, table) in pair.into_iter().enumerate() {
                let mean = 0.5 * (piece.accelerations[0][i] + piece.accelerations[1][i]);
                assert!((mean - table.at(middle)).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn other_measures_and_oscillators_have_none() {
        let record = motion(0.01, 0.0);
        for component in Component::ALL {
            assert_eq!(component.of([&record, &record], Measure::Arias), None);
            assert_eq!(component.of([&record, &record], spectral(-1.0)), None);
        }
    }

    fn points(times: &[f64], values: &[f64]) -> Table {
        table(times.iter().copied().zip(values.iter().copied()))
    }

    /// An acceleration of 1 at 0.3 degrees: its parts at the angles are cos 0.3, 0.7, 1.3, 1.7 .. 89.7 degrees, of which those of 44.7
    /// and 45.3 degrees are in the middle.
    #[test]
    fn rotd50_is_the_mean_of_the_two_middle_peaks() {
        let cos = |degrees: f64| libm::cos(degrees * PI / 180.0);
        let constant = |x: f64| points(&[0.0, 1.0], &[x, x]);
        let pair = [constant(cos(0.3)), constant(cos(89.7))];
        let found = both([&pair[0], &pair[1]])(Component::RotD50, Measure::PeakAcceleration);
        near(found, 0.5 * (cos(44.7) + cos(45.3)), 1e-14);
    }

    /// A shorter component goes on with its last value: 3 and 4 act at once, at 53.13 degrees from x.
    #[test]
    fn a_component_keeps_its_last_value() {
        let x = points(&[0.0, 1.0], &[3.0, 3.0]);
        let y = points(&[0.0, 1.0, 2.0], &[0.0, 0.0, 4.0]);
        for (pair, angle) in [([&x, &y], 53.0), ([&y, &x], 37.0)] {
            let found = both(pair)(Component::RotD100, Measure::PeakAcceleration);
            let [a, b] = if angle == 53.0 {
                [3.0, 4.0]
            } else {
                [4.0, 3.0]
            };
            let from_angle = libm::atan2(b, a) - angle * PI / 180.0;
            near(found, 5.0 * libm::cos(from_angle), 1e-14);
        }
    }

    /// A sudden acceleration that stays overshoots by exp(-ratio pi/(1 - ratio^2)^(1/2)), half a period after its record ends.
    #[test]
    fn an_oscillator_swings_on_under_the_last_value() {
        let x = points(&[0.0, 0.01], &[2.0, 2.0]);
        let y = points(&[0.0, 0.01], &[0.0, 0.0]);
        let overshoot = libm::exp(-RATIO * PI / (1.0 - RATIO * RATIO).sqrt());
        let wanted = 2.0 * (1.0 + overshoot);
        for (pair, part) in [([&x, &y], 1.0), ([&x, &x], 2.0_f64.sqrt())] {
            let found = both(pair)(Component::RotD100, spectral(1.0));
            near(found, part * wanted, 1e-9);
        }
    }
}
