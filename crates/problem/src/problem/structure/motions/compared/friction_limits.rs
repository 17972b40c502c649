//! The largest forces that the contacts of a motion can have by friction.

use crate::history::History;
use crate::problem::structure::channels::channel::{Number, Quantity};
use crate::problem::structure::parts::template::Template;
use crate::problem::structure::tables::history_columns::all_numbers;
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
    let course = |wanted: Number| {
        let column = numbers.iter().position(|number| *number == wanted);
        column.map_or(&[][..], |i| motion.channel(first + i))
    };
    let contacts = structure.contacts.iter();
    contacts
        .map(|contact| {
            let limit = contact.law.limit()?;
            let times = motion.time.iter().enumerate();
            let value = |step: usize, of: Number| course(of).get(step).copied().unwrap_or(0.0);
            let at = |step: usize, t: f64| {
                let force = |other| value(step, Number::Contact(other, Quantity::Force));
                let moving = |node| [Number::Displacement(node), Number::Velocity(node)];
                limit.pressed_in(t, force, |node| moving(node).map(|of| value(step, of)))
            };
            Some(times.map(|(step, t)| at(step, *t)).collect())
        })
        .collect()
}
