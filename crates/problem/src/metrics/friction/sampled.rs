//! The exact solution at the steps of a run.

use crate::exact::coulomb::Coulomb;
use crate::exact::first_step;
use crate::metrics::reached;
use std::f64::consts::PI;
use std::ops::Range;

/// The exact solution at the steps of a run, and the numbers that metrics need of it. It is the same for all cases with equal
/// x0, step and duration.
#[derive(Debug, Clone)]
pub struct Sampled {
    pub(super) exact: Coulomb,
    /// |x0|.
    pub(super) scale: f64,
    /// X/|x0| at steps 0..=N.
    pub at: Vec<f64>,
    /// Sum of their squares.
    pub(super) squares: f64,
    /// The steps with (k - 1/2) pi <= T <= (k + 1/2) pi for each k = 1..=m. `None` if one of these windows has no step, or if
    /// the run ends before the last one: its extreme value would not be the peak.
    pub(super) peaks: Option<Vec<Range<usize>>>,
    /// Steps from T = (m + 1) pi on.
    pub(super) late: Range<usize>,
    /// Whether the run reaches the time of rest.
    pub(super) rests: bool,
}

impl Sampled {
    /// Release from `x0`; steps i `step`, i = 0..=`last`.
    pub fn new(x0: f64, step: f64, last: u64, duration: f64) -> Sampled {
        let exact = Coulomb::new(x0);
        let (scale, count) = (x0.abs(), last as usize + 1);
        let mut at = exact.displacements(step, count);
        for x in &mut at {
            *x /= scale;
        }
        let time = |i: usize| i as f64 * step;
        let from = |mark: f64| first_step(count, mark / step, |i| reached(time(i), mark));
        // A step at a common end belongs to both windows.
        let past = |mark: f64| first_step(count, mark / step, |i| !reached(mark, time(i)));
        let m = exact.half_cycles();
        let window = |k: u64| from((k as f64 - 0.5) * PI)..past((k as f64 + 0.5) * PI);
        let not_empty = |range: Range<usize>| (!range.is_empty()).then_some(range);
        Sampled {
            exact,
            scale,
            squares: at.iter().map(|e| e * e).sum(),
            at,
            peaks: reached(duration, (m + 0.5) * PI)
                .then(|| (1..=m as u64).map(|k| not_empty(window(k))).collect())
                .flatten(),
            late: from((m + 1.0) * PI)..count,
            rests: reached(duration, exact.rest_time()),
        }
    }

    /// Number of steps, N + 1.
    pub fn count(&self) -> usize {
        self.at.len()
    }
}
