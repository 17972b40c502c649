//! Metrics of a computed motion c against a measured one m.
//!
//! Both stand at the measured times, at which the computed motion is straight between its steps. A loop is a displacement r and a force
//! S.

mod cycles;
mod loops;
mod sprague_geers;

pub use cycles::{cycles, energy_per_cycle, energy_per_cycle_error, work_of_cycles};
pub use loops::loop_distance;
pub use sprague_geers::{SpragueGeers, sprague_geers};

use super::SLACK;

/// The values of a motion at `times`, which rise, straight between its steps 0..=N of `dt`; `None` if the first or the last one is
/// outside of them, beyond round-off.
pub fn at_times(c: &[f64], dt: f64, times: &[f64]) -> Option<Vec<f64>> {
    let end = c.len().checked_sub(1)? as f64;
    // A time of a file is a decimal number, and dt may be a quotient: both are rounded.
    let is_near = |t: &f64| {
        let steps = t / dt;
        let nearest = steps.clamp(0.0, end);
        (steps - nearest).abs() <= 1e-9 + SLACK * nearest
    };
    let mut ends = [times.first(), times.last()].into_iter().flatten();
    if !ends.all(is_near) {
        return None;
    }
    let value = |t: &f64| between(c, (t / dt).clamp(0.0, end));
    Some(times.iter().map(value).collect())
}

/// Measured values at the times `steps`, which rise, straight between the measured points; NaN before the first and after the last one.
pub fn at_steps(times: &[f64], m: &[f64], steps: &[f64]) -> Vec<f64> {
    let mut before = 0;
    let value = |t: &f64| {
        while before + 2 < times.len() && times[before + 1] <= *t {
            before += 1;
        }
        match (times.get(before), times.get(before + 1)) {
            (Some(from), Some(to)) if from <= t && t <= to => {
                let share = (t - from) / (to - from);
                m[before] + share * (m[before + 1] - m[before])
            }
            _ => f64::NAN,
        }
    };
    steps.iter().map(value).collect()
}

/// The value at a place of a list, with a fraction, straight between its values.
pub(super) fn between(x: &[f64], at: f64) -> f64 {
    let before = (at as usize).min(x.len().saturating_sub(2));
    let after = (before + 1).min(x.len() - 1);
    x[before] + (at - before as f64) * (x[after] - x[before])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_motion_is_straight_between_its_steps() {
        // c = 1 + 2 t at steps of 0.1: straight between them, so that every time has this value.
        let c: Vec<f64> = (0..=10).map(|i| 1.0 + 0.2 * f64::from(i)).collect();
        let times = [0.0, 0.05, 0.3, 0.31, 0.999, 1.0];
        let values = at_times(&c, 0.1, &times).unwrap();
        for (t, value) in times.iter().zip(&values) {
            assert!((value - (1.0 + 2.0 * t)).abs() < 1e-15, "{t}: {value}");
        }
        // 3 * 0.1 is above 0.3, and 10 steps of 0.1 end at 1: times beyond the ends by round-off are those of the ends.
        assert_eq!(
            at_times(&c, 0.1, &[-1e-12, 1.0 + 1e-12]),
            Some(vec![c[0], c[10]])
        );
        for beyond in [-1e-6, 1.0 + 1e-6, f64::NAN] {
            assert_eq!(at_times(&c, 0.1, &[0.0, beyond]), None, "{beyond}");
        }
        assert_eq!(at_times(&[], 0.1, &[0.0]), None);
        assert_eq!(at_times(&[7.0], 0.1, &[0.0]), Some(vec![7.0]));
    }

    #[test]
    fn measured_values_end_with_the_file() {
        // Uneven times; the values are those of 3 - t, straight everywhere.
        let times = [-0.5, 0.25, 0.3, 2.0];
        let m = times.map(|t| 3.0 - t);
        let steps = [-1.0, -0.5, 0.0, 0.25, 0.26, 1.0, 2.0, 2.1, 3.0];
        let values = at_steps(&times, &m, &steps);
        for (t, value) in steps.iter().zip(&values) {
            match (-0.5..=2.0).contains(t) {
                true => assert!((value - (3.0 - t)).abs() < 1e-15, "{t}: {value}"),
                false => assert!(value.is_nan(), "{t}: {value}"),
            }
        }
        assert!(at_steps(&[0.0], &[1.0], &[0.0])[0].is_nan());
    }
}
