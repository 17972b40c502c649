//! Loads as functions of time.

use crate::system::structure::{Motion, Quantity};
use libm::sin;
use std::sync::Arc;

/// A function of time.
#[derive(Debug, Clone, PartialEq)]
pub enum Signal {
    /// amplitude sin(omega t + phase).
    Sine {
        /// Amplitude.
        amplitude: f64,
        /// Circular frequency.
        omega: f64,
        /// Phase.
        phase: f64,
    },
    /// Straight lines between points.
    Table(Table),
    /// A quantity of the motion of a support.
    Motion(Arc<Motion>, Quantity),
}

/// Straight lines between points (t, f); constant before the first one and after the last one.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    times: Vec<f64>,
    values: Vec<f64>,
}

impl Table {
    /// A table of points, at least one; `None` unless all numbers are finite and the times rise.
    ///
    /// Two points may have one time: the function jumps there, and the second value holds from then on.
    pub fn new(times: Vec<f64>, values: Vec<f64>) -> Option<Table> {
        let rise = times.is_sorted() && times.windows(3).all(|t| t[0] < t[2]);
        let finite = times.iter().chain(&values).all(|x| x.is_finite());
        (rise && finite && !times.is_empty() && times.len() == values.len())
            .then_some(Table { times, values })
    }

    /// The same times a factor; `None` if a value is not finite.
    pub fn scaled(mut self, factor: f64) -> Option<Table> {
        self.values.iter_mut().for_each(|f| *f *= factor);
        Table::new(self.times, self.values)
    }

    /// Times of the points.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// Values of the points.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Times and values without a jump from 0 at the first point and one to 0 at the last point, with which a motion starts and ends.
    pub fn own_points(&self) -> (&[f64], &[f64]) {
        let (t, f) = (&self.times, &self.values);
        let count = t.len();
        let first = count > 1 && t[0] == t[1] && f[0] == 0.0;
        let last = count > 1 && t[count - 2] == t[count - 1] && f[count - 1] == 0.0;
        let range = usize::from(first)..count - usize::from(last && count > 2);
        (&t[range.clone()], &f[range])
    }

    /// The value at time t; at a jump the one from then on.
    pub fn at(&self, t: f64) -> f64 {
        self.after(self.times.partition_point(|time| *time <= t), t)
    }

    /// The value at time t, before which there are `after` points.
    fn after(&self, after: usize, t: f64) -> f64 {
        let Some(before) = after.checked_sub(1) else {
            return self.values[0];
        };
        let Some(next) = self.times.get(after) else {
            return self.values[before];
        };
        let [t0, f0, f1] = [self.times[before], self.values[before], self.values[after]];
        f0 + (f1 - f0) * ((t - t0) / (next - t0))
    }
}

impl Signal {
    /// The same value at all times.
    pub fn constant(value: f64) -> Signal {
        Signal::Table(Table {
            times: vec![0.0],
            values: vec![value],
        })
    }

    /// The value at time t.
    pub fn at(&self, t: f64) -> f64 {
        match self {
            Signal::Sine {
                amplitude,
                omega,
                phase,
            } => amplitude * sin(omega * t + phase),
            Signal::Table(table) => table.at(t),
            Signal::Motion(motion, quantity) => motion.quantity(*quantity, t),
        }
    }

    /// The times at which it jumps, with the values before and after.
    fn jumps(&self) -> Vec<(f64, [f64; 2])> {
        match self {
            Signal::Table(table) => {
                let pairs = table.times.windows(2).zip(table.values.windows(2));
                let jumps = pairs.filter(|(times, _)| times[0] == times[1]);
                jumps
                    .map(|(times, values)| (times[0], [values[0], values[1]]))
                    .collect()
            }
            Signal::Motion(motion, Quantity::Acceleration) => motion.jumps(),
            Signal::Motion(..) | Signal::Sine { .. } => Vec::new(),
        }
    }

    /// Means over the step that ends at 0, dt, .. steps dt; the first one has no meaning. They are by the values at both ends, and
    /// exact for the steps of [`Signal::exact_means`].
    pub fn step_means(&self, dt: f64, steps: usize) -> Vec<f64> {
        let [before, after] = self.step_ends(dt, steps);
        let pairs = std::iter::once(after[0])
            .chain(after.iter().copied())
            .zip(before);
        let mut means: Vec<f64> = pairs.map(|(start, end)| 0.5 * (start + end)).collect();
        for (step, mean) in self.exact_means(dt, steps) {
            means[step] = mean;
        }
        means
    }

    /// The values at 0, dt, .. steps dt for the steps that end there, and for those that start there. Where a table jumps, the
    /// first are the values before the jump and the second those after it, so that a jump between steps is exact.
    pub fn step_ends(&self, dt: f64, steps: usize) -> [Vec<f64>; 2] {
        let after = self.at_steps(dt, steps);
        let mut before = after.clone();
        let mut after = after;
        for (time, [left, right]) in self.jumps() {
            let step = (time / dt).round();
            // Round-off of i dt.
            let at_step = (step * dt - time).abs() <= 1e-9 * dt;
            if at_step && step >= 0.0 && step <= steps as f64 {
                before[step as usize] = left;
                after[step as usize] = right;
            }
        }
        [before, after]
    }

    /// The values at 0, dt, .. steps dt, as [`Signal::at`] gives them.
    pub fn at_steps(&self, dt: f64, steps: usize) -> Vec<f64> {
        let mut value = self.rising();
        (0..=steps).map(|i| value(i as f64 * dt)).collect()
    }

    /// [`Signal::at`] for times that rise from call to call, so that no search is needed.
    pub(crate) fn rising(&self) -> Box<dyn FnMut(f64) -> f64 + '_> {
        let mut found = 0;
        match self {
            Signal::Sine { .. } => Box::new(|t| self.at(t)),
            Signal::Table(table) => Box::new(move |t| {
                found += table.times[found..]
                    .iter()
                    .take_while(|time| **time <= t)
                    .count();
                table.after(found, t)
            }),
            Signal::Motion(motion, quantity) => {
                Box::new(move |t| motion.at_later(t, &mut found)[*quantity as usize])
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_is_straight_between_its_points_and_constant_beyond() {
        let table = Table::new(vec![1.0, 2.0, 2.0, 4.0], vec![3.0, 5.0, -1.0, 0.0]).unwrap();
        let at = |t| table.at(t);
        assert_eq!([at(0.0), at(1.0), at(1.5)], [3.0, 3.0, 4.0]);
        assert_eq!([at(2.0), at(3.0), at(4.0), at(9.0)], [-1.0, -0.5, 0.0, 0.0]);
    }

    #[test]
    fn the_means_of_steps_give_the_integral_of_lines_and_jumps_between_steps() {
        // 0.1 (1 + 2) + 0.1 (2 - 4) ...: steps of 0.1 with jumps at 0.3 and 0.7, which are no multiples in binary numbers.
        let table = Table::new(
            vec![0.0, 0.3, 0.3, 0.7, 0.7, 1.0],
            vec![1.0, 4.0, -2.0, 6.0, 0.5, 0.5],
        );
        let signal = Signal::Table(table.unwrap());
        let means = signal.step_means(0.1, 10);
        assert_eq!(means.len(), 11);
        let integral = 0.1 * means[1..].iter().sum::<f64>();
        let exact = 0.3 * 2.5 + 0.4 * 2.0 + 0.3 * 0.5;
        assert!((integral - exact).abs() < 1e-14, "{integral} {exact}");
        assert!((means[3] - 3.5).abs() < 1e-14 && (means[4] + 1.0).abs() < 1e-14);
    }

    #[test]
    fn the_values_at_steps_are_those_at_their_times() {
        let table = Table::new(
            vec![0.1, 0.25, 0.25, 0.7, 0.71],
            vec![3.0, 5.0, -1.0, 0.3, 0.9],
        );
        let sine = Signal::Sine {
            amplitude: 2.0,
            omega: 3.0,
            phase: 0.4,
        };
        for signal in [Signal::Table(table.unwrap()), sine] {
            for dt in [0.05, 0.1, 0.013, 2.0] {
                let expected: Vec<f64> = (0..=40).map(|i| signal.at(f64::from(i) * dt)).collect();
                assert_eq!(signal.at_steps(dt, 40), expected);
            }
        }
    }

    #[test]
    fn times_that_do_not_rise_make_no_table() {
        let table = |times: &[f64]| Table::new(times.to_vec(), vec![1.0; times.len()]);
        assert!(table(&[0.0, 1.0, 1.0, 2.0]).is_some());
        for times in [&[][..], &[1.0, 0.0], &[0.0, 1.0, 1.0, 1.0], &[f64::NAN]] {
            assert_eq!(table(times), None);
        }
    }
}
