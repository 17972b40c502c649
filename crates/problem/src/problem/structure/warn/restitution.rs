//! The restitution that a law of impact gives, beside its target.

use super::doubt::Doubt;
use crate::problem::Case;
use crate::problem::numbers::short::short;
use crate::problem::structure::model::contact_duration;
use crate::problem::structure::parts::contact;
use crate::problem::structure::parts::contact_law::law_named;
use crate::problem::structure::parts::template::Template;
use crate::solve::Warning;
use crate::system::structure::{Contact, Structure};
use std::fmt;

/// Difference from the target that is worth a note.
const MISSED: f64 = 0.05;

/// The restitution of two rigid bodies without other forces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Restitution {
    /// The target.
    pub target: f64,
    /// What the law gives.
    pub given: f64,
}

impl fmt::Display for Restitution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [target, given] = [self.target, self.given].map(|e| (e * 1e3).round() / 1e3);
        write!(f, "restitution {} (target {})", short(given), short(target))
    }
}

/// Of each contact; `None` without a target.
pub fn restitutions(
    template: &Template,
    case: &Case,
    structure: &Structure,
) -> Vec<Option<Restitution>> {
    let contacts = template.contacts.iter().zip(&structure.contacts);
    let of = |(given, contact)| of_contact(given, contact, case, structure);
    contacts.map(of).collect()
}

/// Of a contact: of bodies of its `colliding_mass` or, without it, of the masses of its nodes.
fn of_contact(
    given: &contact::Contact,
    contact: &Contact,
    case: &Case,
    structure: &Structure,
) -> Option<Restitution> {
    let law = law_named(given.law.name(case)).filter(|law| law.has("restitution"))?;
    let target = given.value("restitution", case).ok()??;
    let given_mass = given.value("colliding_mass", case).ok()?;
    let colliding = given_mass.filter(|_| law.has("colliding_mass"));
    // Without dashpots of a mass, the restitution is the same for every mass and every speed.
    let mass = colliding.or_else(|| contact_duration::mass_along(structure, contact));
    let collision = contact.law.law(0.0).collision(mass.unwrap_or(1.0), 1.0)?;
    Some(Restitution {
        target,
        given: collision.restitution,
    })
}

/// The first contact that misses its target.
pub fn missed(template: &Template, case: &Case, structure: &Structure) -> Option<Doubt> {
    let results = restitutions(template, case, structure);
    let mut pairs = template.contacts.iter().zip(results);
    pairs.find_map(|(contact, restitution)| {
        let miss = restitution.filter(|found| (found.given - found.target).abs() > MISSED)?;
        let text = format!("contact {}: {miss}", contact.name);
        Some((Warning::Restitution, text))
    })
}
