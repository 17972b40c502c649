//! The force of one contact at t = 0.

use crate::contact::{AnyRunningLaw, ContactLaw, ContactResponse, Unsolved};
use crate::lane::Lane;
use crate::solve::structure::contacts::curved::step::{Motion, Scale, trial};
use crate::system::structure::Structure;

/// S(0) of a contact with a law that is not a clipped line: it follows from r and rdot, or from its state, which is unbent without static
/// loads.
pub(crate) fn first_force(
    structure: &Structure,
    contact: usize,
    r: f64,
    rdot: f64,
) -> Result<f64, Unsolved> {
    let relation = &structure.contacts[contact].law;
    let limit = relation.limit().map_or(0.0, |limit| limit.at(0.0));
    let law = relation.law(limit);
    let scale = Scale {
        pace: 0.0,
        dt: 1.0,
        is_massless: false,
    };
    let remembers = structure.preload.laws.get(contact).copied().flatten();
    if let (Some(force), None) = (law.properties().unbent_force(rdot), remembers) {
        return Ok(force);
    }
    // A contact that leaves its equilibrium with a velocity has the state of the equilibrium.
    let at_rest = structure.preload.force(contact);
    if let (Some(evolution), Some(_), true) = (law.evolution(), at_rest, rdot != 0.0) {
        return Ok(evolution.force(evolution.at_start(at_rest, r), r, rdot));
    }
    let running = || ContactLaw::running(&[law], &scale.steps(0.0));
    let mut law: AnyRunningLaw<1> = remembers.unwrap_or_else(running);
    let motion = Motion {
        displacement: r,
        velocity: rdot,
        force: at_rest.unwrap_or_default(),
        ..Motion::default()
    };
    let Lane([force]) = ContactResponse::force(&mut law, 1, &trial(&motion, 0.0, rdot));
    match law.own_fault() {
        None => Ok(force),
        Some(why) => Err(Unsolved::Own { contact, why }),
    }
}
