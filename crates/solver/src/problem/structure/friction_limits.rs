//! The largest forces that the contacts of a motion can have by friction.

use super::channel::{Number, Quantity};
use super::columns::all_numbers;
use super::template::Template;
use crate::history::History;
use crate::system::structure::Structure;

/// The limit of each contact at the times of a motion, >= 0, in the unit of force; `None` for a contact without friction. `first` is the
/// channel of the motion with the first of [`all_numbers`].
pub fn of(
    structure: &Structure,
    template: &Template,
    first: usize,
    motion: &History,
) -> Vec<Option<Vec<f64>>> {
    let numbers = all_numbers(structure, template);
    let force = |contact: usize| {
        let own = Number::Contact(contact, Quantity::Force);
        let place = numbers.iter().position(|number| *number == own);
        place.map_or(&[][..], |place| motion.channel(first + place))
    };
    let contacts = structure.contacts.iter();
    contacts
        .map(|contact| {
            let limit = contact.law.limit()?;
            let times = motion.time.iter().enumerate();
            // The force of another contact presses as it was at the start of the step.
            let before = |step: usize, other: usize| {
                force(other)
                    .get(step.saturating_sub(1))
                    .copied()
                    .unwrap_or(0.0)
            };
            Some(
                times
                    .map(|(step, t)| limit.pressed(*t, |other| before(step, other)))
                    .collect(),
            )
        })
        .collect()
}
