//! Means of signals over steps in which the values at the ends do not give them.

use crate::system::structure::{Quantity, Signal};

/// A point closer than this part of a step to an end of it is at this end: round-off of i dt.
const AT_END: f64 = 1e-9;

/// What both ends may miss of the mean of a step with one point inside, over the largest value. Such an error turns back in the next
/// steps: a triangle of four steps and more keeps its impulse.
const MISSED: f64 = 0.0625;

/// Points and weights of Gauss's rule on 0..1, exact for cubics.
const GAUSS: [f64; 2] = [0.5 - 0.288_675_134_594_812_9, 0.5 + 0.288_675_134_594_812_9];

impl Signal {
    /// The steps of `dt`, by the number of their end, whose mean is not that of both ends, and the exact mean of each: those with a
    /// jump or several points of a table or of a motion inside, or with one that the ends miss by much, and all steps of the
    /// velocity of an imposed displacement.
    ///
    /// Elsewhere both ends have it to second order. A sine has none: it is smooth. Nor has a displacement: a step feels K u by the
    /// values at its ends.
    pub fn exact_means(&self, dt: f64, steps: usize) -> Vec<(usize, f64)> {
        let points = match self {
            Signal::Sine { .. } | Signal::Motion(_, Quantity::Displacement) => return Vec::new(),
            Signal::Motion(motion, Quantity::Velocity) if motion.is_by_displacement() => {
                let u = motion.at_steps(dt, steps);
                let means = u.windows(2).map(|pair| (pair[1][0] - pair[0][0]) / dt);
                return (1..).zip(means).collect();
            }
            Signal::Motion(motion, Quantity::Velocity | Quantity::Acceleration) => {
                inside(&motion.points(), dt, steps)
            }
            Signal::Table(table) => inside(table.times(), dt, steps),
        };
        if points.is_empty() {
            return Vec::new();
        }
        let ends = self.step_ends(dt, steps);
        let least = MISSED * self.largest_at_points();
        let same_step = |a: &f64, b: &f64| a.floor() == b.floor();
        let mut value = self.rising();
        let means = points.chunk_by(same_step).filter_map(|points| {
            let start = points[0].floor();
            let parts = points.iter().copied().chain([start + 1.0]);
            let (mut sum, mut from) = (0.0, start);
            for to in parts {
                let length = to - from;
                let values = GAUSS.map(|x| value((from + x * length) * dt));
                sum += 0.5 * length * (values[0] + values[1]);
                from = to;
            }
            let step = start as usize;
            let of_ends = 0.5 * (ends[1][step] + ends[0][step + 1]);
            let is_missed = points.len() > 1 || (sum - of_ends).abs() > least;
            is_missed.then_some((step + 1, sum))
        });
        means.collect()
    }

    /// The largest absolute value at the points.
    fn largest_at_points(&self) -> f64 {
        let most = |most: f64, x: f64| most.max(x.abs());
        match self {
            Signal::Sine { amplitude, .. } => amplitude.abs(),
            Signal::Table(table) => table.values().iter().copied().fold(0.0, most),
            Signal::Motion(motion, quantity) => {
                let points = motion.points().into_iter();
                let values = points.map(|time| motion.quantity(*quantity, time));
                values.fold(0.0, most)
            }
        }
    }
}

/// The points that are inside of the steps, in steps; the times rise.
fn inside(times: &[f64], dt: f64, steps: usize) -> Vec<f64> {
    let end = steps as f64;
    let first = times.partition_point(|time| *time <= 0.0);
    let in_steps = times[first..].iter().map(|time| time / dt);
    let points = in_steps.take_while(|point| *point < end);
    points
        .filter(|point| (point - point.round()).abs() > AT_END)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::structure::{Baseline, Motion, Table};
    use std::sync::Arc;

    /// The integral up to the end of the last step.
    fn sum(signal: &Signal, dt: f64, steps: usize) -> f64 {
        dt * signal.step_means(dt, steps)[1..].iter().sum::<f64>()
    }

    #[test]
    fn the_means_of_a_table_have_its_integral_wherever_its_points_are() {
        // A blow of 1000 from 2.1 to 2.9 ms, a triangle that three points of one step make, and lines.
        let tables = [
            (
                vec![0.0021, 0.0021, 0.0029, 0.0029],
                vec![0.0, 1e3, 1e3, 0.0],
                0.8,
            ),
            (
                vec![0.0331, 0.0334, 0.0342],
                vec![0.0, 5.0, 0.0],
                5.0 * 0.0011 / 2.0,
            ),
            (
                vec![0.013, 0.047, 0.0471, 0.09],
                vec![2.0, -1.0, 7.0, 7.0],
                0.026 + 0.017 + 3e-4 + 7.0 * 0.0529,
            ),
        ];
        for (times, values, integral) in tables {
            let is_blow = times.len() == 4 && times[0] == times[1];
            let table = Table::new(times, values).unwrap();
            let signal = Signal::Table(table.clone());
            for (dt, steps) in [
                (0.01, 10),
                (0.05, 2),
                (0.1 / 3.0, 3),
                (0.0007, 142),
                (0.1, 1),
            ] {
                let end = dt * steps as f64;
                let rest = signal.at(0.1) * (0.1 - end);
                let found = sum(&signal, dt, steps) + rest;
                // Round-off of sums of some 100 terms where all is in steps with several points; elsewhere what one point may miss.
                let largest = table
                    .values()
                    .iter()
                    .fold(0.0, |most: f64, x| most.max(x.abs()));
                let missed = if is_blow {
                    0.0
                } else {
                    2.0 * MISSED * largest * dt
                };
                assert!(
                    (found - integral).abs() < 1e-13 + missed,
                    "{dt}: {found} {integral}"
                );
            }
        }
    }

    #[test]
    fn the_means_of_a_motion_are_its_changes() {
        let points = ([0.003, 0.0041, 0.02, 0.027], [0.0, 0.1, 0.02, -0.3]);
        let displaced = Motion::through(&points.0, &points.1, 0.0).unwrap();
        let with_jump = Table::new(vec![0.0, 0.0013, 0.0013, 0.02], vec![0.0, 9.0, -30.0, 2.0]);
        let table = Signal::Table(with_jump.unwrap());
        let moved = Motion::new(&table, 1.0, 0.0017, Baseline::None).unwrap();
        for motion in [displaced, moved].map(Arc::new) {
            for (dt, steps) in [(0.01, 4), (0.002, 20), (0.04, 1)] {
                let [u, v, _] = motion.at(0.04);
                for (quantity, change) in [(Quantity::Velocity, u), (Quantity::Acceleration, v)] {
                    let signal = Signal::Motion(motion.clone(), quantity);
                    let found = sum(&signal, dt, steps);
                    let by_ends = quantity == Quantity::Velocity && !motion.is_by_displacement();
                    // The velocity of an acceleration is a parabola, of which steps without a point inside have the trapezoid; an
                    // acceleration may miss something at each of its points.
                    let points = motion.points().into_iter();
                    let largest = points.map(|t| motion.at(t)[2].abs()).fold(0.0, f64::max);
                    let limit = match quantity {
                        _ if by_ends => {
                            30.0 / 0.0187 * dt * dt * 0.04 + 4.0 * MISSED * v.abs().max(1.0) * dt
                        }
                        Quantity::Acceleration => 4.0 * MISSED * largest * dt,
                        Quantity::Velocity | Quantity::Displacement => 1e-12 * (1.0 + change.abs()),
                    };
                    assert!(
                        (found - change).abs() < limit,
                        "{quantity:?} {dt}: {found} {change}"
                    );
                }
            }
        }
    }
}
