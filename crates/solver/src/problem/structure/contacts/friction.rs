//! The numbers of laws of friction.

use super::limit::limit;
use super::{LawName, Numbers, violation};
use crate::contact::{Bearing, BoucWen, ContactLaw, Dahl, Lugre, Stribeck, Tanh};
use crate::problem::Violation;
use crate::system::structure::{Limit, Relation};

/// The law of a friction contact.
pub(super) fn relation(law: LawName, numbers: Numbers, metre: f64) -> Result<Relation, Violation> {
    let (limit, at_rest) = limit(numbers, metre)?;
    let friction = Friction {
        numbers,
        limit,
        at_rest,
    };
    match law {
        LawName::Coulomb => Ok(Relation::Coulomb {
            limit: friction.limit,
        }),
        LawName::DisplacementControl => Ok(Relation::DisplacementControl {
            stiffness: friction.stiffness("displacement-control")?,
            limit: friction.limit,
        }),
        LawName::VelocityControl => friction.velocity_control(),
        LawName::Tanh => {
            let (ratio, rate) = friction.bearing()?;
            let law = Tanh {
                compliance: 1.0 / friction.viscosity("tanh", at_rest)?,
                limit: at_rest,
                ratio,
                rate,
            };
            Ok(friction.curved(ContactLaw::Tanh(law)))
        }
        LawName::Stribeck => {
            let (static_ratio, stribeck_velocity) = friction.stribeck(true)?;
            let static_limit = static_ratio * at_rest;
            let law = Stribeck {
                // rdot^E is that of the static limit.
                compliance: 1.0 / friction.viscosity("stribeck", static_limit)?,
                limit: at_rest,
                static_limit,
                stribeck_velocity,
            };
            Ok(friction.curved(ContactLaw::Stribeck(law)))
        }
        LawName::BoucWen => {
            let law = BoucWen {
                compliance: 1.0 / friction.stiffness("bouc-wen")?,
                limit: at_rest,
                exponent: numbers.other("exponent")?.unwrap_or(1.0),
            };
            Ok(friction.curved(ContactLaw::BoucWen(law)))
        }
        LawName::Dahl => {
            let law = Dahl {
                compliance: 1.0 / friction.stiffness("dahl")?,
                limit: at_rest,
                exponent: numbers.other("exponent")?.unwrap_or(1.0),
            };
            Ok(friction.curved(ContactLaw::Dahl(law)))
        }
        _ => {
            let (static_ratio, stribeck_velocity) = friction.stribeck(false)?;
            let law = Lugre {
                sigma0: numbers.needed("sigma0")?,
                sigma1: numbers.other("sigma1")?.unwrap_or(0.0),
                sigma2: numbers.other("sigma2")?.unwrap_or(0.0),
                limit: at_rest,
                static_limit: static_ratio * at_rest,
                stribeck_velocity,
            };
            Ok(friction.curved(ContactLaw::Lugre(law)))
        }
    }
}

/// A friction contact.
struct Friction<'a> {
    numbers: Numbers<'a>,
    limit: Limit,
    /// The limit at rest.
    at_rest: f64,
}

impl Friction<'_> {
    fn curved(self, law: ContactLaw) -> Relation {
        let limit = self.limit;
        Relation::CurvedFriction { law, limit }
    }

    fn velocity_control(self) -> Result<Relation, Violation> {
        let viscosity = self.viscosity("velocity-control", self.at_rest)?;
        let (ratio, rate) = self.bearing()?;
        if ratio == 1.0 {
            let limit = self.limit;
            return Ok(Relation::VelocityControl { viscosity, limit });
        }
        let law = Bearing {
            compliance: 1.0 / viscosity,
            limit: self.at_rest,
            ratio,
            rate,
        };
        Ok(self.curved(ContactLaw::Bearing(law)))
    }

    /// k, or the limit at rest over r^E.
    fn stiffness(&self, law: &str) -> Result<f64, Violation> {
        let contact = self.numbers.contact;
        let given = [&contact.k, &contact.elastic].map(|amount| self.numbers.given(amount));
        match given {
            [Ok(Some(k)), Ok(None)] => Ok(k),
            [Ok(None), Ok(Some(elastic))] => Ok(self.positive(self.at_rest, "k")? / elastic),
            [Err(fault), _] | [_, Err(fault)] => Err(fault),
            _ => Err(violation(contact, format!("{law} needs k or rE"))),
        }
    }

    /// c, or this limit at rest over rdot^E.
    fn viscosity(&self, law: &str, limit: f64) -> Result<f64, Violation> {
        let contact = self.numbers.contact;
        let given = [&contact.c, &contact.elastic_rate].map(|amount| self.numbers.given(amount));
        match given {
            [Ok(Some(c)), Ok(None)] => Ok(c),
            [Ok(None), Ok(Some(rate))] => Ok(self.positive(limit, "c")? / rate),
            [Err(fault), _] | [_, Err(fault)] => Err(fault),
            _ => Err(violation(contact, format!("{law} needs c or rdotE"))),
        }
    }

    /// The limit at rest, from which k or c follows.
    fn positive(&self, at_rest: f64, instead: &str) -> Result<f64, Violation> {
        match at_rest > 0.0 {
            true => Ok(at_rest),
            false => Err(violation(
                self.numbers.contact,
                format!("the limit at rest is {at_rest}; give {instead} instead"),
            )),
        }
    }

    /// nu_min/nu and a of nu - (nu - nu_min) exp(-a |rdot|).
    fn bearing(&self) -> Result<(f64, f64), Violation> {
        let Numbers { contact, .. } = self.numbers;
        let given = (
            self.numbers.other("nu_min")?,
            self.numbers.other("nu_rate")?,
        );
        match given {
            (None, None) => Ok((1.0, 0.0)),
            (Some(least), Some(rate)) => {
                let Some(nu) = self.numbers.given(&contact.nu)? else {
                    return Err(violation(contact, "nu_min needs nu and N"));
                };
                match least <= nu {
                    true => Ok((least / nu, rate)),
                    false => {
                        let message = format!("nu_min must be at most nu = {nu}, got {least}");
                        Err(violation(contact, message))
                    }
                }
            }
            _ => Err(violation(contact, "give nu_min and nu_rate together")),
        }
    }

    /// The static limit over the kinetic one, and v_S, which is needed if the ratio is above 1.
    fn stribeck(&self, needed: bool) -> Result<(f64, f64), Violation> {
        let ratio = self.numbers.other("static_ratio")?;
        let velocity = match needed || ratio.is_some_and(|ratio| ratio > 1.0) {
            true => self.numbers.needed("stribeck_velocity")?,
            false => self.numbers.other("stribeck_velocity")?.unwrap_or(1.0),
        };
        Ok((ratio.unwrap_or(1.0), velocity))
    }
}
