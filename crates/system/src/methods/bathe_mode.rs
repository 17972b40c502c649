//! A mode in the method of Bathe.

use super::lanes::ModeStart;
use crate::lane::Lane;

/// Coefficients and the state of one mode. The alignment puts it at the start of a cache line.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
pub struct ModeState<const L: usize> {
    /// K
    pub(super) stiffness: Lane<L>,
    /// G
    pub(super) compliance: Lane<L>,
    /// 1/(2 E), W2/E, phi2 dt^2/E
    pub(super) back: [Lane<L>; 3],
    /// w; between the sub-steps w1 - n/4.
    pub(super) w: Lane<L>,
    /// p; between the sub-steps t.
    pub(super) p: Lane<L>,
    /// Between the sub-steps e without S2.
    e: Lane<L>,
}

impl<const L: usize> ModeState<L> {
    #[inline(always)]
    pub(super) fn new(dt: Lane<L>, start: &ModeStart<L>) -> Self {
        let omega2 = Lane(start.mode.map(|m| m.omega2)) * dt * dt;
        let phi2 = Lane(start.mode.map(|m| m.phi2)) * dt * dt;
        let trapezoidal = omega2.map(|w2| 1.0 / (16.0 + w2));
        let backward = omega2.map(|w2| 1.0 / (9.0 + w2));
        let w = dt * start.velocity * 0.5;
        ModeState {
            stiffness: omega2 * trapezoidal * 4.0,
            compliance: phi2 * trapezoidal * 2.0,
            back: [backward * 0.5, omega2 * backward, phi2 * backward],
            w,
            p: start.displacement + w * 0.5,
            e: Lane::splat(0.0),
        }
    }

    /// The first sub-step under S0 + S1; adds e without S2 to its sum.
    // One loop over the lanes keeps the numbers between in registers.
    #[inline(always)]
    pub(super) fn trapezoidal(&mut self, force_sum: &Lane<L>, sum: &mut Lane<L>) {
        let [by_n, by_t, _] = &self.back;
        for l in 0..L {
            let n = self.stiffness.0[l] * self.p.0[l] + self.compliance.0[l] * force_sum.0[l];
            let w = self.w.0[l] - n;
            let t = self.p.0[l] + 1.5 * w;
            let e = by_n.0[l] * n + by_t.0[l] * t;
            self.p.0[l] = t;
            self.w.0[l] = w - 0.25 * n;
            self.e.0[l] = e;
            sum.0[l] += e;
        }
    }

    /// The second sub-step under S2; adds K p and w to their sums.
    #[inline(always)]
    pub(super) fn backward(&mut self, force: &Lane<L>, sums: &mut [Lane<L>; 2]) {
        let [predictors, increments] = sums;
        for l in 0..L {
            let e = self.e.0[l] + self.back[2].0[l] * force.0[l];
            let w = self.w.0[l] - 1.5 * e;
            let p = (self.p.0[l] - e) + 0.5 * w;
            self.w.0[l] = w;
            self.p.0[l] = p;
            predictors.0[l] += self.stiffness.0[l] * p;
            increments.0[l] += w;
        }
    }

    /// x
    #[inline(always)]
    pub(super) fn displacement(&self) -> Lane<L> {
        self.p - self.w * 0.5
    }
}
