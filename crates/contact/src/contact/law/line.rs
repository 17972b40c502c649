//! Laws that are a clipped line.

use crate::contact::{ContactLaw, DisplacementControl, ImpactSpring, Rigid, VelocityControl};

/// A law whose S follows a line of the motion, within the bounds of an impact or of friction, with the number that it was made of: the
/// reciprocal of a stiffness has other bits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ClippedLine {
    /// S = k min(r, 0) `[I (7)]`.
    Spring {
        /// k, > 0.
        stiffness: f64,
    },
    /// S <= 0 <= r, and r' after an impact is -e times r' before it.
    Stop {
        /// e, from 0 to 1.
        restitution: f64,
    },
    /// Friction, elastic with k up to its limit `[F (9)]`.
    Elastic {
        /// k^C, > 0.
        stiffness: f64,
    },
    /// Friction, viscous with c up to its limit `[F (16)]`.
    Viscous {
        /// c^C, > 0.
        viscosity: f64,
    },
    /// Friction without compliance, Coulomb's.
    Coulomb,
}

impl ClippedLine {
    /// k of a spring or of elastic friction.
    pub fn stiffness(self) -> Option<f64> {
        match self {
            ClippedLine::Spring { stiffness } | ClippedLine::Elastic { stiffness } => {
                Some(stiffness)
            }
            ClippedLine::Stop { .. } | ClippedLine::Viscous { .. } | ClippedLine::Coulomb => None,
        }
    }

    /// The law of the line, of friction with the limit 0.
    pub fn law(self) -> ContactLaw {
        let limit = 0.0;
        match self {
            ClippedLine::Spring { stiffness } => ImpactSpring { stiffness }.into(),
            ClippedLine::Stop { restitution } => Rigid {
                restitution,
                impulses: false,
            }
            .into(),
            ClippedLine::Elastic { stiffness } => {
                let compliance = 1.0 / stiffness;
                DisplacementControl { compliance, limit }.into()
            }
            ClippedLine::Viscous { viscosity } => {
                let compliance = 1.0 / viscosity;
                VelocityControl { compliance, limit }.into()
            }
            ClippedLine::Coulomb => {
                let compliance = 0.0;
                VelocityControl { compliance, limit }.into()
            }
        }
    }

    /// Whether it has no compliance: its force does not follow from its motion.
    pub fn is_rigid(self) -> bool {
        matches!(self, ClippedLine::Stop { .. } | ClippedLine::Coulomb)
    }
}
