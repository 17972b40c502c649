//! What laws that are alike answer alike.

use crate::contact::impact::{PUSHES, hertz};
use std::f64::consts::PI;

/// Laws that are alike, with the numbers of their common answers, which are the defaults of [`super::Properties`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Family {
    /// Impacts with a spring, by k.
    Spring(f64),
    /// Impacts with a spring that yields, by k where it is steepest. No rigid contact is what they tend to.
    Yielding(f64),
    /// Impacts with `k_h` delta^1.5, by `k_h`.
    Hertz(f64),
    /// Friction that is elastic at S = 0, by 1/k and the largest S.
    Elastic(f64, f64),
    /// Friction of rdot alone, by 1/c and the largest S.
    Viscous(f64, f64),
    /// Links, by k at rest.
    Link(f64),
    /// Laws that are like no others.
    Alone,
}

use Family::{Alone, Elastic, Hertz, Link, Spring, Viscous, Yielding};

impl Family {
    pub(super) fn shown(self) -> Vec<(&'static str, f64)> {
        match self {
            Spring(stiffness) | Yielding(stiffness) | Link(stiffness) => {
                vec![("k =", stiffness)]
            }
            Hertz(stiffness) => vec![("k_h =", stiffness)],
            Elastic(compliance, _) => vec![("k =", 1.0 / compliance)],
            Viscous(compliance, _) => vec![("c =", 1.0 / compliance)],
            Alone => Vec::new(),
        }
    }

    pub(super) fn largest_stiffness(self, overlap: f64) -> f64 {
        match self {
            Spring(stiffness) | Yielding(stiffness) | Link(stiffness) => stiffness,
            Hertz(stiffness) => hertz::steepest(stiffness, overlap),
            Elastic(compliance, _) => 1.0 / compliance,
            Viscous(..) | Alone => 0.0,
        }
    }

    pub(super) fn initial_stiffness(self, overlap: f64) -> f64 {
        match self {
            Spring(..) | Yielding(..) | Hertz(..) if overlap > 0.0 => {
                self.largest_stiffness(overlap)
            }
            // Without a limit there is no S.
            Elastic(compliance, limit) if limit > 0.0 => 1.0 / compliance,
            Link(stiffness) => stiffness,
            Spring(_) | Yielding(_) | Hertz(_) | Elastic(..) | Viscous(..) | Alone => 0.0,
        }
    }

    pub(super) fn reach(self) -> f64 {
        match self {
            Spring(stiffness) | Yielding(stiffness) => 1.0 / stiffness,
            Hertz(stiffness) => hertz::reach(stiffness),
            // Four widths.
            Elastic(compliance, limit) | Viscous(compliance, limit) => 4.0 * compliance * limit,
            Link(..) | Alone => 1.0,
        }
    }

    pub(super) fn bounds(self) -> [f64; 2] {
        match self {
            Spring(..) | Yielding(..) | Hertz(..) => PUSHES,
            Elastic(_, limit) | Viscous(_, limit) => [-limit, limit],
            Link(..) | Alone => [f64::NEG_INFINITY, f64::INFINITY],
        }
    }

    pub(super) fn over_velocity(self) -> bool {
        matches!(self, Viscous(..))
    }

    pub(super) fn has_rigid_form(self) -> bool {
        matches!(self, Spring(..) | Hertz(..) | Elastic(..) | Viscous(..))
    }

    /// With yielding it is longer.
    pub(super) fn touching_time(self, inverse_mass: f64, overlap: Option<f64>) -> Option<f64> {
        match self {
            Spring(stiffness) | Yielding(stiffness) => Some(PI / (stiffness * inverse_mass).sqrt()),
            Hertz(stiffness) => hertz::touching_time(stiffness, inverse_mass, overlap?),
            Elastic(..) | Viscous(..) | Link(..) | Alone => None,
        }
    }

    pub(super) fn is_vertical(self) -> bool {
        matches!(self, Viscous(0.0, _))
    }
}
