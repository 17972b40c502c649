//! The names of a structure: for channels, and of the channels of a case for people.

use super::template::Template;
use crate::problem::structure::channels::channel::QUANTITIES;
use crate::problem::structure::channels::channel::describe::{OF_ENERGY, OF_NODES, joined};
use crate::problem::structure::channels::names::StructureNames;
use crate::system::structure::{Direction, PlaneRow};
use std::collections::HashSet;

/// The channels of a case on one line, for `explain`: with so many elements in each bar.
pub fn listed(template: &Template, elements: &[u32]) -> String {
    let mut parts = vec![format!("{} of nodes", joined(&OF_NODES))];
    if !template.contacts.is_empty() {
        parts.push(format!("{} of contacts", joined(&QUANTITIES)));
    }
    let names = template.springs.iter().map(|spring| &spring.name);
    let springs = names.filter(|name| !name.is_empty());
    parts.extend(springs.map(|name| format!("{name}.S")));
    let bars = template.bars.iter().zip(elements);
    parts.extend(bars.map(|(bar, n)| match n {
        1 => format!("{}.1.S", bar.name),
        n => format!("{0}.1.S to {0}.{n}.S", bar.name),
    }));
    let forces = template.matrices.iter().flat_map(|matrices| {
        let forces = matrices.imported.dofs.member_forces().iter();
        forces.map(|force| format!("{}.{}", matrices.name, force.name))
    });
    parts.extend(forces);
    parts.push("base".to_owned());
    let supports = template.supports.iter();
    parts.extend(supports.map(|support| format!("base.{}", support.full_name())));
    if !template.ground.is_empty() {
        parts.push("ground".to_owned());
    }
    let energies = OF_ENERGY.map(|row| row.0.trim_start_matches("energy."));
    parts.push(format!("energy.{{{}}}", energies.join(", ")));
    format!("channels: {}\n", parts.join("; "))
}

impl Template {
    /// What the structure adds to the names of nodes and contacts.
    pub fn names(&self) -> StructureNames {
        let numbered = self.springs.iter().enumerate();
        let springs = numbered.filter(|(_, spring)| !spring.name.is_empty());
        let contacts = self.contacts.iter().enumerate();
        let first = contacts.filter(|(_, contact)| contact.row == Some(PlaneRow::First));
        let masses = self.masses.iter().map(|mass| mass.direction);
        let bars = self.bars.iter().map(|bar| bar.direction);
        let blocks = self.matrices.iter();
        let rows = blocks.flat_map(|matrices| matrices.imported.dofs.rows());
        let moving: HashSet<Direction> = masses
            .chain(bars)
            .chain(rows.map(|dof| dof.direction))
            .collect();
        let directions = Direction::TRANSLATIONS.into_iter();
        StructureNames {
            springs: springs
                .map(|(index, spring)| (spring.name.clone(), index))
                .collect(),
            planes: first
                .filter_map(|(index, contact)| {
                    Some((contact.name.strip_suffix(".1")?.to_owned(), index))
                })
                .collect(),
            ground: self.ground.iter().map(|motion| motion.0).collect(),
            directions: directions
                .filter(|direction| moving.contains(direction))
                .collect(),
        }
    }
}
