//! The columns of a history: every node and every contact of a case, and the channels of figures that are more.

use super::schema::Drawn;
use crate::problem::Case;
use crate::problem::HistoryColumn;
use crate::problem::numbers::unit::Dimension;
use crate::problem::structure::channels::channel::{Number, Quantity, Term};
use crate::problem::structure::given::node::NodeRef;
use crate::problem::structure::parts::template::Template;
use crate::problem::table::schema::Channel as Column;
use crate::system::structure::{PlaneRow, Structure};

/// The quantities of contacts.
const OF_CONTACTS: [(Quantity, &str); 3] = [
    (Quantity::Displacement, "r"),
    (Quantity::Velocity, "rdot"),
    (Quantity::Force, "S"),
];

/// u and v of every node, u, v and a of every support that moves, r, rdot and S of every contact; behind both directions of a contact in
/// a plane their lengths.
pub fn all_numbers(structure: &Structure, template: &Template) -> Vec<Number> {
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
    let contacts = template.contacts.iter().enumerate();
    let of_contacts = contacts.flat_map(|(c, contact)| {
        let numbers = OF_CONTACTS.map(|(quantity, _)| Number::Contact(c, quantity));
        let lengths = (contact.row == Some(PlaneRow::Second))
            .then(|| OF_CONTACTS.map(|(quantity, _)| Number::Contact(c - 1, quantity.in_plane())));
        numbers.into_iter().chain(lengths.into_iter().flatten())
    });
    of_nodes.chain(of_supports).chain(of_contacts).collect()
}

/// The columns of [`all_numbers`], of which the first is channel `first` of the history.
pub fn of(
    structure: &Structure,
    template: &Template,
    first: usize,
    exact: bool,
) -> Vec<HistoryColumn> {
    let nodes = structure.nodes.iter().flat_map(|node| {
        [("u", Dimension::Length), ("v", Dimension::Velocity)]
            .map(|(end, dimension)| (format!("{}.{end}", node.name), dimension))
    });
    let dimensions = [Dimension::Length, Dimension::Velocity, Dimension::Force];
    let contacts = template.contacts.iter().flat_map(|contact| {
        // disc.1 and disc.2 have disc.r.1, disc.r.2 and disc.r.
        let (name, direction) = match contact.row.and(contact.name.rsplit_once('.')) {
            Some((name, direction)) => (name, format!(".{direction}")),
            None => (contact.name.as_str(), String::new()),
        };
        let columns = |direction: String| {
            let names = OF_CONTACTS.map(|(_, end)| format!("{name}.{end}{direction}"));
            names.into_iter().zip(dimensions)
        };
        let lengths = (contact.row == Some(PlaneRow::Second)).then(|| columns(String::new()));
        let in_direction = columns(direction);
        in_direction
            .chain(lengths.into_iter().flatten())
            .collect::<Vec<_>>()
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

/// The columns of drawn channels that the motion of nodes and contacts does not have.
pub fn of_drawn(drawn: &[Drawn], exact: bool) -> impl Iterator<Item = HistoryColumn> {
    let numbered = drawn.iter().enumerate();
    let more = numbered.filter(|(_, drawn)| drawn.channel.is_derived() && !drawn.error);
    more.map(move |(index, drawn)| HistoryColumn {
        index,
        column: Column {
            name: drawn.name.clone().into(),
            dimension: drawn.channel.dimension(),
            exact: exact && !drawn.channel.has_energy(),
        },
    })
}

/// Why a channel is not there in a case: the acceleration of a node without mass. `None` for others.
pub fn massless(term: Term, template: &Template, case: &Case) -> Option<String> {
    let (Term::Acceleration(node) | Term::Absolute(node)) = term else {
        return None;
    };
    let reduced = |node| match node {
        NodeRef::Dof(matrices, _) => template.matrices[matrices].reduce.is_some(),
        NodeRef::Ground
        | NodeRef::Mass(_)
        | NodeRef::Left(_)
        | NodeRef::Right(_)
        | NodeRef::Inner(..)
        | NodeRef::Support(_) => false,
    };
    // Reduced matrices have a mass at every dof that is kept.
    (!reduced(node) && template.is_massless(node, case))
        .then(|| "a node without mass has no acceleration of its own".to_owned())
}
