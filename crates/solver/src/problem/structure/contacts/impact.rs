//! The numbers of laws of impact.

use super::{LawName, Numbers, violation};
use crate::contact::{ContactLaw, Hertz, HertzDamp, HuntCrossley, Jankowski, KelvinVoigt, Ye};
use crate::problem::Violation;
use crate::system::structure::Relation;

/// The law of an impact.
pub(super) fn relation(law: LawName, numbers: Numbers) -> Result<Relation, Violation> {
    let contact = numbers.contact;
    let violation = |message: &str| Err(violation(contact, message));
    let (k, e) = (numbers.given(&contact.k)?, numbers.given(&contact.e)?);
    match law {
        LawName::Impact => match (k, e) {
            (Some(stiffness), None) => return Ok(Relation::ImpactSpring { stiffness }),
            (None, Some(e)) => return rigid(numbers, e),
            (None, None) => {
                return violation("missing: k of the impact spring, or e of a rigid impact");
            }
            (Some(_), Some(_)) => {
                return violation("give k of the impact spring or e of a rigid impact, not both");
            }
        },
        LawName::ImpactSpring => {
            return match k {
                Some(stiffness) => Ok(Relation::ImpactSpring { stiffness }),
                None => violation("impact-spring needs k"),
            };
        }
        LawName::Rigid => {
            return match e {
                Some(e) => rigid(numbers, e),
                None => violation("rigid needs e"),
            };
        }
        _ => {}
    }
    if law == LawName::Hertz {
        let stiffness = numbers.needed("k_h")?;
        let law = ContactLaw::Hertz(Hertz { stiffness });
        let restitution = 1.0;
        return Ok(Relation::CurvedImpact { law, restitution });
    }
    let restitution = numbers.other("restitution")?.unwrap_or(1.0);
    let law = match law {
        LawName::HertzDamp => {
            ContactLaw::HertzDamp(HertzDamp::new(numbers.needed("k_h")?, restitution))
        }
        LawName::HuntCrossley => {
            ContactLaw::HuntCrossley(HuntCrossley::new(numbers.needed("k_h")?, restitution))
        }
        LawName::Ye => ContactLaw::Ye(Ye::new(numbers.needed("k_h")?, restitution)),
        LawName::Jankowski => {
            let (k, mass) = (numbers.needed("k_h")?, numbers.needed("colliding_mass")?);
            ContactLaw::Jankowski(Jankowski::new(k, restitution, mass))
        }
        _ => {
            let Some(k) = k else {
                return violation("kelvin-voigt needs k");
            };
            let mass = numbers.needed("colliding_mass")?;
            ContactLaw::KelvinVoigt(KelvinVoigt::new(k, restitution, mass))
        }
    };
    Ok(Relation::CurvedImpact { law, restitution })
}

fn rigid(numbers: Numbers, restitution: f64) -> Result<Relation, Violation> {
    match restitution <= 1.0 {
        true => Ok(Relation::RigidStop { restitution }),
        false => Err(violation(
            numbers.contact,
            format!("e must be from 0 to 1, got {restitution}"),
        )),
    }
}
