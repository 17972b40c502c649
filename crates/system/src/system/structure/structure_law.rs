//! The law of a contact of a structure.

use super::{PressedBy, Signal};
use crate::contact::offer::Form;
use crate::contact::plane::slides_in_plane;
use crate::contact::{ClippedLine, ContactKind, ContactLaw, GivenLaw};
use std::sync::Arc;

/// The law of a contact of a structure, with what the structure adds to it.
#[derive(Debug, Clone)]
pub struct StructureLaw {
    given: GivenLaw,
    /// Whether its force is found from its own answer although it is a line.
    answers: bool,
    restitution: f64,
    limit: Option<Limit>,
    row: Option<PlaneRow>,
}

/// A direction of a contact in a plane. Both directions are two contacts, one behind the other, with the same law and limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlaneRow {
    /// The first one; the next contact is the second one.
    First,
    /// The second one.
    Second,
}

impl StructureLaw {
    /// A law, or the law of a clipped line; friction has this limit.
    ///
    /// ```
    /// use slipgap_contact::contact::{ClippedLine, ContactKind};
    /// use slipgap_system::system::structure::{Limit, StructureLaw};
    ///
    /// let friction = StructureLaw::new(ClippedLine::Elastic { stiffness: 4.0 }, Limit::constant(1.0));
    /// assert_eq!(friction.kind(), ContactKind::Friction);
    /// let stop = StructureLaw::new(ClippedLine::Stop { restitution: 1.0 }, None);
    /// assert!(stop.is_rigid() && stop.limit().is_none());
    /// ```
    pub fn new(form: impl Into<Form>, limit: impl Into<Option<Limit>>) -> StructureLaw {
        let form = form.into();
        let mut limit = limit.into();
        if let Some(limit) = limit.as_mut().filter(|_| form.static_ratio > 1.0) {
            limit.static_ratio = form.static_ratio;
        }
        StructureLaw {
            given: form.given,
            answers: false,
            restitution: form.restitution,
            limit: limit.filter(|_| form.given.kind() == ContactKind::Friction),
            row: None,
        }
    }

    /// Both directions of the law in a plane; `None` for a law that does not slide in one.
    pub fn in_plane(self) -> Option<[StructureLaw; 2]> {
        let law = self.law(self.limit().map_or(0.0, |limit| limit.at(0.0)));
        slides_in_plane(&law).then(|| {
            [PlaneRow::First, PlaneRow::Second].map(|row| StructureLaw {
                given: GivenLaw::Law(law),
                row: Some(row),
                ..self.clone().from_its_answer()
            })
        })
    }

    /// The law without its line: its force is found from its own answer, as that of any other law.
    pub fn from_its_answer(self) -> StructureLaw {
        StructureLaw {
            answers: true,
            ..self
        }
    }

    /// The law without compliance that it tends to, with its target of the coefficient of restitution or its limit; itself for a law
    /// without a rigid form, as a link.
    pub fn rigid_form(self) -> StructureLaw {
        let line = match self.kind() {
            _ if !self.as_given().properties().has_rigid_form() => return self,
            ContactKind::Impact => ClippedLine::Stop {
                restitution: self.restitution,
            },
            ContactKind::Friction | ContactKind::Link => ClippedLine::Coulomb,
        };
        StructureLaw {
            given: GivenLaw::Line(line),
            answers: self.row.is_some(),
            ..self
        }
    }

    /// The direction of a contact in a plane.
    pub fn row(&self) -> Option<PlaneRow> {
        self.row
    }

    /// What the contact can do.
    pub fn kind(&self) -> ContactKind {
        self.given.kind()
    }

    /// The clipped line that the law is over a step; `None` for a law whose force is found from its own answer.
    pub fn line(&self) -> Option<ClippedLine> {
        self.given.line().filter(|_| !self.answers)
    }

    /// Whether the law is not a clipped line over a step.
    pub fn is_curved(&self) -> bool {
        self.line().is_none()
    }

    /// k of a clipped line that is a spring.
    pub fn spring(&self) -> Option<f64> {
        self.line().and_then(ClippedLine::stiffness)
    }

    /// Whether it is a rigid stop.
    pub fn is_stop(&self) -> bool {
        matches!(self.line(), Some(ClippedLine::Stop { .. }))
    }

    /// The friction limit; `None` for an impact and a link.
    pub fn limit(&self) -> Option<&Limit> {
        self.limit.as_ref()
    }

    /// The same to change it.
    pub fn limit_mut(&mut self) -> Option<&mut Limit> {
        self.limit.as_mut()
    }

    /// Whether the law has no compliance: its force does not follow from its motion.
    pub fn is_rigid(&self) -> bool {
        // In a plane, too, where its answer is its own.
        (!self.answers || self.row.is_some())
            && self.given.line().is_some_and(ClippedLine::is_rigid)
    }

    /// Static limit over the kinetic one; 1 where both are the same, or where the law itself has both.
    pub fn static_ratio(&self) -> f64 {
        // In a plane, too, where its answer is its own.
        let line = match self.row {
            Some(_) => self.given.line().filter(|line| line.is_rigid()),
            None => self.line(),
        };
        match (line, &self.limit) {
            (Some(ClippedLine::Coulomb), Some(limit)) => limit.static_ratio,
            // In series with nodes without mass.
            (Some(ClippedLine::Elastic { stiffness }), Some(limit)) if stiffness.is_infinite() => {
                limit.static_ratio
            }
            _ => 1.0,
        }
    }

    /// The law as it was given, of friction with the limit at rest, or 0 of one that was given as a line.
    pub fn as_given(&self) -> ContactLaw {
        self.given.law()
    }

    /// The law while the friction limit is this; only friction has one.
    pub fn law(&self, limit: f64) -> ContactLaw {
        self.as_given().at_limit(limit)
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
    /// What presses the contact with its force at the end of a step, which is added.
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
            pressed.map_or(0.0, |pressed_by| {
                pressed_by.limit(force, |spring| spring.at_start)
            }),
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
            pressed.map_or(0.0, |pressed_by| {
                pressed_by.limit(force, |spring| spring.spring.compression(&motion))
            }),
        )
    }

    /// The limit at time t with a part by forces that press.
    fn with(&self, t: f64, pressed: f64) -> f64 {
        let by_signal = self.varying.as_ref();
        let varying = by_signal.map_or(0.0, |(factor, signal)| factor * signal.at(t));
        let limit = (self.constant + varying + pressed).max(0.0);
        self.pressure
            .map_or(limit, |pressure| pressure.limit(limit))
    }
}
