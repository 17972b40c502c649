//! The exact solution at the steps of a run, and what the metrics ask of it: the same for all cases with its gap, bars,
//! step and duration.

use crate::exact::State;
use crate::exact::first_step;
use crate::exact::wave::Wave;
use crate::lane::Lane;
use crate::metrics::reached;
use std::ops::Range;

/// Openings are counted and rdot is watched up to this share of the exact contact: near its end the returning front
/// parts the ends for good.
const WATCHED: f64 = 0.9;

/// From this share of the exact contact on rdot is watched.
const SETTLED: f64 = 0.3;

/// r and rdot are the two quantities that have norms.
const OF: [fn(State) -> f64; 2] = [|state| state.displacement, |state| state.velocity];

/// The exact solution at steps 0..=N.
#[derive(Debug, Clone)]
pub struct Sampled {
    /// The step dt.
    pub step: f64,
    /// Steps over which openings are counted, from 0.
    pub openings: usize,
    /// Steps over which the oscillation of rdot is taken.
    pub watched: Range<usize>,
    /// How long the exact contact lasts; infinite where that is more than matters here.
    pub lasts: f64,
    /// Whether the ends touch before the last step.
    pub touches: bool,
    /// Impulse up to the last step; `None` unless the run outlasts the exact contact.
    pub impulse: Option<f64>,
    duration: f64,
    /// r, rdot at every step, at a jump its right-hand limit.
    at: [Vec<f64>; 2],
    /// Steps at which the exact solution may jump, rising, with the left-hand limits there.
    jumps: Vec<(usize, [f64; 2])>,
}

impl Sampled {
    /// At steps i `step`, i = 0..=`last`.
    pub fn new(wave: &Wave, step: f64, last: u64, duration: f64) -> Sampled {
        let count = last as usize + 1;
        let mut at = [Vec::with_capacity(count), Vec::with_capacity(count)];
        let mut jumps = Vec::new();
        wave.walk((0..count).map(|i| i as f64 * step), |i, state, before| {
            for (at, of) in at.iter_mut().zip(OF) {
                at.push(of(state));
            }
            if let Some(before) = before {
                jumps.push((i, OF.map(|of| of(before))));
            }
        });
        let (touch, end) = (wave.first_touch(), last as f64 * step);
        // A contact that is not over by then leaves no step from its share of 0.3 on.
        let most = (duration - touch) / SETTLED + step;
        let lasts = wave.bars().contact_duration(most).unwrap_or(f64::INFINITY);
        let (settled, watched) = (touch + SETTLED * lasts, touch + WATCHED * lasts);
        // Times rise, so what has not been reached begins where the first is not.
        let time = |i: usize| i as f64 * step;
        let until = |mark: f64| first_step(count, mark / step, |i| !reached(mark, time(i)));
        let from = first_step(count, settled / step, |i| reached(time(i), settled));
        let [_, parted] = wave.durations();
        Sampled {
            step,
            openings: until(watched),
            watched: from..until(watched).max(from),
            lasts,
            touches: !reached(touch, end),
            impulse: parted
                .filter(|parted| !reached(*parted, duration))
                .map(|_| wave.impulse(end)),
            duration,
            at,
            jumps,
        }
    }

    /// Number of steps, N + 1.
    pub fn count(&self) -> usize {
        self.at[0].len()
    }

    /// The exact rdot at the watched steps.
    pub fn watched_velocity(&self) -> &[f64] {
        &self.at[1][self.watched.clone()]
    }

    /// Mean over the duration of `what(i, e)`, e the exact r (`of` = 0) or rdot (`of` = 1) at step i: trapezoids over
    /// the steps, each with the exact limits of its own side; jumps inside a step are not looked for.
    #[inline(always)]
    pub fn mean<const L: usize>(&self, of: usize, what: impl Fn(usize, f64) -> Lane<L>) -> Lane<L> {
        let exact = &self.at[of];
        let last = exact.len() - 1;
        let mut sum = what(0, exact[0]) * 0.5;
        let mut i = 1;
        // The last step has no right-hand side; both sides of a jump count half.
        let inner = self.jumps.iter().filter(|jump| jump.0 > 0 && jump.0 < last);
        let end = self.jumps.iter().find(|jump| jump.0 == last);
        let end = (last, end.map_or(exact[last], |jump| jump.1[of]));
        for (jump, before) in inner.map(|jump| (jump.0, jump.1[of])).chain([end]) {
            for (i, e) in (i..jump).zip(&exact[i..jump]) {
                sum = sum + what(i, *e);
            }
            if jump < last {
                sum = sum + (what(jump, before) + what(jump, exact[jump])) * 0.5;
            } else {
                sum = sum + what(jump, before) * 0.5;
            }
            i = jump + 1;
        }
        sum * (self.step / self.duration)
    }
}
