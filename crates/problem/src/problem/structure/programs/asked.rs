//! The channels that a program is asked for: those from which the quantities of a case follow.

use crate::contact::ClippedLine;
use crate::problem::structure::channels::channel::{Number, Quantity};
use crate::problem::structure::motions::derived;
use crate::solve::Unsolvable;
use crate::system::structure::{PlaneRow, Structure};

/// What a program is asked for.
#[derive(Debug)]
pub(super) struct Asked {
    /// Whether u of each node, v of each node and S of each contact is asked for.
    pub(super) wanted: [Vec<bool>; 3],
}

/// The kinds of channels, in the order of [`Asked::wanted`].
pub(super) const U: usize = 0;
pub(super) const V: usize = 1;
pub(super) const S: usize = 2;

impl Asked {
    /// What these quantities follow from, and the energies if they are wanted.
    ///
    /// # Errors
    /// A quantity does not follow from a motion.
    pub(super) fn new(
        structure: &Structure,
        numbers: &[Number],
        energies: bool,
    ) -> Result<Asked, Unsolvable> {
        let count = [structure.len(), structure.len(), structure.contacts.len()];
        let has_energy = |number: &Number| matches!(number, Number::Energy(_));
        if energies || numbers.iter().any(has_energy) {
            let wanted = count.map(|count| vec![true; count]);
            return Ok(Asked { wanted });
        }
        let mut asked = Asked {
            wanted: count.map(|count| vec![false; count]),
        };
        let derived: Vec<_> = numbers.iter().filter_map(Number::derived).collect();
        for terms in derived::terms(structure, &derived)? {
            terms.u.iter().for_each(|(node, _)| asked.add(U, *node));
            terms.v.iter().for_each(|(node, _)| asked.add(V, *node));
            terms
                .s
                .iter()
                .for_each(|(contact, _)| asked.add(S, *contact));
        }
        for number in numbers {
            asked.add_number(structure, *number);
        }
        Ok(asked)
    }

    /// Supports follow the nodes, and are known.
    fn add(&mut self, kind: usize, index: usize) {
        if let Some(wanted) = self.wanted[kind].get_mut(index) {
            *wanted = true;
        }
    }

    fn add_number(&mut self, structure: &Structure, number: Number) {
        if let Some(both) = number.directions() {
            both.into_iter()
                .for_each(|one| self.add_number(structure, one));
            return;
        }
        match number {
            Number::Displacement(node) => self.add(U, node),
            Number::Velocity(node) => self.add(V, node),
            Number::Acceleration(_) | Number::Derived(_) | Number::Energy(_) => {}
            Number::Contact(contact, quantity) => {
                let law = &structure.contacts[contact].law;
                let is_elastic = matches!(law.line(), Some(ClippedLine::Elastic { .. }));
                let kinds: &[usize] = match quantity {
                    Quantity::Displacement | Quantity::Distance => &[U],
                    Quantity::Velocity | Quantity::Speed => &[V],
                    Quantity::Force | Quantity::Size => &[S],
                    Quantity::Slip | Quantity::SlipDistance if is_elastic => &[U, S],
                    Quantity::Slip | Quantity::SlipDistance => &[U],
                    Quantity::Limit => {
                        self.add_limit(structure, contact);
                        &[]
                    }
                };
                for kind in kinds {
                    match *kind == S {
                        true => self.add(S, contact),
                        false => {
                            let along = structure.contacts[contact].along.iter();
                            along.for_each(|(node, _)| self.add(*kind, *node));
                        }
                    }
                }
            }
        }
    }

    /// What presses a contact.
    fn add_limit(&mut self, structure: &Structure, contact: usize) {
        let limit = structure.contacts[contact].law.limit();
        let Some(pressed_by) = limit.and_then(|limit| limit.pressed_by.as_ref()) else {
            return;
        };
        pressed_by
            .contacts
            .iter()
            .for_each(|other| self.add(S, *other));
        for spring in &pressed_by.springs {
            for (node, _) in &spring.spring.along {
                self.add(U, *node);
                self.add(V, *node);
            }
        }
    }

    /// Whether u, v and S of the whole structure are asked for.
    pub(super) fn is_whole(&self) -> bool {
        self.wanted.iter().flatten().all(|wanted| *wanted)
    }

    /// The channels with their names.
    pub(super) fn channels(&self, structure: &Structure) -> Vec<(usize, usize, String)> {
        let wanted = self.wanted.iter().enumerate();
        let channels = wanted.flat_map(|(kind, wanted)| {
            let indices = wanted.iter().enumerate().filter(|(_, wanted)| **wanted);
            indices.map(move |(index, _)| (kind, index, name(structure, kind, index)))
        });
        channels.collect()
    }
}

/// The name of a channel: `a`, `a.v`, `joint.S`, or `disc.S.1` of a contact in a plane.
fn name(structure: &Structure, kind: usize, index: usize) -> String {
    match kind {
        U => structure.nodes[index].name.clone(),
        V => format!("{}.v", structure.nodes[index].name),
        _ => {
            let [name, direction] = name_and_direction(structure, index);
            format!("{name}.S{direction}")
        }
    }
}

/// The name of a contact, and `.1` or `.2` of a direction in a plane.
pub(super) fn name_and_direction(structure: &Structure, contact: usize) -> [&str; 2] {
    let placed = &structure.contacts[contact];
    let split = match placed.law.row() {
        Some(PlaneRow::First) => placed.name.strip_suffix(".1").map(|name| [name, ".1"]),
        Some(PlaneRow::Second) => placed.name.strip_suffix(".2").map(|name| [name, ".2"]),
        None => None,
    };
    split.unwrap_or([&placed.name, ""])
}
