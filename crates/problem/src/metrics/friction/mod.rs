//! Metrics of the friction oscillator; `c` is the computed motion, `e` the exact one, sums are over the steps 0..=N.
//!
//! Displacements are divided by |x0|, so that no sum of squares overflows before the displacements do.

mod sampled;
mod work;

pub use sampled::Sampled;
pub use work::{work_by_energy, work_by_steps};

use super::norm::rms_over_steps;
use super::or_undefined;
use crate::lane::{Lane, largest, smallest};
use std::f64::consts::PI;

/// Number of the metrics here.
pub const COUNT: usize = 9;

/// The metrics in the order of the problem's table, for each lane; not a finite number if undefined.
///
/// `c` has X at the steps of the run. `work` is the work of the friction force over |x0|, see [`work_by_energy`].
#[inline(always)]
pub fn evaluate<const L: usize>(c: &[Lane<L>], work: Lane<L>, exact: &Sampled) -> [Lane<L>; COUNT] {
    let zero = Lane::splat(0.0);
    let over = 1.0 / exact.scale;
    let (mut squares, mut magnitudes, mut furthest) = (zero, zero, zero);
    for (c, e) in c.iter().zip(&exact.at) {
        let c = *c * over;
        let error = c - Lane::splat(*e);
        squares = squares + error * error;
        magnitudes = magnitudes + c * c;
        furthest = furthest.larger(error.map(f64::abs));
    }
    let peak = peak_error(c, exact).map(|error| error * over);
    let residual = residual_motion(c, exact).map(|motion| motion * over);
    let end = c.last().map(|c| *c * over).unwrap_or(zero);
    let rest = (end - Lane::splat(exact.at.last().copied().unwrap_or(0.0))).map(f64::abs);
    let rms = rms_over_steps(squares, c.len());
    let (cc, ee) = (magnitudes.map(f64::sqrt), exact.squares.sqrt());
    let magnitude = cc.map(|cc| cc / ee - 1.0);
    let phase = phase(squares, magnitudes, exact.squares);
    let combined = (magnitude * magnitude + phase * phase).map(f64::sqrt);
    let moves = exact.exact.half_cycles() >= 1.0 && exact.rests;
    let lost = exact.exact.work() * over;
    [
        rms,
        furthest,
        or_undefined(peak),
        or_undefined(exact.rests.then_some(rest)),
        or_undefined(residual),
        or_undefined(moves.then(|| work.map(|work| work / lost - 1.0))),
        magnitude,
        phase,
        combined,
    ]
}

/// acos(sum c e/sqrt(sum c^2 sum e^2))/pi from the three sums of squares of c - e, c and e. The formula of the half angle keeps
/// its digits for nearly equal c and e.
#[inline(always)]
fn phase<const L: usize>(error: Lane<L>, c: Lane<L>, e: f64) -> Lane<L> {
    let root = e.sqrt();
    let half = error.zip(c, |error, c| {
        let (norm, difference) = (c.sqrt(), c - e);
        let of_norms = difference / (norm + root);
        (error - of_norms * of_norms) / (4.0 * norm * root)
    });
    // Round-off can take the square of a sine out of its range.
    half.map(|h| 2.0 / PI * libm::asin(if h < 0.0 { 0.0 } else { h.sqrt().min(1.0) }))
}

/// Largest error of the peaks k = 1..=m, each the extreme of s_k c over its window.
///
/// Undefined if there is no peak, if the window of a peak has no step, or if the run ends in a window.
#[inline(always)]
fn peak_error<const L: usize>(c: &[Lane<L>], exact: &Sampled) -> Option<Lane<L>> {
    let windows = exact.peaks.as_ref().filter(|peaks| !peaks.is_empty())?;
    let mut worst = Lane::splat(0.0);
    for (k, window) in windows.iter().enumerate() {
        let k = k as f64 + 1.0;
        // One loop for both signs: compilers make a slow one of two loops that differ only in the comparison.
        let side = exact.exact.side(k);
        let mut extreme = Lane::splat(f64::NEG_INFINITY);
        for c in &c[window.clone()] {
            extreme = extreme.larger(*c * side);
        }
        let error = extreme - Lane::splat(exact.exact.amplitude(k));
        worst = worst.larger(error.map(f64::abs));
    }
    Some(worst)
}

/// Half of the range of the motion from T = (m + 1) pi on; undefined if the run ends before.
#[inline(always)]
fn residual_motion<const L: usize>(c: &[Lane<L>], exact: &Sampled) -> Option<Lane<L>> {
    let late = c.get(exact.late.clone()).filter(|late| !late.is_empty())?;
    Some((largest(late) - smallest(late)) * 0.5)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::history::History;
    use crate::methods::ContactWork;
    use crate::metrics::cells;
    use crate::metrics::tests::assert_metrics;

    /// Rows at T = i pi/2 with these X and S.
    fn history(rows: &[(f64, f64)]) -> History {
        let rows = rows.iter().enumerate();
        rows.map(|(i, &(x, s))| (i as f64 * 0.5 * PI, [x, 0.0, s]))
            .collect()
    }

    fn metrics(x0: f64, c: &History) -> [Option<f64>; COUNT] {
        let (last, x) = (
            c.len() as u64 - 1,
            c.displacement().iter().map(|x| Lane([*x])),
        );
        let exact = Sampled::new(x0, 0.5 * PI, last, last as f64 * 0.5 * PI);
        let x: Vec<_> = x.collect();
        let rows: Vec<_> = (0..c.len())
            .map(|i| [c.displacement()[i], c.velocity()[i], c.force()[i]])
            .collect();
        cells(evaluate(
            &x,
            Lane([work_by_steps(&rows, x0, &ContactWork::Trapezoids)]),
            &exact,
        ))
    }

    #[test]
    fn a_short_history_by_hand() {
        // x0 = 3 rests at -1 from T = pi on (m = 1), having lost (9 - 1)/2 = 4.
        let c = history(&[
            (3.0, 0.0),
            (1.0, -1.0),
            (-1.5, -0.4),
            (-0.9, 1.0),
            (-1.1, 0.0),
            (-0.8, 0.2),
        ]);
        // e = 1 + 2 cos T to T = pi, then -1: c - e = 0, 0, -0.5, 0.1, -0.1, 0.2; work = 1 + 1.75 + 0.18 - 0.1 + 0.03.
        let (cc, ee, ce): (f64, f64, f64) = (14.91, 14.0, 14.3);
        let magnitude = (cc / ee).sqrt() - 1.0;
        let phase = (ce / (cc * ee).sqrt()).acos() / PI;
        let expected = [
            (0.31_f64 / 6.0).sqrt() / 3.0,
            0.5 / 3.0,
            // Within pi/2 <= T <= 3 pi/2 the lowest is -1.5.
            0.5 / 3.0,
            0.2 / 3.0,
            // From 2 pi on: -1.1 and -0.8.
            0.15 / 3.0,
            2.86 / 4.0 - 1.0,
            magnitude,
            phase,
            magnitude.hypot(phase),
        ];
        assert_metrics(&metrics(3.0, &c), &expected.map(Some));
        // The mirrored motion has the same metrics.
        let mirror = |h: &History| {
            let mut h = h.clone();
            for x in h.channels.iter_mut().flatten() {
                *x = -*x;
            }
            h
        };
        assert_metrics(&metrics(-3.0, &mirror(&c)), &expected.map(Some));
    }

    #[test]
    fn a_proportional_motion_has_no_phase_error() {
        // The square of the phase is round-off of either sign; its root is about 1e-8.
        for i in 1..200 {
            let factor = f64::from(i) * 0.013;
            let rows: Vec<_> = [3.0, 1.0, -1.0, -1.0, -1.0]
                .map(|e| (factor * e, 0.0))
                .to_vec();
            let metrics = metrics(3.0, &history(&rows));
            let phase = metrics[7].expect("a phase");
            assert!((0.0..4e-8).contains(&phase), "{factor}: {phase:e}");
            assert!((metrics[6].expect("a magnitude") - (factor - 1.0)).abs() < 1e-15 * 4.0);
        }
    }

    #[test]
    fn peaks_need_the_whole_last_window() {
        // x0 = 12 has m = 6 half-cycles: the last window ends at 6.5 pi, where the run may end within the slack.
        let peak = |duration: f64| {
            let step = 0.01 * PI;
            let last = crate::metrics::steps(duration, step);
            let exact = Sampled::new(12.0, step, last, duration);
            let x: Vec<_> = exact.at.iter().map(|x| Lane([12.0 * x])).collect();
            cells(evaluate(&x, Lane([0.0]), &exact))[2]
        };
        for (ends, defined) in [
            (5.49, false),
            (5.52, false),
            (6.0, false),
            (6.49, false),
            (6.5, true),
        ] {
            assert_eq!(peak(ends * PI).is_some(), defined, "{ends} pi");
        }
        assert!(peak(6.5 * PI * (1.0 - 5e-13)).is_some());
        assert!(peak(6.5 * PI * (1.0 - 2e-12)).is_none());
        // The exact motion has its peaks at steps.
        assert!(peak(6.5 * PI) < Some(1e-14));
    }

    #[test]
    fn undefined_metrics_are_empty() {
        let rows = [(3.0, 0.0), (1.0, -1.0), (-1.5, -0.4), (-0.9, 1.0)];
        let defined = |x0: f64, rows: &[(f64, f64)]| {
            let metrics = metrics(x0, &history(rows));
            [metrics[2], metrics[3], metrics[4], metrics[5]].map(|m| m.is_some())
        };
        // peak, rest, residual motion, work
        assert_eq!(defined(3.0, &rows), [true, true, false, true]);
        // At m pi, in the middle of the peak's window; before it, with a step in the window and without.
        assert_eq!(defined(3.0, &rows[..3]), [false, true, false, true]);
        assert_eq!(defined(3.0, &rows[..2]), [false, false, false, false]);
        assert_eq!(defined(3.0, &rows[..1]), [false, false, false, false]);
        // No motion: m = 0, no peak, no work.
        assert_eq!(defined(0.5, &rows), [false, true, true, false]);
    }
}
