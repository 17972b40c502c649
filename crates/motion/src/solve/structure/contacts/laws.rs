//! The laws of the contacts over a step.

use crate::contact::{ClippedLine, ContactKind};
use crate::system::structure::{Contact, Limit, StructureLaw};

/// A law as a clipped line S = clip((r - c)/g, low, high).
///
/// The trial r* - c is of the increments since the last step and not of r where the law depends on them only:
/// r* - c = (r* - r without the step's change of velocity) + by_increment dt rdot(i) + by_displacement (r(i) + dt rdot(i)/2)
/// + by_force S(i).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Line {
    /// g.
    pub(crate) compliance: f64,
    pub(crate) by_increment: f64,
    pub(crate) by_displacement: f64,
    pub(crate) by_force: f64,
}

impl Line {
    /// The law of a contact at a node without mass, whose rdot(i+1) is (r(i+1) - r(i))/dt.
    pub(crate) fn without_mass(law: &StructureLaw, dt: f64) -> Line {
        let viscous = |compliance| Line {
            compliance,
            by_increment: 1.0,
            by_displacement: 0.0,
            by_force: 0.0,
        };
        match law.line() {
            Some(ClippedLine::Viscous { viscosity }) => viscous(dt / viscosity),
            Some(ClippedLine::Coulomb) => viscous(0.0),
            _ => Line::new(law, dt),
        }
    }

    pub(crate) fn new(law: &StructureLaw, dt: f64) -> Line {
        let impact = |compliance| Line {
            compliance,
            by_increment: 0.5,
            by_displacement: 1.0,
            by_force: 0.0,
        };
        // c = r(i) + dt/2 rdot(i): the line is that of rdot(i+1) = 2/dt (r(i+1) - r(i)) - rdot(i).
        let viscous = |compliance| Line {
            compliance,
            by_increment: 0.5,
            by_displacement: 0.0,
            by_force: 0.0,
        };
        match law.line() {
            Some(ClippedLine::Spring { stiffness }) => impact(1.0 / stiffness),
            Some(ClippedLine::Stop { .. }) => impact(0.0),
            // c = r(i) - S(i)/k^C.
            Some(ClippedLine::Elastic { stiffness }) => Line {
                compliance: 1.0 / stiffness,
                by_increment: 1.0,
                by_displacement: 0.0,
                by_force: 1.0 / stiffness,
            },
            Some(ClippedLine::Viscous { viscosity }) => viscous(0.5 * dt / viscosity),
            Some(ClippedLine::Coulomb) => viscous(0.0),
            // The forces are found from the law's own answer.
            None if law.kind() == ContactKind::Impact => impact(0.0),
            None => viscous(0.0),
        }
    }
}

/// The bounds of the clipped line of a contact at time t. A link has none: its force is found from the law's own answer.
pub(crate) fn bounds(contact: &Contact, t: f64) -> [f64; 2] {
    match (contact.law.kind(), contact.law.limit()) {
        (ContactKind::Impact, _) => [f64::NEG_INFINITY, 0.0],
        (ContactKind::Friction, limit) => friction(limit.map_or(0.0, |limit| limit.at(t))),
        (ContactKind::Link, _) => [0.0; 2],
    }
}

/// The bounds of a force of friction.
pub(crate) fn friction(limit: f64) -> [f64; 2] {
    [-limit, limit]
}

/// A limit that changes with time.
pub(crate) fn varying(contact: &Contact) -> Option<&Limit> {
    let changes = |limit: &&Limit| limit.varying.is_some() || limit.pressed_by.is_some();
    contact.law.limit().filter(changes)
}
