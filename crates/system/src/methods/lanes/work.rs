//! The work of a contact over a step, from its states at both ends.

use crate::lane::Lane;

/// How the work of a step follows from its ends: a force times a displacement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ContactWork<const L: usize> {
    /// The mean of both forces, on the displacement: for methods whose forces are functions of time. It is of second order, and
    /// exact for a linear spring. The force between the sub-steps of a method enters the motion only.
    Trapezoids,
    /// The force at the end, on the mean velocity during this time: S(i+1) dt is the impulse of a step.
    Impulses(Lane<L>),
}

impl<const L: usize> ContactWork<L> {
    /// That of a method with this time step. `at_end`: whether S(i+1) acts over the whole step.
    pub fn new(at_end: bool, dt: Lane<L>) -> Self {
        if at_end {
            ContactWork::Impulses(dt)
        } else {
            ContactWork::Trapezoids
        }
    }

    /// The force, from S(i) and S(i+1).
    #[inline(always)]
    pub fn force(&self, [before, after]: [Lane<L>; 2]) -> Lane<L> {
        match self {
            ContactWork::Trapezoids => (before + after) * 0.5,
            ContactWork::Impulses(_) => after,
        }
    }

    /// The displacement, from r and rdot at both ends.
    #[inline(always)]
    pub fn displacement(&self, r: [Lane<L>; 2], rdot: [Lane<L>; 2]) -> Lane<L> {
        match self {
            ContactWork::Trapezoids => r[1] - r[0],
            ContactWork::Impulses(dt) => (rdot[0] + rdot[1]) * (*dt * 0.5),
        }
    }
}
