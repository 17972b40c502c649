//! The motion of a contact over a step, for laws that are not clipped lines.

use crate::contact::{ClippedLine, Flexibility, StepFlexibility, Trial};
use crate::lane::Lane;
use crate::system::structure::StructureLaw;

/// How a contact moves in a step.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Scale {
    /// Change of rdot' for a unit of r'; infinite in an explicit method.
    pub(crate) pace: f64,
    pub(crate) dt: f64,
    /// Whether a node of the contact has no mass, and so no velocity: rdot' follows from r at the steps.
    pub(crate) is_massless: bool,
}

/// dt rdot' of a contact at a node without mass by the backward difference of three points: this times r' - r less half of r - r(i-1).
const THREE_POINTS: f64 = 1.5;

/// The motion of a contact over a step without the forces at its end.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Motion {
    /// r(i).
    pub(crate) displacement: f64,
    /// rdot(i).
    pub(crate) velocity: f64,
    /// S(i).
    pub(crate) force: f64,
    /// r* - r(i).
    pub(crate) change: f64,
    /// rdot*.
    pub(crate) rate: f64,
    /// Size of the terms of r* and r*- r(i); in an explicit method of rdot*.
    pub(crate) size: f64,
    /// Sizes of the terms of r(i) and of rdot(i): the motions of nodes, of which they are differences.
    pub(crate) terms: [f64; 2],
}

/// Round-off of a motion over the sizes of its terms.
pub(crate) const ROUND_OFF: f64 = 1e-14;

impl Motion {
    /// The same with no motion where r(i) or rdot(i) is round-off of terms of these sizes.
    pub(crate) fn without_round_off(self, terms: [f64; 2]) -> Motion {
        let [least, least_rate] = terms.map(|size| ROUND_OFF * size);
        let clean = |x: f64, least: f64| if x.abs() <= least { 0.0 } else { x };
        Motion {
            displacement: clean(self.displacement, least),
            velocity: clean(self.velocity, least_rate),
            ..self
        }
    }
}

impl Scale {
    pub(crate) fn is_explicit(self) -> bool {
        self.pace == f64::INFINITY
    }

    /// The same after a step, for a law that follows the velocity of nodes without mass by three points.
    pub(crate) fn by_three_points(self) -> Scale {
        Scale {
            pace: THREE_POINTS / self.dt,
            ..self
        }
    }

    /// The same in the first step.
    pub(crate) fn by_two_points(self) -> Scale {
        Scale {
            pace: 1.0 / self.dt,
            ..self
        }
    }

    /// rdot' of a contact at a node without mass that changes by this; `before` is (r - r(i-1))/dt if three points give it.
    pub(crate) fn massless_rate(self, change: f64, before: Option<f64>) -> f64 {
        let mean_rate = change / self.dt;
        before.map_or(mean_rate, |before| THREE_POINTS * mean_rate - 0.5 * before)
    }

    /// The y without forces: r* - r(i), or rdot*.
    pub(crate) fn free(self, motion: &Motion) -> f64 {
        match self.is_explicit() {
            true => motion.rate,
            false => motion.change,
        }
    }

    /// The flexibilities of an answer, and of a motion that is given.
    pub(crate) fn steps(&self, of_answer: f64) -> [StepFlexibility<1>; 2] {
        let flexibility = |h_end: f64| {
            let [h, h_rate] = match self.is_explicit() {
                true => [0.0, h_end],
                false => [h_end, self.pace * h_end],
            };
            Flexibility {
                h: Lane([h]),
                h_rate: Lane([h_rate]),
            }
        };
        [of_answer, 0.0].map(|h| StepFlexibility {
            // The motion contains S(i).
            start: flexibility(0.0),
            end: flexibility(h),
            dt: Lane([self.dt]),
            by_impulse: false,
        })
    }
}

/// The trial of a law with r* - r(i) and rdot*.
pub(crate) fn trial(motion: &Motion, change: f64, rate: f64) -> Trial<1> {
    Trial {
        displacement: Lane([motion.displacement]),
        velocity: Lane([motion.velocity]),
        force: Lane([motion.force]),
        change: Lane([change]),
        rate: Lane([rate]),
    }
}

/// 1/f' of a law that is a clipped line.
pub(crate) fn line(relation: &StructureLaw, pace: f64) -> Option<f64> {
    Some(match relation.line()? {
        ClippedLine::Spring { stiffness } | ClippedLine::Elastic { stiffness } => 1.0 / stiffness,
        ClippedLine::Stop { .. } | ClippedLine::Coulomb => 0.0,
        ClippedLine::Viscous { viscosity } => 1.0 / (viscosity * pace),
    })
}

/// The same in an explicit method: S does not follow rdot' where it follows r'.
pub(crate) fn explicit_line(relation: &StructureLaw) -> Option<f64> {
    match relation.spring() {
        Some(_) => Some(f64::INFINITY),
        None => line(relation, 1.0),
    }
}

/// Time of this step over the time step of the motion. What a damper moves in it is left out, and the round-off of displacements over
/// it is in the rate of the damper: each about 1e-9 of a velocity times a step.
pub(crate) const SHORT: f64 = 1e-6;
