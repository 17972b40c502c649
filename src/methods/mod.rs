//! Methods of integration, one file each: how a structure moves over a step, and how the force at the end of a step enters.

pub mod average_acceleration;

use crate::lane::Lane;

/// The contact at the end of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactState<const L: usize> {
    /// Relative displacement r.
    pub displacement: Lane<L>,
    /// Relative velocity rdot.
    pub velocity: Lane<L>,
    /// Force S.
    pub force: Lane<L>,
}

impl<const L: usize> ContactState<L> {
    /// Whether the motion of each lane is finite. A motion that is not finite at a step is not finite at any later step.
    pub fn finite(&self) -> [bool; L] {
        let all = [self.displacement, self.velocity, self.force];
        std::array::from_fn(|l| all.iter().all(|x| x.0[l].is_finite()))
    }
}

/// The lanes that end at a step.
#[derive(Debug, Clone, Copy)]
pub struct EndingLanes<const L: usize>([bool; L]);

impl<const L: usize> EndingLanes<L> {
    #[inline(always)]
    fn new(last: &[u64; L], step: u64) -> Self {
        let mut ending = [false; L];
        for (ending, last) in ending.iter_mut().zip(last) {
            *ending = *last == step;
        }
        EndingLanes(ending)
    }

    /// `now` in the lanes that end, `before` in the others.
    #[inline(always)]
    pub fn select(&self, now: Lane<L>, mut before: Lane<L>) -> Lane<L> {
        for ((before, now), ending) in before.0.iter_mut().zip(now.0).zip(self.0) {
            *before = if ending { now } else { *before };
        }
        before
    }
}
