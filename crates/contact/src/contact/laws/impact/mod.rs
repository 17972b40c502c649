//! The laws of impact. A contact overlaps by delta = -r > 0 and pushes with F = -S >= 0; no law pulls.
//!
//! Without the force of the step the end of the step has the overlap delta* and the closing speed ddelta*; with it
//!
//! ```text
//! delta' = delta* - h F,   ddelta' = ddelta* - h_rate F,   F = f(delta', ddelta')
//! ```
//!
//! f does not fall with delta' or ddelta', so f(delta', ddelta') does not rise with F: there is one root. Where f jumps at
//! delta' = 0 the jump is part of its graph. The laws use no quotient by h or h_rate, so either may be zero.
//!
//! **v0**, the closing speed when contact began, is set once for each contact, in the first step whose end overlaps without the
//! force of the step (r* < 0). If r(i) >= 0, it is the closing speed without force at the time of r = 0, with r and rdot linear
//! between r(i), rdot(i) and r*, rdot*. If r(i) < 0, as at the start of a run, it is -rdot(i). A contact that does not close
//! (v0 <= 0) has no damping. The first step with r* >= 0 ends the contact.

mod closing;
pub mod collision;
mod gap_yield;
pub(in crate::contact) mod hertz;
mod hyperbolic_gap;
mod impact_spring;
mod impact_yield;
mod kelvin_voigt;
mod rigid;
mod rigid_impact;
#[cfg(test)]
mod tests;
mod yielding;

pub use closing::ClosingSpeed;
pub use gap_yield::GapYield;
pub use hertz::{Hertz, HertzDamp, HuntCrossley, Jankowski, Ye};
pub use hyperbolic_gap::HyperbolicGap;
pub use impact_spring::ImpactSpring;
pub use impact_yield::ImpactYield;
pub use kelvin_voigt::KelvinVoigt;
pub use rigid::Rigid;
pub(in crate::contact) use rigid::stop;
pub use rigid_impact::RigidImpact;

use crate::contact::{Cycle, Flexibility, Trial};
use crate::lane::Lane;

/// The end of a step without the force of this step.
#[derive(Clone, Copy)]
pub(in crate::contact) struct Free<const L: usize> {
    /// delta*; 0 where the contact is open.
    overlap: Lane<L>,
    /// ddelta*.
    closing: Lane<L>,
}

impl<const L: usize> Free<L> {
    /// From a trial and the flexibility for S(i).
    #[inline(always)]
    fn new(trial: &Trial<L>, start: &Flexibility<L>) -> Self {
        let r = trial.displacement + (trial.change - trial.force * start.h);
        Free {
            overlap: (-r).larger(Lane::splat(0.0)),
            closing: trial.force * start.h_rate - trial.rate,
        }
    }
}

/// The bounds of S of an impact.
pub(in crate::contact) const PUSHES: [f64; 2] = [f64::NEG_INFINITY, 0.0];

/// S for F >= 0. The difference makes no negative zero.
#[inline(always)]
pub(in crate::contact) fn resisting<const L: usize>(force: Lane<L>) -> Lane<L> {
    Lane::splat(0.0) - force
}

/// The points of a loop (r, S) from its states (delta, F), with the open contact up to r = `reach`.
pub(in crate::contact) fn loop_of(states: impl Iterator<Item = [f64; 2]>, reach: f64) -> Cycle {
    let closed = states.map(|[overlap, force]| [0.0 - overlap, 0.0 - force]);
    let mut points = vec![[reach, 0.0], [0.0, 0.0]];
    points.extend(closed);
    points.extend([[0.0, 0.0], [reach, 0.0]]);
    (points, Vec::new())
}
