//! A spring whose force stays between two parallel lines.

use crate::contact::prelude::*;

/// A spring k1 whose force stays between the lines k2 r + low and k2 r + high, k2 <= k1.
///
/// It is a spring k2 beside an elastic part k1 - k2 that yields at low and high. Over a step with r' = y - h S',
///
/// ```text
/// S' = max(min(S + k1 (r' - r), k2 r' + high), k2 r' + low)
/// ```
///
/// S' less each of the three lines rises with S' if 1 + k2 h > 0: the root is the same maximum and minimum of the roots
/// of the lines, (S + k1 (y - r))/(1 + k1 h) and (k2 y + high)/(1 + k2 h).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Band {
    /// k1 > 0 and k2 <= k1.
    pub stiffness: [f64; 2],
    /// low <= 0 and high >= 0, of r = 0.
    pub bounds: [f64; 2],
}

/// The spring over a step.
#[derive(Debug, Clone, Copy)]
pub(in crate::contact) struct Step<const L: usize> {
    stiffness: [Lane<L>; 2],
    bounds: [Lane<L>; 2],
    /// 1/(1 + k h) with the flexibility for S(i+1), for k1 and k2.
    share: [Lane<L>; 2],
    /// Flexibility for S(i).
    pub(in crate::contact) start: Lane<L>,
}

impl Band {
    /// Energy that both springs store. The whole is 0 where S = 0 at r = 0.
    pub(in crate::contact) fn stored_energy(&self, r: f64, s: f64) -> f64 {
        let [k1, k2] = self.stiffness;
        let elastic_force = s - k2 * r;
        // Without an elastic part the force is k2 r.
        let elastic = if k1 > k2 {
            elastic_force * elastic_force / (k1 - k2)
        } else {
            0.0
        };
        0.5 * (k2 * r * r + elastic)
    }

    #[inline(always)]
    pub(in crate::contact) fn step<W, const L: usize>(
        laws: &[W; L],
        band: impl Fn(&W) -> Band,
        on: &StepFlexibility<L>,
    ) -> Step<L> {
        let stiffness = [0, 1].map(|which| lanes(laws, |law| band(law).stiffness[which]));
        Step {
            stiffness,
            bounds: [0, 1].map(|which| lanes(laws, |law| band(law).bounds[which])),
            share: stiffness.map(|k| (Lane::splat(1.0) + k * on.end.h).map(|x| 1.0 / x)),
            start: on.start.h,
        }
    }
}

impl<const L: usize> Step<L> {
    /// S(i+1), from r and S, for the change of r without S(i+1).
    #[inline(always)]
    pub(in crate::contact) fn force(&self, r: Lane<L>, s: Lane<L>, change: Lane<L>) -> Lane<L> {
        let [k1, k2] = self.stiffness;
        let [low, high] = self.bounds;
        let line = k2 * (r + change);
        let elastic = (s + k1 * change) * self.share[0];
        elastic
            .smaller((line + high) * self.share[1])
            .larger((line + low) * self.share[1])
    }
}
