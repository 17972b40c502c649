//! Contacts that do not do what they are for: they never yield, never pull, or nothing presses them.

use crate::problem::structure::motions::sweep::Ready;
use crate::problem::structure::parts::contact_law::law_named;
use crate::problem::structure::parts::template::Template;
use crate::solve::structure::{Watched, WatchedContact};
use crate::solve::{Warning, Warnings};
use crate::system::structure::Contact;

/// Share of Fy that a contact reaches where it yields.
const YIELDS: f64 = 0.95;

/// The warnings of a case with some of these: of a bridge, some parts may be idle.
pub fn with(given: Warnings, template: &Template, ready: &Ready, watched: &Watched) -> Warnings {
    let contacts = ready.structure.contacts.iter().zip(&watched.contacts);
    let in_tension = contacts
        .clone()
        .any(|(contact, seen)| in_tension(contact, seen));
    let given = given.with(Warning::NormalTension, in_tension);
    let has = |key: &str| {
        let mut contacts = template.contacts.iter();
        contacts.any(|contact| contact.number(key).is_some())
    };
    if !has("Fy") && !has("slack") {
        return given;
    }
    let [mut yielding, mut pulling] = [Vec::new(), Vec::new()];
    for (contact, (_, seen)) in template.contacts.iter().zip(contacts) {
        // A contact may have numbers for another law.
        let law = law_named(contact.law.name(&ready.case));
        let number = |key: &str| {
            let value = contact.value(key, &ready.case).ok().flatten();
            value.filter(|_| law.is_some_and(|law| law.has(key)))
        };
        let force = seen.pull.max(-seen.force);
        if number("slack").is_some() {
            pulling.push(force > 0.0);
        }
        if let Some(fy) = number("Fy").filter(|_| force > 0.0) {
            yielding.push(force >= YIELDS * fy);
        }
    }
    let never = |answers: &[bool]| !answers.is_empty() && !answers.contains(&true);
    given
        .with(Warning::NeverYields, never(&yielding))
        .with(Warning::NeverPulls, never(&pulling))
}

/// Whether springs alone press a friction contact, and at some step do not.
fn in_tension(contact: &Contact, seen: &WatchedContact) -> bool {
    let pressed = contact
        .law
        .limit()
        .and_then(|limit| limit.pressed_by.as_ref());
    pressed.is_some_and(|parts| parts.contacts.is_empty()) && seen.limit <= 0.0
}
