//! Metrics: a computed motion compared with the exact one.

pub mod budget;
pub mod convergence;
pub mod friction;
pub mod impact;
pub mod measured;
pub mod norm;
pub mod residual;
pub mod structure;

use crate::lane::Lane;

/// Relative slack in comparing times and counting steps: 8 pi/(pi/10) is 80 steps, 70 (pi/10) is 7 pi.
pub const SLACK: f64 = 1e-12;

/// Share of a duration by which it may differ from a multiple of the step: both may be rounded decimals.
const ROUNDED: f64 = 1e-6;

/// The number of steps N that fit in `duration`; 1.2/0.4 is 3.
pub fn steps(duration: f64, step: f64) -> u64 {
    // A quotient above the range of u64 saturates. The rules of time refuse it.
    (duration / step * (1.0 + SLACK)) as u64
}

/// The time of the last of so many steps, if `duration` is no multiple of `step`.
pub fn last_time(duration: f64, step: f64, last: u64) -> Option<f64> {
    let end = last as f64 * step;
    (duration - end > ROUNDED * duration).then_some(end)
}

/// Whether time `t` has reached `mark`, within the slack.
pub fn reached(t: f64, mark: f64) -> bool {
    t * (1.0 + SLACK) >= mark
}

/// A metric of all lanes; NaN if it is undefined.
#[inline(always)]
pub fn or_undefined<const L: usize>(metric: Option<Lane<L>>) -> Lane<L> {
    metric.unwrap_or(Lane::splat(f64::NAN))
}

/// The metrics of one case; `None` if one is undefined or not finite.
pub fn cells<const N: usize>(metrics: [Lane<1>; N]) -> [Option<f64>; N] {
    metrics.map(|Lane([x])| Some(x).filter(|x| x.is_finite()))
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// Asserts that the same cells are empty and that the others agree within round-off of a short sum.
    pub(crate) fn assert_metrics(metrics: &[Option<f64>], expected: &[Option<f64>]) {
        assert_eq!(metrics.len(), expected.len());
        for (i, (metric, expected)) in metrics.iter().zip(expected).enumerate() {
            match (metric, expected) {
                (Some(a), Some(b)) => assert!((a - b).abs() < 1e-14, "metric {i}: {a}, not {b}"),
                (None, _) | (_, None) => assert_eq!(metric, expected, "metric {i}"),
            }
        }
    }

    #[test]
    fn integer_quotients_lose_no_step() {
        for (duration, step, count) in [
            (1.2, 0.4, 3),
            (8.0 * PI, PI / 10.0, 80),
            (1.0, 0.3, 3),
            (0.7, 0.1, 7),
            (1.0, 1.0, 1),
            (1.0 - 1e-9, 1.0, 0),
        ] {
            assert_eq!(steps(duration, step), count, "{duration}/{step}");
        }
        // Above the range of u64 it saturates.
        assert_eq!(steps(1e300, 1e-300), u64::MAX);
    }

    #[test]
    fn times_are_reached_within_the_slack() {
        assert!(reached(70.0 * (PI / 10.0), 7.0 * PI));
        assert!(reached(1.0 - 5e-13, 1.0));
        assert!(!reached(1.0 - 2e-12, 1.0));
    }
}
