//! The exact solution at the steps of a run, and the numbers that metrics need of it. It is the same for all cases with equal
//! gap, bars, step and duration.

use crate::exact::State;
use crate::exact::first_step;
use crate::exact::wave::Wave;
use crate::lane::Lane;
use crate::metrics::norm::mean_over_time;
use crate::metrics::reached;
use std::ops::Range;

/// Openings are counted and the oscillation of rdot is computed up to this share of the exact contact: near its end the returning
/// front separates the ends.
const WATCHED: f64 = 0.9;

/// The oscillation of rdot is computed from this share of the exact contact on.
const SETTLED: f64 = 0.3;

/// The components with norms: r and rdot.
const COMPONENTS: [fn(State) -> f64; 2] = [|state| state.displacement, |state| state.velocity];

/// The exact solution at steps 0..=N.
#[derive(Debug, Clone)]
pub struct Sampled {
    /// The step dt.
    pub step: f64,
    /// Steps over which openings are counted, from 0.
    pub openings: usize,
    /// Steps over which the oscillation of rdot is computed.
    pub watched: Range<usize>,
    /// Duration of the exact contact; infinite if the contact ends after all steps that metrics need.
    pub lasts: f64,
    /// Whether the ends touch before the last step.
    pub touches: bool,
    /// Impulse up to the last step; `None` if the run ends before the exact contact.
    pub impulse: Option<f64>,
    duration: f64,
    /// r, rdot at every step, at a jump its right-hand limit.
    at: [Vec<f64>; 2],
    /// Steps at which the exact solution may jump, in increasing order, with the left-hand limits there.
    jumps: Vec<(usize, [f64; 2])>,
}

impl Sampled {
    /// At steps i `step`, i = 0..=`last`.
    pub fn new(wave: &Wave, step: f64, last: u64, duration: f64) -> Sampled {
        let count = last as usize + 1;
        let mut at = [Vec::with_capacity(count), Vec::with_capacity(count)];
        let mut jumps = Vec::new();
        wave.walk((0..count).map(|i| i as f64 * step), |i, state, before| {
            for (at, of) in at.iter_mut().zip(COMPONENTS) {
                at.push(of(state));
            }
            if let Some(before) = before {
                jumps.push((i, COMPONENTS.map(|of| of(before))));
            }
        });
        let (touch, end) = (wave.first_touch(), last as f64 * step);
        // A longer contact leaves no step from its share of 0.3 on.
        let most = (duration - touch) / SETTLED + step;
        let lasts = wave.bars().contact_duration(most).unwrap_or(f64::INFINITY);
        let (settled, watched) = (touch + SETTLED * lasts, touch + WATCHED * lasts);
        let time = |i: usize| i as f64 * step;
        let until = |mark: f64| first_step(count, mark / step, |i| !reached(mark, time(i)));
        let from = first_step(count, settled / step, |i| reached(time(i), settled));
        let [_, separation] = wave.durations();
        Sampled {
            step,
            openings: until(watched),
            watched: from..until(watched).max(from),
            lasts,
            touches: !reached(touch, end),
            impulse: separation
                .filter(|separation| !reached(*separation, duration))
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

    /// The exact rdot at the steps `watched`.
    pub fn watched_velocity(&self) -> &[f64] {
        &self.at[1][self.watched.clone()]
    }

    /// Mean over the duration of `value(i, e)`, where e is the exact r (`component` = 0) or rdot (`component` = 1) at step i, see
    /// [`mean_over_time`].
    #[inline(always)]
    pub fn mean<const L: usize>(
        &self,
        component: usize,
        value: impl Fn(usize, f64) -> Lane<L>,
    ) -> Lane<L> {
        let jumps = self.jumps.iter().map(|jump| (jump.0, jump.1[component]));
        let weight = self.step / self.duration;
        mean_over_time(&self.at[component], jumps, weight, value)
    }

    /// Root of the mean square of `error(i, e)` over the duration, arguments as in [`Sampled::mean`].
    #[inline(always)]
    pub fn rms<const L: usize>(
        &self,
        component: usize,
        error: impl Fn(usize, f64) -> Lane<L>,
    ) -> Lane<L> {
        let mean = self.mean(
            component,
            #[inline(always)]
            |i, e| {
                let error = error(i, e);
                error * error
            },
        );
        mean.map(f64::sqrt)
    }
}
