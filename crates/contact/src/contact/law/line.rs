//! Laws that are a clipped line.

use super::ContactKind;
use crate::contact::{ContactLaw, DisplacementControl, ImpactSpring, Rigid, VelocityControl};

/// A law as it is given: by the number of a clipped line, whose reciprocal has other bits, or by its own numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GivenLaw {
    /// A clipped line.
    Line(ClippedLine),
    /// Any law.
    Law(ContactLaw),
}

impl GivenLaw {
    /// The law, of friction that is given as a line with the limit 0.
    pub fn law(self) -> ContactLaw {
        match self {
            GivenLaw::Line(line) => line.law(),
            GivenLaw::Law(law) => law,
        }
    }

    /// What its contact can do.
    pub fn kind(self) -> ContactKind {
        match self {
            GivenLaw::Line(ClippedLine::Spring { .. } | ClippedLine::Stop { .. }) => {
                ContactKind::Impact
            }
            GivenLaw::Line(_) => ContactKind::Friction,
            GivenLaw::Law(law) => law.kind(),
        }
    }

    /// The clipped line that it is.
    pub fn line(self) -> Option<ClippedLine> {
        match self {
            GivenLaw::Line(line) => Some(line),
            GivenLaw::Law(law) => law.line(),
        }
    }
}

/// A law whose S follows a line of the motion, within the bounds of an impact or of friction, with the number that it is made of.
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
