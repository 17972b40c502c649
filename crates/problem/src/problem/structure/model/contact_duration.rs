//! How long the nodes of an impact touch.

use crate::contact::ContactKind;
use crate::solve::FEWEST_STEPS;
use crate::solve::structure::{Watched, WatchedContact};
use crate::system::structure::{Contact, Direction, Structure};

/// Time for which the nodes of an impact touch as two free masses without other forces; `None` for friction, links and rigid impacts.
/// For a law with delta^1.5 it depends on the largest overlap, and is `None` without it.
pub fn time(structure: &Structure, contact: &Contact, overlap: Option<f64>) -> Option<f64> {
    let law = contact.law.law(0.0);
    law.properties()
        .touching_time(inverse(structure, contact)?, overlap)
}

/// m1 m2/(m1 + m2) of the nodes of a contact; `None` if none of them bounces.
pub fn mass_along(structure: &Structure, contact: &Contact) -> Option<f64> {
    inverse(structure, contact).map(|inverse| 1.0 / inverse)
}

/// 1/m1 + 1/m2.
fn inverse(structure: &Structure, contact: &Contact) -> Option<f64> {
    // Between nodes of their own masses, as if other masses were not coupled to them.
    let nodes = contact.along.iter();
    let inverse: f64 = nodes
        .map(|(node, factor)| factor * factor / mass(structure, *node))
        .sum();
    // Supports alone, which do not bounce, have none.
    (inverse.is_finite() && inverse != 0.0).then_some(inverse)
}

/// The mass of a node without what the modes of a reduction move with it: M_bb - M_bm M_mb, M_mm = 1.
fn mass(structure: &Structure, node: usize) -> f64 {
    let is_modal = |node: usize| structure.nodes[node].direction == Direction::Modal;
    let mass_of_node = structure.nodes[node].mass;
    if !(0..structure.len()).any(is_modal) {
        return mass_of_node;
    }
    let entries = structure.coupled_mass.entries();
    let coupled = entries.filter(|((i, j), _)| *j == node && is_modal(*i));
    mass_of_node - coupled.map(|(_, m)| m * m).sum::<f64>()
}

/// Whether an impact touches for too few steps of `dt`.
pub fn has_short_contact(structure: &Structure, watched: Option<&Watched>, dt: f64) -> bool {
    let contacts = watched.map_or(&[][..], |watched| &watched.contacts);
    let short = |(contact, seen): (&Contact, &WatchedContact)| {
        let touches = contact.law.kind() == ContactKind::Impact && seen.force < 0.0;
        let overlap = Some(-seen.displacement).filter(|overlap| touches && *overlap > 0.0);
        let time = overlap.and_then(|_| time(structure, contact, overlap));
        time.is_some_and(|time| time < FEWEST_STEPS * dt)
    };
    structure.contacts.iter().zip(contacts).any(short)
}
