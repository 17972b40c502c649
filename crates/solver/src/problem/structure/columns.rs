//! The columns of a history: every node and every contact of a case.

use super::channel::{Number, Quantity};
use crate::problem::HistoryColumn;
use crate::problem::schema::Channel as Column;
use crate::problem::unit::Dimension;
use crate::system::structure::Structure;

/// u and v of every node, u, v and a of every support that moves, r, rdot and S of every contact.
pub fn all_numbers(structure: &Structure) -> Vec<Number> {
    let nodes = 0..structure.len();
    let of_nodes = nodes.flat_map(|i| [Number::Displacement(i), Number::Velocity(i)]);
    let of_supports = (0..structure.supports.len()).flat_map(|s| {
        let node = structure.len() + s;
        [
            Number::Displacement(node),
            Number::Velocity(node),
            Number::Acceleration(s),
        ]
    });
    let of_contacts = (0..structure.contacts.len()).flat_map(|c| {
        [Quantity::Displacement, Quantity::Velocity, Quantity::Force]
            .map(|quantity| Number::Contact(c, quantity))
    });
    of_nodes.chain(of_supports).chain(of_contacts).collect()
}

/// The columns of [`all_numbers`], of which the first is channel `first` of the history.
pub fn of(structure: &Structure, first: usize, exact: bool) -> Vec<HistoryColumn> {
    let nodes = structure.nodes.iter().flat_map(|node| {
        [("u", Dimension::Length), ("v", Dimension::Velocity)]
            .map(|(end, dimension)| (format!("{}.{end}", node.name), dimension))
    });
    let contacts = structure.contacts.iter().flat_map(|contact| {
        [
            ("r", Dimension::Length),
            ("rdot", Dimension::Velocity),
            ("S", Dimension::Force),
        ]
        .map(|(end, dimension)| (format!("{}.{end}", contact.name), dimension))
    });
    let supports = structure.supports.iter().flat_map(|support| {
        [
            ("u", Dimension::Length),
            ("v", Dimension::Velocity),
            ("a", Dimension::Acceleration),
        ]
        .map(|(end, dimension)| (format!("{}.{end}", support.name), dimension))
    });
    let columns = nodes.chain(supports).chain(contacts).enumerate();
    columns
        .map(|(i, (name, dimension))| HistoryColumn {
            index: first + i,
            column: Column {
                name: name.into(),
                dimension,
                exact,
            },
        })
        .collect()
}
