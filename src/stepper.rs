//! The constant average acceleration method for a structure's modes and one contact.
//!
//! Newmark's method with gamma = 1/2, beta = 1/4 [F section 4, I section 3]. For a mode x'' + omega2 x = -phi2 S,
//! with D = 1 + omega2 dt^2/4 and the increments P = x + dt v/2, W = dt v, the method is exactly
//!
//! ```text
//! W(i+1) = W(i) - omega2 dt^2/D P(i) - phi2 dt^2/(2 D) (S(i) + S(i+1))
//! P(i+1) = P(i) + W(i+1),   x(i+1) = P(i) + W(i+1)/2,   v(i+1) = W(i+1)/dt
//! ```
//!
//! Three additions a step, and round-off stays that of the increments however small the step. The sum of the x gives
//! r = r* - h S(i+1), the law gives the root, a second pass brings the force to the modes: O(modes) a step.

use crate::lane::Lane;
use crate::law::{Law, Trial};
use crate::structure::Mode;

/// State of the contact at the end of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact<const L: usize> {
    /// Relative displacement r.
    pub displacement: Lane<L>,
    /// Relative velocity rdot.
    pub velocity: Lane<L>,
    /// Force S.
    pub force: Lane<L>,
}

/// Modes on their way through time.
#[derive(Debug, Clone)]
pub struct Stepper<const L: usize> {
    modes: Vec<Moving<L>>,
    /// Gap at rest: r = gap + sum x.
    gap: Lane<L>,
    rate: Lane<L>,
    h: Lane<L>,
    contact: Contact<L>,
}

/// One mode: its two coefficients and its two increments.
#[derive(Debug, Clone, Copy)]
struct Moving<const L: usize> {
    stiffness: Lane<L>,
    force: Lane<L>,
    p: Lane<L>,
    w: Lane<L>,
}

/// A mode at rest or in motion at T = 0, the same mode of each lane's case.
#[derive(Debug, Clone, Copy)]
pub struct Start<const L: usize> {
    /// Each lane's mode.
    pub mode: [Mode; L],
    /// Scaled coordinate x.
    pub displacement: Lane<L>,
    /// Its velocity.
    pub velocity: Lane<L>,
}

impl<const L: usize> Stepper<L> {
    /// Modes at T = 0 with steps `dt`, the contact's `gap` and the force S(0) there: by equilibrium this is a(0).
    pub fn new(dt: Lane<L>, start: &[Start<L>], gap: Lane<L>, force: Lane<L>) -> Self {
        let rate = dt.map(|dt| 1.0 / dt);
        let zero = Lane::splat(0.0);
        let mut stepper = Stepper {
            modes: Vec::with_capacity(start.len()),
            gap,
            rate,
            h: zero,
            contact: Contact {
                displacement: gap,
                velocity: zero,
                force,
            },
        };
        for Start {
            mode,
            displacement,
            velocity,
        } in start
        {
            let omega2 = Lane(mode.map(|m| m.omega2));
            let phi2 = Lane(mode.map(|m| m.phi2));
            let shrink = (omega2 * dt * dt).map(|o| 1.0 / (1.0 + 0.25 * o));
            let w = dt * *velocity;
            let moving = Moving {
                stiffness: omega2 * dt * dt * shrink,
                force: phi2 * dt * dt * shrink * 0.5,
                p: *displacement + w * 0.5,
                w,
            };
            stepper.h = stepper.h + moving.force * 0.5;
            stepper.contact.displacement = stepper.contact.displacement + *displacement;
            stepper.contact.velocity = stepper.contact.velocity + *velocity;
            stepper.modes.push(moving);
        }
        stepper
    }

    /// The contact as it stands.
    pub fn contact(&self) -> Contact<L> {
        self.contact
    }

    /// One step; `law` gives the force at its end.
    #[inline(always)]
    pub fn step(&mut self, law: &mut impl Law<L>) -> Contact<L> {
        let (mut displacement, mut increment) = (self.gap, Lane::splat(0.0));
        for mode in &mut self.modes {
            mode.w = mode.w - mode.stiffness * mode.p - mode.force * self.contact.force;
            displacement = displacement + (mode.p + mode.w * 0.5);
            increment = increment + mode.w;
        }
        let trial = Trial {
            displacement,
            velocity: increment * self.rate,
            h: self.h,
            h_rate: self.h * self.rate * 2.0,
        };
        let force = law.respond(&trial);
        for mode in &mut self.modes {
            mode.w = mode.w - mode.force * force;
            mode.p = mode.p + mode.w;
        }
        self.contact = Contact {
            displacement: trial.displacement - trial.h * force,
            velocity: trial.velocity - trial.h_rate * force,
            force,
        };
        self.contact
    }

    /// Scaled coordinates and velocities of the modes, lane by lane, for energies and profiles.
    pub fn modes(&self) -> impl Iterator<Item = (Lane<L>, Lane<L>)> + '_ {
        self.modes
            .iter()
            .map(|mode| (mode.p - mode.w * 0.5, mode.w * self.rate))
    }
}
