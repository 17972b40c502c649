//! The phases of a contact: in each one its force is linear in the motion, and event functions are positive.

use super::contact_phase::Phase;
use super::lines::Line;
use crate::contact::ClippedLine;
use crate::system::structure::StructureLaw;

/// A contact at one time.
#[derive(Debug, Clone, Copy)]
pub struct ContactState {
    /// Its phase.
    pub phase: Phase,
    /// Displacement-control: r at which the friction spring has no force.
    pub origin: f64,
    /// S.
    pub force: f64,
    /// r, of a law of lines.
    pub r: f64,
    /// The line of a law of lines.
    pub line: Option<Line>,
}

/// The force of a contact in a phase.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Force {
    /// 0.
    None,
    /// k (r - origin).
    Spring { k: f64, origin: f64 },
    /// S = force + slope (r - at).
    Line { slope: f64, at: f64, force: f64 },
    /// c rdot.
    Dashpot { c: f64 },
    /// The limit, in this direction.
    Limit(f64),
    /// What keeps r'' = 0.
    Constraint,
}

impl ContactState {
    /// A contact in a phase, without force.
    pub fn in_phase(phase: Phase) -> ContactState {
        ContactState {
            phase,
            origin: 0.0,
            force: 0.0,
            r: 0.0,
            line: None,
        }
    }

    /// The contact on a line, at r.
    pub fn on(line: Line, r: f64) -> ContactState {
        ContactState {
            force: line.force(r),
            r,
            line: Some(line),
            ..ContactState::in_phase(line.phase)
        }
    }

    /// The force that the law has in the present phase.
    pub fn law(&self, law: &StructureLaw) -> Force {
        if let Some(line) = &self.line {
            let [at, force] = line.point;
            let slope = line.slope;
            return Force::Line { slope, at, force };
        }
        match (self.phase, law.line()) {
            (Phase::Open, _) => Force::None,
            (Phase::Sliding(direction), _) => Force::Limit(direction),
            (Phase::Closed, Some(line)) => match line {
                ClippedLine::Spring { stiffness } => Force::Spring {
                    k: stiffness,
                    origin: 0.0,
                },
                ClippedLine::Elastic { stiffness } => Force::Spring {
                    k: stiffness,
                    origin: self.origin,
                },
                ClippedLine::Viscous { viscosity } => Force::Dashpot { c: viscosity },
                ClippedLine::Stop { .. } | ClippedLine::Coulomb => Force::Constraint,
            },
            // Such laws are refused, or have lines.
            (Phase::Closed, None) => Force::None,
        }
    }
}
