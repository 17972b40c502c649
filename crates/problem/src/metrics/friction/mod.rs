//! Metrics of the friction oscillator; `c` is the computed motion, `e` the exact one, sums are over the steps 0..=N.
//!
//! Displacements are divided by |x0|, so that no sum of squares overflows before the displacements do.

mod sampled;
mod work;

pub use sampled::Sampled;
pub use work::{work_by_energy, work_by_steps};

use super::norm::rms_over_steps;
use crate::lane::{Lane, largest, smallest};
use std::f64::consts::PI;

/// A computed motion and the exact one, and what several metrics need of them; sums are over the steps.
pub struct Compared<'a, const L: usize> {
    /// X at the steps of the run.
    pub c: &'a [Lane<L>],
    /// The exact motion.
    pub exact: &'a Sampled,
    /// 1/|x0|.
    pub over: f64,
    /// Sum of (c - e)^2.
    pub squares: Lane<L>,
    /// Largest |c - e|.
    pub furthest: Lane<L>,
    /// Magnitude and phase of Sprague and Geers.
    pub sprague_geers: [Lane<L>; 2],
}

impl<'a, const L: usize> Compared<'a, L> {
    /// Of `c` at the steps of the run.
    #[inline(always)]
    pub fn new(c: &'a [Lane<L>], exact: &'a Sampled) -> Self {
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
        let (cc, ee) = (magnitudes.map(f64::sqrt), exact.squares.sqrt());
        let magnitude = cc.map(|cc| cc / ee - 1.0);
        let phase = phase(squares, magnitudes, exact.squares);
        Compared {
            c,
            exact,
            over,
            squares,
            furthest,
            sprague_geers: [magnitude, phase],
        }
    }

    /// sqrt(mean (c - e)^2).
    #[inline(always)]
    pub fn rms(&self) -> Lane<L> {
        rms_over_steps(self.squares, self.c.len())
    }

    /// |c - e| at the last step; undefined before the exact motion rests.
    #[inline(always)]
    pub fn rest(&self) -> Option<Lane<L>> {
        let c = self.c.last().map(|c| *c * self.over);
        let e = self.exact.at.last().copied().unwrap_or(0.0);
        let error = c.unwrap_or(Lane::splat(0.0)) - Lane::splat(e);
        self.exact.rests.then_some(error.map(f64::abs))
    }

    /// The work of friction over the exact work, minus 1; undefined without a half-cycle, and before the exact motion rests.
    #[inline(always)]
    pub fn work_error(&self, work: Lane<L>) -> Option<Lane<L>> {
        let moves = self.exact.exact.half_cycles() >= 1.0 && self.exact.rests;
        let lost = self.exact.exact.work() * self.over;
        moves.then(|| work.map(|work| work / lost - 1.0))
    }
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
pub fn peak_error<const L: usize>(c: &[Lane<L>], exact: &Sampled) -> Option<Lane<L>> {
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
pub fn residual_motion<const L: usize>(c: &[Lane<L>], exact: &Sampled) -> Option<Lane<L>> {
    let late = c.get(exact.late.clone()).filter(|late| !late.is_empty())?;
    Some((largest(late) - smallest(late)) * 0.5)
}
