//! The law of a contact in a case.

use super::amount::Amount;
use super::template::{Contact, Normal};
use crate::problem::choice::choice;
use crate::problem::{Case, Violation};
use crate::system::loads::STANDARD_GRAVITY;
use crate::system::structure::{Limit, Relation};

choice! {
    /// Law of a contact of a structure.
    pub enum LawName {
        Impact = "impact":
            "closes when r reaches 0; a spring k [I (7)], or rigid with restitution e",
        DisplacementControl = "displacement-control":
            "friction, elastic up to the displacement r^E, then sliding at the limit [F (9)]",
        VelocityControl = "velocity-control":
            "friction, viscous up to the velocity rdot^E, then at the limit [F (16)]",
        Coulomb = "coulomb": "friction without compliance: sticks below the limit, slides at it",
    }
}

/// The law of a contact in a case.
///
/// # Errors
/// A number that the law needs is missing or out of its range.
pub fn relation(contact: &Contact, case: &Case, metre: f64) -> Result<Relation, Violation> {
    let name = contact.law.name(case);
    let Some(law) = LawName::parse(name) else {
        return Err(violation(contact, format!("no law \"{name}\"")));
    };
    let number = |amount: &Option<Amount>| amount.as_ref().map(|a| a.value(case)).transpose();
    match law {
        LawName::Impact => match (number(&contact.k)?, number(&contact.e)?) {
            (Some(stiffness), None) => Ok(Relation::ImpactSpring { stiffness }),
            (None, Some(restitution)) if restitution <= 1.0 => {
                Ok(Relation::RigidStop { restitution })
            }
            (None, Some(restitution)) => Err(violation(
                contact,
                format!("e must be from 0 to 1, got {restitution}"),
            )),
            (None, None) => Err(violation(
                contact,
                "missing: k of the impact spring, or e of a rigid impact",
            )),
            (Some(_), Some(_)) => Err(violation(
                contact,
                "give k of the impact spring or e of a rigid impact, not both",
            )),
        },
        LawName::DisplacementControl => {
            let (limit, at_rest) = limit(contact, case, metre)?;
            let stiffness = match (number(&contact.k)?, number(&contact.elastic)?) {
                (Some(k), None) => k,
                (None, Some(elastic)) => positive(contact, at_rest, "k")? / elastic,
                _ => return Err(violation(contact, "displacement-control needs k or rE")),
            };
            Ok(Relation::DisplacementControl { stiffness, limit })
        }
        LawName::VelocityControl => {
            let (limit, at_rest) = limit(contact, case, metre)?;
            let viscosity = match (number(&contact.c)?, number(&contact.elastic_rate)?) {
                (Some(c), None) => c,
                (None, Some(rate)) => positive(contact, at_rest, "c")? / rate,
                _ => return Err(violation(contact, "velocity-control needs c or rdotE")),
            };
            Ok(Relation::VelocityControl { viscosity, limit })
        }
        LawName::Coulomb => {
            let (limit, _) = limit(contact, case, metre)?;
            Ok(Relation::Coulomb { limit })
        }
    }
}

/// The limit at rest, from which k or c follows.
fn positive(contact: &Contact, at_rest: f64, instead: &str) -> Result<f64, Violation> {
    match at_rest > 0.0 {
        true => Ok(at_rest),
        false => Err(violation(
            contact,
            format!("the limit at rest is {at_rest}; give {instead} instead"),
        )),
    }
}

/// The friction limit, and its value at rest.
fn limit(contact: &Contact, case: &Case, metre: f64) -> Result<(Limit, f64), Violation> {
    if let Some(limit) = &contact.limit {
        let limit = limit.value(case)?;
        return Ok((Limit::constant(limit), limit));
    }
    let (Some(nu), Some(normal)) = (&contact.nu, &contact.normal) else {
        let needs = "friction needs limit, or nu and N";
        return Err(violation(contact, needs));
    };
    let nu = nu.value(case)?;
    match normal {
        Normal::Constant(force) => {
            let limit = (nu * force.value(case)?).max(0.0);
            Ok((Limit::constant(limit), limit))
        }
        Normal::Table(source) => {
            let signal = source.signal(case, metre)?;
            let at_rest = nu * signal.at(0.0);
            let varying = Some((nu, signal));
            let constant = 0.0;
            Ok((Limit { constant, varying }, at_rest))
        }
        Normal::Weight { weight, vertical } => {
            let weight = nu * weight.value(case)?;
            let (signal, scale) = vertical.in_case(case, metre)?;
            let gravity = STANDARD_GRAVITY / metre;
            let varying = Some((weight * scale / gravity, signal));
            let constant = weight;
            Ok((Limit { constant, varying }, weight))
        }
    }
}

/// A rule that a contact breaks.
pub fn violation(contact: &Contact, message: impl Into<String>) -> Violation {
    Violation {
        parameter: contact.place.1.clone().into(),
        message: message.into(),
        at: Some(contact.place.0),
    }
}
