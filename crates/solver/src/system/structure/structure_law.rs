//! The law of a contact of a structure.

use super::{PressedBy, Signal};
use crate::contact::offer::Form;
use crate::contact::plane::slides_in_plane;
use crate::contact::{
    ContactKind, ContactLaw, DisplacementControl, ImpactSpring, Rigid, VelocityControl,
};
use std::sync::Arc;

/// The law of a contact of a structure.
#[derive(Debug, Clone)]
pub enum StructureLaw {
    /// S = k min(r, 0) `[I (7)]`.
    ImpactSpring {
        /// k, > 0.
        stiffness: f64,
    },
    /// S <= 0 <= r, and r' after an impact is -e times r' before it.
    RigidStop {
        /// e, from 0 to 1.
        restitution: f64,
    },
    /// Elastic with k up to the limit `[F (9)]`; S(0) = 0.
    DisplacementControl {
        /// k^C, > 0.
        stiffness: f64,
        /// Friction limit.
        limit: Limit,
    },
    /// Viscous with c up to the limit `[F (16)]`.
    VelocityControl {
        /// c^C, > 0.
        viscosity: f64,
        /// Friction limit.
        limit: Limit,
    },
    /// Coulomb friction without compliance.
    Coulomb {
        /// Friction limit.
        limit: Limit,
    },
    /// A law of impact that is not a clipped line.
    CurvedImpact {
        /// The law.
        law: ContactLaw,
        /// Its target of the coefficient of restitution; 1 without damping.
        restitution: f64,
    },
    /// A law of friction that is not a clipped line.
    CurvedFriction {
        /// The law; its limit follows [`Limit`].
        law: ContactLaw,
        /// Friction limit; of a coefficient that depends on velocity, the largest or the kinetic one.
        limit: Limit,
    },
    /// A law of a link, whose force is always found from its own answer.
    Link {
        /// The law.
        law: ContactLaw,
    },
    /// One direction of friction in a plane. Both directions are two contacts, one behind the other, with the same law and limit.
    Plane {
        /// The law.
        law: ContactLaw,
        /// Friction limit; 0 for a link, whose law has its own.
        limit: Limit,
        /// Which direction.
        row: PlaneRow,
    },
}

/// A direction of a contact in a plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlaneRow {
    /// The first one; the next contact is the second one.
    First,
    /// The second one.
    Second,
}

impl StructureLaw {
    /// The law of a form; a law of friction has this limit.
    pub fn new(form: Form, limit: Limit) -> StructureLaw {
        match form {
            Form::Spring { stiffness } => StructureLaw::ImpactSpring { stiffness },
            Form::Stop { restitution } => StructureLaw::RigidStop { restitution },
            Form::Elastic { stiffness } => StructureLaw::DisplacementControl { stiffness, limit },
            Form::Viscous { viscosity } => StructureLaw::VelocityControl { viscosity, limit },
            Form::Coulomb { static_ratio } => StructureLaw::Coulomb {
                limit: Limit {
                    static_ratio,
                    ..limit
                },
            },
            Form::Impact { law, restitution } => StructureLaw::CurvedImpact { law, restitution },
            Form::Friction(law) => StructureLaw::CurvedFriction { law, limit },
            Form::Link(law) => StructureLaw::Link { law },
        }
    }

    /// Both directions of the law in a plane; `None` for a law that does not slide in one.
    pub fn in_plane(self) -> Option<[StructureLaw; 2]> {
        let limit = self.limit().cloned().unwrap_or(Limit::constant(0.0));
        let law = self.law(limit.at(0.0));
        slides_in_plane(&law).then(|| {
            [PlaneRow::First, PlaneRow::Second].map(|row| StructureLaw::Plane {
                law,
                limit: limit.clone(),
                row,
            })
        })
    }

    /// The direction of a contact in a plane.
    pub fn row(&self) -> Option<PlaneRow> {
        match self {
            StructureLaw::Plane { row, .. } => Some(*row),
            _ => None,
        }
    }

    /// What the contact can do.
    pub fn kind(&self) -> ContactKind {
        match self {
            StructureLaw::ImpactSpring { .. }
            | StructureLaw::RigidStop { .. }
            | StructureLaw::CurvedImpact { .. } => ContactKind::Impact,
            StructureLaw::DisplacementControl { .. }
            | StructureLaw::VelocityControl { .. }
            | StructureLaw::CurvedFriction { .. }
            | StructureLaw::Coulomb { .. } => ContactKind::Friction,
            StructureLaw::Link { .. } => ContactKind::Link,
            StructureLaw::Plane { law, .. } => law.kind(),
        }
    }

    /// The friction limit; `None` for an impact and a link.
    pub fn limit(&self) -> Option<&Limit> {
        match self {
            StructureLaw::ImpactSpring { .. }
            | StructureLaw::RigidStop { .. }
            | StructureLaw::CurvedImpact { .. }
            | StructureLaw::Link { .. } => None,
            StructureLaw::Plane { law, limit, .. } => {
                (law.kind() == ContactKind::Friction).then_some(limit)
            }
            StructureLaw::DisplacementControl { limit, .. }
            | StructureLaw::VelocityControl { limit, .. }
            | StructureLaw::CurvedFriction { limit, .. }
            | StructureLaw::Coulomb { limit } => Some(limit),
        }
    }

    /// The same to change it.
    pub fn limit_mut(&mut self) -> Option<&mut Limit> {
        match self {
            StructureLaw::ImpactSpring { .. }
            | StructureLaw::RigidStop { .. }
            | StructureLaw::CurvedImpact { .. }
            | StructureLaw::Link { .. } => None,
            StructureLaw::Plane { law, limit, .. } => {
                (law.kind() == ContactKind::Friction).then_some(limit)
            }
            StructureLaw::DisplacementControl { limit, .. }
            | StructureLaw::VelocityControl { limit, .. }
            | StructureLaw::CurvedFriction { limit, .. }
            | StructureLaw::Coulomb { limit } => Some(limit),
        }
    }

    /// Whether the law has no compliance: its force does not follow from its motion.
    pub fn is_rigid(&self) -> bool {
        match self {
            StructureLaw::RigidStop { .. } | StructureLaw::Coulomb { .. } => true,
            StructureLaw::Plane { law, .. } => {
                matches!(law, ContactLaw::VelocityControl(own) if own.compliance == 0.0)
            }
            _ => false,
        }
    }

    /// Static limit over the kinetic one; 1 where both are the same, or where the law itself has both.
    pub fn static_ratio(&self) -> f64 {
        match self {
            StructureLaw::Coulomb { limit } => limit.static_ratio,
            _ => 1.0,
        }
    }

    /// Whether the law is not a clipped line over a step.
    pub fn is_curved(&self) -> bool {
        matches!(
            self,
            StructureLaw::CurvedImpact { .. }
                | StructureLaw::CurvedFriction { .. }
                | StructureLaw::Link { .. }
                | StructureLaw::Plane { .. }
        )
    }

    /// The law while the friction limit is this; only friction has one.
    pub fn law(&self, limit: f64) -> ContactLaw {
        match *self {
            StructureLaw::ImpactSpring { stiffness } => {
                ContactLaw::ImpactSpring(ImpactSpring { stiffness })
            }
            StructureLaw::RigidStop { restitution } => ContactLaw::Rigid(Rigid {
                restitution,
                impulses: false,
            }),
            StructureLaw::DisplacementControl { stiffness, .. } => {
                let compliance = 1.0 / stiffness;
                ContactLaw::DisplacementControl(DisplacementControl { compliance, limit })
            }
            StructureLaw::VelocityControl { viscosity, .. } => {
                let compliance = 1.0 / viscosity;
                ContactLaw::VelocityControl(VelocityControl { compliance, limit })
            }
            StructureLaw::Coulomb { .. } => {
                let compliance = 0.0;
                ContactLaw::VelocityControl(VelocityControl { compliance, limit })
            }
            StructureLaw::CurvedImpact { law, .. } | StructureLaw::Link { law } => law,
            StructureLaw::CurvedFriction { law, .. } => law.at_limit(limit),
            StructureLaw::Plane { law, .. } => match law.kind() {
                ContactKind::Friction => law.at_limit(limit),
                ContactKind::Impact | ContactKind::Link => law,
            },
        }
    }
}

/// Friction limit max(constant + factor signal(t), 0): where the normal force is not positive, the contact is open and has no
/// friction `[F (3)]`. Where the coefficient falls with the pressure, the limit is L (L/L0)^(-p) for this L, with L0 at rest.
#[derive(Debug, Clone)]
pub struct Limit {
    /// Limit where the signal is 0.
    pub constant: f64,
    /// Factor of the signal, and the signal; `None` for a limit that does not change.
    pub varying: Option<(f64, Arc<Signal>)>,
    /// How the coefficient of friction falls with the normal force; `None` if it does not.
    pub pressure: Option<Pressure>,
    /// What presses the contact with its force at the start of a step, which is added.
    pub pressed_by: Option<PressedBy>,
    /// Of Coulomb friction: up to so many times the limit a contact sticks, >= 1. 1 of other laws.
    pub static_ratio: f64,
}

/// nu = nu0 (N/N0)^(-p).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pressure {
    /// nu0 N0, the limit at rest, > 0.
    pub at_rest: f64,
    /// p, >= 0 and < 1.
    pub exponent: f64,
}

impl Pressure {
    /// The limit for nu0 N.
    pub fn limit(&self, limit: f64) -> f64 {
        match limit > 0.0 {
            true => limit * libm::pow(limit / self.at_rest, -self.exponent),
            false => 0.0,
        }
    }
}

impl Limit {
    /// A limit that does not change.
    pub fn constant(limit: f64) -> Limit {
        Limit {
            constant: limit,
            varying: None,
            pressure: None,
            pressed_by: None,
            static_ratio: 1.0,
        }
    }

    /// The limit at time t, without forces that press.
    pub fn at(&self, t: f64) -> f64 {
        self.with(t, 0.0)
    }

    /// The limit at time t with these forces of contacts, and those of springs at the start.
    pub fn pressed(&self, t: f64, force: impl Fn(usize) -> f64) -> f64 {
        let pressed = self.pressed_by.as_ref();
        self.with(
            t,
            pressed.map_or(0.0, |own| own.limit(force, |spring| spring.at_start)),
        )
    }

    /// The limit at time t with these forces of contacts, and u and u' of nodes.
    pub fn pressed_in(
        &self,
        t: f64,
        force: impl Fn(usize) -> f64,
        motion: impl Fn(usize) -> [f64; 2],
    ) -> f64 {
        let pressed = self.pressed_by.as_ref();
        self.with(
            t,
            pressed.map_or(0.0, |own| {
                own.limit(force, |spring| spring.spring.compression(&motion))
            }),
        )
    }

    /// The limit at time t with a part by forces that press.
    fn with(&self, t: f64, pressed: f64) -> f64 {
        let varying = self.varying.as_ref();
        let varying = varying.map_or(0.0, |(factor, signal)| factor * signal.at(t));
        let limit = (self.constant + varying + pressed).max(0.0);
        self.pressure
            .map_or(limit, |pressure| pressure.limit(limit))
    }
}
