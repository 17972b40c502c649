//! Metrics of the bar impact, for several cases with the same exact solution and steps.

mod contact;
mod energy;
mod reference;
mod sampled;
mod track;

pub use energy::{Energy, damping_work, energy_of_books, step_work};
pub use reference::{OfExact, reference};
pub use sampled::Sampled;
pub use track::Track;

use super::or_undefined;
use crate::lane::{Lane, smallest};
use contact::{durations, impulse, oscillation, separations};

/// A computed motion, its energies and the exact motion, and what several metrics need of them.
pub struct Compared<'a, const L: usize> {
    /// The steps of the case; next to longer runs a lane has more.
    pub r: &'a [Lane<L>],
    /// See `r`.
    pub rdot: &'a [Lane<L>],
    /// See `r`.
    pub force: &'a [Lane<L>],
    /// r, of a rigid contact below 0 while it has a force.
    pub touching: &'a [Lane<L>],
    /// The exact motion.
    pub exact: &'a Sampled,
    /// Energy at t = 0.
    pub start: Lane<L>,
    /// Energy at the last step, less that at t = 0.
    pub end: Lane<L>,
    /// The same at the step where it is largest.
    pub drift: Lane<L>,
    /// Relative velocity of the mass centres at the end, over c.
    pub restitution: Lane<L>,
    /// Duration of the contact between the zeros of r, and in whole steps.
    pub durations: [Lane<L>; 2],
    deepest: Lane<L>,
}

impl<'a, const L: usize> Compared<'a, L> {
    /// `restitution` is the relative velocity of the mass centres at the end over c.
    #[inline(always)]
    pub fn new(
        c: &'a Track<L>,
        energy: &Energy<L>,
        restitution: Lane<L>,
        exact: &'a Sampled,
    ) -> Self {
        let steps = ..exact.count();
        let (r, rdot) = (&c.displacement[steps], &c.velocity[steps]);
        let force = &c.force[steps];
        let start = energy.start;
        let (lost, gained) = (energy.smallest - start, energy.largest - start);
        let drift = lost.zip(
            gained,
            |lost, gained| if -lost > gained { lost } else { gained },
        );
        let end = energy.last - start;
        // The sum to the last step is not finite if an energy overflowed, also where the extremes ignored NaN.
        let drift = drift.zip(
            end,
            |drift, end| if end.is_finite() { drift } else { f64::NAN },
        );
        // A rigid contact is closed while it has a force.
        let touching = if c.touching.is_empty() {
            r
        } else {
            &c.touching[steps]
        };
        Compared {
            r,
            rdot,
            force,
            touching,
            exact,
            start,
            end,
            drift,
            restitution,
            durations: durations(touching, exact.step),
            deepest: smallest(touching),
        }
    }

    /// The metric, undefined without contact. A touch at the last step would be a contact by round-off only.
    #[inline(always)]
    pub fn in_contact(&self, metric: Lane<L>) -> Lane<L> {
        self.deepest.zip(metric, |r, metric| {
            if r < 0.0 && self.exact.touches {
                metric
            } else {
                f64::NAN
            }
        })
    }

    /// Openings that close again.
    #[inline(always)]
    pub fn separations(&self) -> Lane<L> {
        separations(&self.touching[..self.exact.openings])
    }

    /// max(-r).
    #[inline(always)]
    pub fn overlap(&self) -> Lane<L> {
        smallest(self.r).map(|r| if r < 0.0 { -r } else { 0.0 })
    }

    /// The root mean square of c - e of rdot in the exact contact.
    #[inline(always)]
    pub fn oscillation(&self) -> Lane<L> {
        or_undefined(oscillation(self.rdot, self.exact))
    }

    /// The impulse over the exact one, minus 1.
    #[inline(always)]
    pub fn impulse_error(&self) -> Lane<L> {
        let impulse = impulse(self.force, self.exact.step);
        or_undefined(self.exact.impulse.map(|e| impulse.map(|i| i / e - 1.0)))
    }

    /// An energy over that at t = 0.
    #[inline(always)]
    pub fn of_start(&self, energy: Lane<L>) -> Lane<L> {
        energy.zip(self.start, |energy, start| energy / start)
    }

    /// Norm of c - e of a channel, see [`Sampled::rms`].
    #[inline(always)]
    pub fn rms(&self, component: usize, c: &[Lane<L>]) -> Lane<L> {
        self.exact.rms(
            component,
            #[inline(always)]
            |i, e| c[i] - Lane::splat(e),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::wave::{Bars, Wave};

    fn wave(gap: f64, end: f64) -> Wave {
        Bars {
            impedance_ratio: 1.0,
            time_ratio: 1.0,
            gap,
        }
        .solve(end)
    }

    #[test]
    fn contact_lasts_from_zero_to_zero_of_r() {
        // Steps of 1/4, of binary fractions only: no sum rounds.
        let (zero, large) = (-0.0, 1e308);
        for (r, linear, in_steps) in [
            // Zero at both steps; zero for longer before and after; from t = 0 on.
            (&[0.5, 0.0, -0.5, 0.0, 0.5][..], 0.5, 0.5),
            (&[0.5, 0.0, 0.0, -0.5, 0.0, 0.0, 0.5], 0.5, 0.5),
            (&[0.0, -0.5, 0.0, 0.0, 0.5], 0.5, 0.5),
            (&[zero, -0.5, zero], 0.5, 0.5),
            // Half a step before 1/2 and a quarter of one after it.
            (&[0.5, 0.125, -0.125, 0.375], 0.1875, 0.5),
            // Touched without overlap, before and after.
            (&[0.5, 0.0, 0.25, -0.25, 0.25, 0.0, 0.5], 0.25, 0.5),
            // Opens in between; ends at the last step.
            (&[0.0, -0.5, 0.5, 0.5, -0.25, 0.75], 1.0625, 1.25),
            // A difference above the range of double precision.
            (&[large, -large, large], 0.25, 0.5),
        ] {
            let lanes: Vec<_> = r.iter().map(|r| Lane([*r])).collect();
            assert_eq!(
                durations(&lanes, 0.25),
                [Lane([linear]), Lane([in_steps])],
                "{r:?}"
            );
        }
        for r in [&[0.5, 0.0, 0.5][..], &[0.5, -0.5, -0.25], &[0.0]] {
            let lanes: Vec<_> = r.iter().map(|r| Lane([*r])).collect();
            assert!(durations(&lanes, 0.25).iter().all(|d| d.0[0].is_nan()));
        }
    }

    #[test]
    fn separations_must_close_again_in_time() {
        let count = |touch: f64, r: &[f64]| {
            let last = r.len() as u64 - 1;
            let sampled = Sampled::new(&wave(2.0 * touch, 2.0), 0.25, last, 2.0);
            let r: Vec<_> = r.iter().map(|r| Lane([*r])).collect();
            separations(&r[..sampled.openings]).0[0]
        };
        for (touch, r, expected) in [
            (0.0, &[0.0, 0.1, -0.1][..], 0.0),
            (0.0, &[-0.1, 0.1, 0.1, 0.1, -0.1], 0.0),
            (0.1, &[-0.1, 0.1, 0.1, 0.1, -0.1], 1.0),
            (0.0, &[-0.1, 0.0, -0.1, 0.0], 1.0),
            (1.0, &[-0.1, 0.1, -0.1, 0.1, -0.1, 0.1, -0.1], 3.0),
            (1.0, &[-0.1, -0.1, 0.1, 0.1, -0.1, -0.1, -0.1], 1.0),
            (1.0, &[0.3, 0.2, 0.1, 0.2, 0.3], 0.0),
        ] {
            assert_eq!(count(touch, r), expected, "{touch} {r:?}");
        }
    }
}
