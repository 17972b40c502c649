//! Friction that never slides.

use super::yields;
use crate::contact::ContactKind;
use crate::problem::structure::motions::sweep::Ready;
use crate::problem::structure::parts::template::Template;
use crate::solve::structure::Watched;
use crate::system::structure::{Chain, Structure};

/// Share of its limit that a friction contact reaches where it slides; smooth laws come near to it only.
const SLIDES: f64 = 0.95;

/// Whether a friction contact never slides, and is not the elastic link of contacts in series.
pub fn has_stuck(template: &Template, ready: &Ready, watched: Option<&Watched>) -> bool {
    let Some(watched) = watched else {
        return false;
    };
    let structure = &ready.structure;
    let pairs = template.contacts.iter().zip(&structure.contacts);
    let contacts = pairs.zip(&watched.contacts).enumerate();
    let slides: Vec<(usize, bool)> = contacts
        .filter(|(_, ((_, contact), _))| contact.law.kind() == ContactKind::Friction)
        .map(|(index, ((given, _), seen))| {
            let value = |key| given.value(key, &ready.case).ok().flatten();
            // At rest the coefficient is nu_min.
            let least = value("nu_min")
                .zip(value("nu"))
                .map_or(1.0, |(min, nu)| min / nu);
            (index, seen.of_limit >= SLIDES * least.min(1.0))
        })
        .collect();
    let mut stuck = slides.iter().filter(|(_, slides)| !slides).peekable();
    // Most structures need no chains.
    if stuck.peek().is_none() {
        return false;
    }
    let chains = structure.chains();
    let slides = |contact: usize| slides.contains(&(contact, true));
    stuck.any(|(contact, _)| !is_elastic_link(structure, &chains, *contact, slides))
}

/// Whether a friction contact is elastic and has another link in its chain that gives way: one that slides, yields or damps.
fn is_elastic_link(
    structure: &Structure,
    chains: &[Chain],
    contact: usize,
    slides: impl Fn(usize) -> bool,
) -> bool {
    let gives_way = |other: usize| {
        let law = &structure.contacts[other].law;
        match law.kind() {
            ContactKind::Friction => slides(other),
            ContactKind::Impact => yields(law),
            ContactKind::Link => true,
        }
    };
    structure.contacts[contact].initial_stiffness() > 0.0
        && chains.iter().any(|chain| {
            let has = |member: usize| chain.members().any(|end| end.contact == member);
            let mut others = chain
                .links
                .iter()
                .filter(|link| link.iter().all(|end| end.contact != contact));
            has(contact) && others.any(|link| link.iter().all(|end| gives_way(end.contact)))
        })
}
