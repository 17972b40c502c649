//! Friction in a plane: r = (r1, r2), S = (S1, S2), with |S| within the limit in every direction.
//!
//! Most laws follow from their scalar form. A law of velocity has the force of the scalar law along rdot. An elastic law has it along
//! its trial force: the radial return, which allows for the turn of the force. A spring beside the friction, that of a pendulum or of hardening, acts in both directions alone.
//! Two laws have a form of their own: Bouc-Wen, whose force turns towards the motion as the isotropic model of Park, Wen and Ang (1986),
//! and LuGre, whose bristles relax towards the direction of the motion.
//!
//! Each answer is the force of the one root of a step, as that of a scalar law. It has no preferred direction.

mod any;
mod bouc_wen;
mod elastic;
mod law;
mod lugre;
mod of_velocity;
mod scalar;
#[cfg(test)]
mod tests;

pub use super::pair::{Pair, dot, length};
pub use any::{AnyPlaneLaw, InPlane, PlaneMemory};
pub use elastic::ElasticInPlane;
pub use law::{Over, PlaneLaw, Root};
pub use of_velocity::OfVelocity;

use super::coupled::curved::Directions;
use super::{ContactLaw, LAWS};

/// What a unit of force takes from the motion of a step.
#[derive(Debug, Clone, Copy)]
pub struct PlaneStep {
    /// From r'.
    pub h: f64,
    /// From rdot'.
    pub h_rate: f64,
    /// Length of the step.
    pub dt: f64,
}

/// A contact at the start of a step, and its motion over the step without its force at the end.
#[derive(Debug, Clone, Copy, Default)]
pub struct PlaneTrial {
    /// r.
    pub displacement: Pair,
    /// rdot.
    pub velocity: Pair,
    /// S.
    pub force: Pair,
    /// r' - r.
    pub change: Pair,
    /// rdot'.
    pub rate: Pair,
}

impl PlaneStep {
    /// A step of this length whose motion is given: a force takes nothing from it.
    pub fn of_given_motion(dt: f64) -> PlaneStep {
        PlaneStep {
            h: 0.0,
            h_rate: 0.0,
            dt,
        }
    }

    fn given(&self) -> PlaneStep {
        PlaneStep::of_given_motion(self.dt)
    }

    fn is_given(&self) -> bool {
        self.h == 0.0 && self.h_rate == 0.0
    }
}

/// The names of the laws of structures that slide in a plane.
pub fn names() -> impl Iterator<Item = &'static str> {
    let in_plane = LAWS.iter().filter(|law| law.in_plane);
    let offered = in_plane.filter(|law| law.offer.structure.is_some());
    offered.map(|law| law.offer.name)
}

/// Whether a law slides in a plane.
pub fn slides_in_plane(law: &ContactLaw) -> bool {
    law.in_plane(&PlaneStep::of_given_motion(1.0)).is_some()
}
