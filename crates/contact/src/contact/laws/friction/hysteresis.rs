//! Friction whose S is its own state and rises with r towards its limit: what Bouc-Wen's and Dahl's models share.

use crate::contact::prelude::*;

/// The offer of a law with a stiffness at S = 0 and an exponent, of these meanings in the oscillator and in structures, with its numbers there.
pub(super) const fn offer(
    name: &'static str,
    form: fn(&GivenNumbers) -> Result<Form, LawFault>,
    [by_itself, in_structure]: [&'static str; 2],
    in_structures: &'static [&'static Number],
) -> Offer {
    Offer::new(name, form)
        .in_oscillator(by_itself, of_oscillator![ALPHA, EXPONENT])
        .in_structures(in_structure, in_structures)
}

/// Such a law over a step.
#[derive(Debug, Clone, Copy)]
pub struct Hysteresis<const L: usize> {
    limit: Lane<L>,
    stiffness: Lane<L>,
    pub(super) exponent: Lane<L>,
    /// Flexibilities for S(i) and S(i+1).
    h: [Lane<L>; 2],
    /// Whether there is a closed form in some lanes, and in all.
    pub(super) closed: [bool; 2],
}

/// A step in units of the limit. S rises with r, so r(i+1) - r(i) has the sign of the change under S(i+1) = S(i).
#[derive(Clone, Copy)]
pub(super) struct Motion<const L: usize> {
    limit: Lane<L>,
    before: Lane<L>,
    free: Lane<L>,
    /// S(i) over the limit, > 0 in the direction of the motion.
    pub(super) along: Lane<L>,
    /// The motion under S(i+1) = S(i), over the width.
    pub(super) w: Lane<L>,
    /// Reduction of it by S(i+1) of the limit.
    pub(super) c: Lane<L>,
}

impl<const L: usize> Hysteresis<L> {
    /// Of laws with this compliance, limit and exponent; a closed form has the exponents for which this is true.
    #[inline(always)]
    pub(super) fn new<W>(
        laws: &[W; L],
        numbers: impl Fn(&W) -> [f64; 3],
        closed: impl Fn(f64) -> bool,
        on: &StepFlexibility<L>,
    ) -> Hysteresis<L> {
        let exponent = lanes(laws, |law| numbers(law)[2]);
        Hysteresis {
            limit: lanes(laws, |law| numbers(law)[1]),
            stiffness: lanes(laws, |law| 1.0 / numbers(law)[0]),
            exponent,
            h: [on.start.h, on.end.h],
            closed: [
                exponent.0.iter().any(|n| closed(*n)),
                exponent.0.iter().all(|n| closed(*n)),
            ],
        }
    }

    /// The motion of a step.
    #[inline(always)]
    pub(super) fn motion(&self, trial: &Trial<L>) -> Motion<L> {
        let (limit, [start, end]) = (self.limit, self.h);
        let before = trial.force.cut(limit);
        let free = trial.change - trial.force * start - before * end;
        let inverse = limit.map(|limit| if limit > 0.0 { 1.0 / limit } else { 0.0 });
        Motion {
            limit,
            before,
            free,
            along: (before * inverse).zip(free, |z, free| if free < 0.0 { -z } else { z }),
            w: free.map(f64::abs) * self.stiffness * inverse,
            c: self.stiffness * end,
        }
    }
}

impl<const L: usize> Motion<L> {
    /// S(i+1), which has grown by this part of the limit.
    #[inline(always)]
    pub(super) fn end(&self, grown: Lane<L>) -> Lane<L> {
        (self.before + (self.limit * grown).zip(self.free, f64::copysign)).cut(self.limit)
    }
}
