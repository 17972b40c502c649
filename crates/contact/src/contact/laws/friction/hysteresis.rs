//! Friction whose S is its own state: elastic with 1/compliance at S = 0, and it rises with r towards its limit.

use crate::contact::prelude::*;

/// Such a law.
pub(in crate::contact) trait Hysteresis: Copy {
    /// dr/dS at S = 0.
    fn compliance(&self) -> f64;
    /// The largest S.
    fn limit(&self) -> f64;
}

impl<W: Hysteresis> StoredEnergy for W {
    fn stored_energy(&self, _: f64, s: f64) -> f64 {
        0.5 * self.compliance() * s * s
    }
}

/// dS/dr at S = 0; without a limit there is no S.
pub(in crate::contact) fn initial_stiffness(law: &impl Hysteresis) -> f64 {
    if law.limit() > 0.0 {
        1.0 / law.compliance()
    } else {
        0.0
    }
}

/// Four widths.
pub(in crate::contact) fn reach(law: &impl Hysteresis) -> f64 {
    4.0 * law.compliance() * law.limit()
}

/// A step in units of the limit. S rises with r, so r(i+1) - r(i) has the sign of the change under S(i+1) = S(i).
#[derive(Clone, Copy)]
pub(in crate::contact) struct Motion<const L: usize> {
    limit: Lane<L>,
    before: Lane<L>,
    free: Lane<L>,
    /// S(i) over the limit, > 0 in the direction of the motion.
    pub(in crate::contact) along: Lane<L>,
    /// The motion under S(i+1) = S(i), over the width.
    pub(in crate::contact) w: Lane<L>,
}

impl<const L: usize> Motion<L> {
    /// With the flexibilities for S(i) and S(i+1).
    #[inline(always)]
    pub(in crate::contact) fn new(
        trial: &Trial<L>,
        limit: Lane<L>,
        stiffness: Lane<L>,
        h: [Lane<L>; 2],
    ) -> Motion<L> {
        let before = trial.force.cut(limit);
        let free = trial.change - trial.force * h[0] - before * h[1];
        let inverse = limit.map(|limit| if limit > 0.0 { 1.0 / limit } else { 0.0 });
        Motion {
            limit,
            before,
            free,
            along: (before * inverse).zip(free, |z, free| if free < 0.0 { -z } else { z }),
            w: free.map(f64::abs) * stiffness * inverse,
        }
    }

    /// S(i+1), which has grown by this part of the limit.
    #[inline(always)]
    pub(in crate::contact) fn end(&self, grown: Lane<L>) -> Lane<L> {
        (self.before + (self.limit * grown).zip(self.free, f64::copysign)).cut(self.limit)
    }
}
