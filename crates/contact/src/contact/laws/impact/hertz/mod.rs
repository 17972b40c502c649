//! Hertz's law without damping, and the root of a step that all laws of the power 1.5 with a damping factor share.

mod damped_hertz;
mod hertz_damp;
mod hunt_crossley;
pub(in crate::contact) mod jankowski;
pub(in crate::contact) mod newton;
mod ye;

pub use hertz_damp::HertzDamp;
pub use hunt_crossley::HuntCrossley;
pub use jankowski::Jankowski;
pub use ye::Ye;

use super::{Free, RigidImpact, loop_of, resisting};
use crate::contact::prelude::*;
use newton::{above_cube_root, above_fifth_root, newton};

/// F = k_h delta^1.5 (Goldsmith, Impact, 1960).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hertz {
    /// k_h, force over length^1.5.
    pub stiffness: f64,
}

/// The law over a step.
#[derive(Debug, Clone, Copy)]
pub struct Step<const L: usize> {
    pub(in crate::contact) start: Flexibility<L>,
    /// k_h.
    pub(in crate::contact) stiffness: Lane<L>,
    /// h k_h and h_rate k_h with the flexibility for S(i+1).
    pub(in crate::contact) by_overlap: Lane<L>,
    pub(in crate::contact) by_rate: Lane<L>,
}

impl<const L: usize> Step<L> {
    /// For the stiffnesses of L cases.
    #[inline(always)]
    pub(in crate::contact) fn new(stiffness: Lane<L>, on: &StepFlexibility<L>) -> Self {
        Step {
            start: on.start,
            stiffness,
            by_overlap: on.end.h * stiffness,
            by_rate: on.end.h_rate * stiffness,
        }
    }

    /// F = k_h delta'^1.5 (1 + a ddelta'), or 0 if that is negative; `a` >= 0.
    ///
    /// Let delta' = delta*/w^2, u = 1 + a ddelta*. The second equation of the step gives F = k_h delta*^1.5 u/(w^3 + C) with
    /// C = a h_rate k_h delta*^1.5; there is a force for u > 0. With this the first one is, E = h k_h delta*^0.5 u,
    ///
    /// ```text
    /// Q(w) = (w^2 - 1)(w^3 + C) - E w^2 = 0,   w >= 1
    /// ```
    #[inline(always)]
    pub(in crate::contact) fn push(&self, free: &Free<L>, a: Lane<L>) -> Lane<L> {
        let root = free.overlap.map(f64::sqrt);
        let power = free.overlap * root;
        let factor = (Lane::splat(1.0) + a * free.closing).larger(Lane::splat(0.0));
        let e = self.by_overlap * root * factor;
        let c = self.by_rate * power * a;
        let w = contraction(e, c);
        let cube = w * w * w + c;
        self.stiffness * power * factor * cube.map(|x| 1.0 / x)
    }
}

/// The root w >= 1 of Q for E, C >= 0.
///
/// Where Q = 0, E = w^3 - w + C (1 - 1/w^2), so that Q' = 3 w^4 - w^2 + 2 C/w > 0 and Q'' = 18 w^3 - 4 w + 2 C/w^2 > 0 there.
/// Q'' rises for w >= 1, so Q is convex above its root. Newton's iteration from an upper bound therefore falls to the root without
/// passing it. As w Q''/Q' <= 7 at the root, a step of 2^-28 w leaves an error below 2^-54 w.
#[inline(always)]
pub(in crate::contact) fn contraction<const L: usize>(e: Lane<L>, c: Lane<L>) -> Lane<L> {
    // In most steps no contact is closed: w = 1.
    if e.0.iter().all(|e| *e == 0.0) {
        return Lane::splat(1.0);
    }
    newton(bound(e, c), LAST, |w| step(w, e, c))
}

/// Relative size of the last step.
pub(in crate::contact) const LAST: f64 = 1.0 / (1 << 28) as f64;

/// Q/Q'.
#[inline(always)]
pub(in crate::contact) fn step<const L: usize>(mut w: Lane<L>, e: Lane<L>, c: Lane<L>) -> Lane<L> {
    for (l, w) in w.0.iter_mut().enumerate() {
        let (e, c) = (e.0[l], c.0[l]);
        let square = *w * *w;
        let value = (square - 1.0) * (square * *w + c) - e * square;
        let slope = *w * (*w * (5.0 * square - 3.0) - 2.0 * (e - c));
        *w = value / slope;
    }
    w
}

/// The smallest of three upper bounds of the root.
#[inline(always)]
pub(in crate::contact) fn bound<const L: usize>(mut e: Lane<L>, c: Lane<L>) -> Lane<L> {
    for (e, c) in e.0.iter_mut().zip(c.0) {
        // w^3 >= w^2: (t + 1 + C) t <= E (1 + t) for t = w^2 - 1. Either form of its root is without a difference.
        let p = 1.0 + (c - *e);
        let sum = p.abs() + (p * p + 4.0 * *e).sqrt();
        let t = if p > 0.0 { 2.0 * *e / sum } else { 0.5 * sum };
        let small = (1.0 + t).sqrt();
        // C = 0: w^3 - w = E has its root below b + 1/(3 b) for b^3 >= E; damping makes it smaller.
        let cube = above_cube_root(*e);
        let large = cube + 1.0 / (3.0 * cube);
        // w^5 = w^3 + (E - C) w^2 + C: no term on the right exceeds a third of w^5.
        let b = *e - c;
        let third = above_cube_root(if b > 0.0 { 3.0 * b } else { 0.0 });
        let fifth = above_fifth_root(3.0 * c);
        let larger = if fifth > third { fifth } else { third };
        let damped = if larger > 1.8 { larger } else { 1.8 };
        let bound = if large < small { large } else { small };
        *e = if damped < bound { damped } else { bound };
    }
    e
}

impl StoredEnergy for Hertz {
    fn deflection(&self, s: f64) -> Option<Deflection> {
        let overlap = libm::pow(-s / self.stiffness, 2.0 / 3.0);
        Some(Deflection {
            r: 0.0 - overlap,
            slope: 2.0 / 3.0 * overlap / -s,
        })
    }

    fn stored_energy(&self, r: f64, _: f64) -> f64 {
        stored_energy(self.stiffness, r)
    }
}

impl Described for Hertz {
    const KIND: ContactKind = ContactKind::Impact;
    const NAME: &'static str = "hertz";
    const OFFERS: &'static [Offer] = &[Offer::new(Self::NAME, |given| {
        let stiffness = given.need("k_h")?;
        Ok(Form::of(Hertz { stiffness }))
    })
    .between_bars(
        "spring with the force k_h delta^1.5 (Goldsmith 1960)",
        &[&bars::K_H],
    )
    .in_structures(
        "impact with the force k_h delta^1.5, delta = -r (Goldsmith 1960)",
        &[&structure::K_H],
    )];
    const CLOSED_FORM: ClosedForm<Self> = ClosedForm::Collision(|law, mass, speed| {
        RigidImpact::hertz(law.stiffness, 0.0, mass, speed)
    });
}

impl Properties for Hertz {
    fn family(&self) -> Family {
        Family::Hertz(self.stiffness)
    }
}

impl Law for Hertz {
    type Step<const L: usize> = Step<L>;

    #[inline(always)]
    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Step<L> {
        Step::new(lanes(laws, |law| law.stiffness), on)
    }

    /// Up to the overlap `reach`.
    fn cycle(&self, reach: f64) -> Cycle {
        let overlaps = (0..=POINTS).map(|i| reach * f64::from(i) / f64::from(POINTS));
        let there_and_back = overlaps.clone().chain(overlaps.rev());
        loop_of(there_and_back.map(|d| [d, push(self.stiffness, d)]), reach)
    }
}

/// Points of a branch of a loop.
pub(in crate::contact) const POINTS: u32 = 60;

/// k_h delta^1.5.
pub(in crate::contact) fn push(stiffness: f64, overlap: f64) -> f64 {
    stiffness * (overlap * overlap.sqrt())
}

/// 2/5 k_h delta^2.5, which 1.5-power laws store.
pub(in crate::contact) fn stored_energy(stiffness: f64, r: f64) -> f64 {
    let overlap = (-r).max(0.0);
    0.4 * push(stiffness, overlap) * overlap
}

/// dS/dr of k_h delta^1.5 at an overlap.
pub(in crate::contact) fn steepest(stiffness: f64, overlap: f64) -> f64 {
    1.5 * stiffness * overlap.sqrt()
}

/// The overlap of k_h delta^1.5 under a force of 1.
pub(in crate::contact) fn reach(stiffness: f64) -> f64 {
    1.0 / (libm::cbrt(stiffness) * libm::cbrt(stiffness))
}

/// 2 sqrt(5/4) times the integral of 1/sqrt(1 - x^2.5) from 0 to 1, which is sqrt(pi) Gamma(1.4)/Gamma(0.9).
const TOUCHING: f64 = 3.290_681_694_319_133;

/// Time for which two free masses touch up to this overlap, from the energy 2/5 k_h delta^2.5 without damping. With damping it is
/// longer; with damping of the approach alone, as Jankowski's, shorter, but more than half of it.
pub(in crate::contact) fn touching_time(
    stiffness: f64,
    inverse_mass: f64,
    overlap: f64,
) -> Option<f64> {
    Some(TOUCHING / (stiffness * overlap.sqrt() * inverse_mass).sqrt())
}

/// The part of S from the overlap alone.
pub(in crate::contact) fn conservative_force(stiffness: f64, r: f64) -> f64 {
    0.0 - push(stiffness, (-r).max(0.0))
}

impl<const L: usize> StepLaw<L> for Step<L> {
    type Memory = ();

    #[inline(always)]
    fn force(&self, trial: &Trial<L>, _: &mut ()) -> Lane<L> {
        let free = Free::new(trial, &self.start);
        resisting(self.push(&free, Lane::splat(0.0)))
    }
}
