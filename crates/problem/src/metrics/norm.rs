//! Norms of an error over a run: one definition for each problem, for its metrics and for its error budget.
//!
//! | Problem | Mean square of the error | Reason |
//! | --- | --- | --- |
//! | friction oscillator | over the samples at the steps 0..=N, all with the weight 1/(N + 1): [`rms_over_samples`], [`rms_over_steps`] | X is continuous, so that a sample has one exact value; `[F]` compares the responses step by step |
//! | bar impact | over the duration, by trapezoids: [`mean_over_time`] | the exact rdot jumps, and a sample at a jump has two exact values, one for the step before it and one for the step after it |
//!
//! `rdot_oscillation` of the bar impact is a mean over samples too: it is taken between the jumps.

use crate::lane::Lane;

/// Root of a mean over `count` samples, from the sum of the squares.
#[inline(always)]
pub fn rms_over_samples<const L: usize>(squares: Lane<L>, count: usize) -> Lane<L> {
    squares.map(|squares| (squares / count as f64).sqrt())
}

/// The same with a reciprocal of the number of steps, which differs in the last bit: `rms_error` of recorded tables has this rounding.
#[inline(always)]
pub fn rms_over_steps<const L: usize>(squares: Lane<L>, count: usize) -> Lane<L> {
    (squares * (1.0 / count as f64)).map(f64::sqrt)
}

/// Mean over time of `value(i, e)`, where e is the exact value at step i, by trapezoids over the steps 0..=N.
///
/// `exact` has the value at each step, at a jump its right-hand limit. `jumps` has the steps with a jump and the left-hand limit
/// there; the steps increase. A trapezoid has the limits of its own side. Jumps within a step have no effect. `weight` is the
/// time step over the duration.
#[inline(always)]
pub fn mean_over_time<const L: usize>(
    exact: &[f64],
    jumps: impl Iterator<Item = (usize, f64)> + Clone,
    weight: f64,
    value: impl Fn(usize, f64) -> Lane<L>,
) -> Lane<L> {
    let last = exact.len() - 1;
    let mut sum = value(0, exact[0]) * 0.5;
    let mut i = 1;
    // The last step has no right-hand side; both sides of a jump count half.
    let inner = jumps.clone().filter(|jump| jump.0 > 0 && jump.0 < last);
    let last_jump = { jumps }.find(|jump| jump.0 == last);
    let end = (last, last_jump.map_or(exact[last], |jump| jump.1));
    for (jump, before) in inner.chain([end]) {
        for (i, e) in (i..jump).zip(&exact[i..jump]) {
            sum = sum + value(i, *e);
        }
        if jump < last {
            sum = sum + (value(jump, before) + value(jump, exact[jump])) * 0.5;
        } else {
            sum = sum + value(jump, before) * 0.5;
        }
        i = jump + 1;
    }
    sum * weight
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mean_over_time_has_both_limits_at_a_jump() {
        // 0 until t = 1, then 1 until t = 3: the mean is 2/3 with both limits, 5/6 with the right-hand ones alone.
        let exact = [0.0, 1.0, 1.0, 1.0];
        let mean = |jumps: &[(usize, f64)]| {
            mean_over_time(&exact, jumps.iter().copied(), 1.0 / 3.0, |_, e| Lane([e])).0[0]
        };
        assert!((mean(&[(1, 0.0)]) - 2.0 / 3.0).abs() < 1e-16);
        assert!((mean(&[]) - 5.0 / 6.0).abs() < 1e-15);
        // At the last step only the left-hand limit counts, at the first only the right-hand one.
        assert!((mean(&[(0, 7.0), (1, 0.0), (3, 0.0)]) - 0.5).abs() < 1e-16);
    }

    #[test]
    fn a_mean_over_samples_has_equal_weights() {
        let Lane([rms]) = rms_over_samples(Lane([1.0 + 4.0 + 4.0 + 16.0]), 4);
        assert!((rms - 2.5).abs() < 1e-15);
        let Lane([rms]) = rms_over_steps(Lane([25.0]), 4);
        assert!((rms - 2.5).abs() < 1e-15);
    }
}
