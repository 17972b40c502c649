//! Friction by two contacts in two directions, whose limit is a square in place of a disc.

use super::super::contacts::law_named;
use super::super::node::NodeRef;
use super::super::template::{Contact, Template};
use super::doubts::Doubt;
use crate::contact::ContactKind;
use crate::problem::Case;
use crate::solve::Warning;
use crate::system::structure::Direction;

/// What a contact joins, without its direction.
#[derive(Debug, PartialEq)]
enum Body<'a> {
    /// A mass by its name without the direction, and its place.
    Mass(&'a str, usize),
    /// A node of matrices.
    Node(usize, &'a str),
    Bar(usize),
    Support(&'a str),
}

/// Two friction contacts of different directions that join the same bodies.
pub fn of_one_body(template: &Template, case: &Case) -> Option<Doubt> {
    let rubs = |contact: &&Contact| {
        let law = law_named(contact.law.name(case));
        contact.row.is_none() && law.is_some_and(|law| law.kind == ContactKind::Friction)
    };
    let contacts: Vec<&Contact> = template.contacts.iter().filter(rubs).collect();
    let all: Vec<_> = contacts.iter().map(|own| bodies(template, own)).collect();
    for (i, first) in all.iter().enumerate() {
        for (j, second) in all.iter().enumerate().skip(i + 1) {
            let (Some((of, a)), Some((to, b))) = (first, second) else {
                continue;
            };
            let are_same = a.len() == b.len()
                && a.iter()
                    .all(|own| b.iter().any(|other| is_same(template, case, own, other)));
            if of != to && are_same {
                let text = format!(
                    "contacts {} in {} and {} in {}",
                    contacts[i].name,
                    of.name(),
                    contacts[j].name,
                    to.name()
                );
                return Some((Warning::FrictionDirections, text));
            }
        }
    }
    None
}

/// The direction of a contact, and its bodies without the ground; `None` for several directions.
fn bodies<'a>(template: &'a Template, contact: &'a Contact) -> Option<(Direction, Vec<Body<'a>>)> {
    let mut found = Vec::new();
    let mut directions = Vec::new();
    for term in &contact.along {
        let (direction, body) = match term.node.node {
            NodeRef::Ground => continue,
            NodeRef::Mass(place) => {
                let own = &template.masses[place];
                let name = own.name.split('.').next().unwrap_or_default();
                (own.direction, Body::Mass(name, place))
            }
            NodeRef::Left(bar) | NodeRef::Right(bar) | NodeRef::Inner(bar, _) => {
                (template.bars[bar].direction, Body::Bar(bar))
            }
            NodeRef::Dof(matrices, row) => {
                let dof = template.matrices[matrices].imported.dofs.rows().get(row)?;
                (dof.direction, Body::Node(matrices, &dof.node))
            }
            NodeRef::Support(place) => {
                let own = &template.supports[place];
                (own.direction, Body::Support(&own.name))
            }
        };
        directions.push(direction);
        found.push(body);
    }
    let first = *directions.first()?;
    directions
        .iter()
        .all(|own| *own == first)
        .then_some((first, found))
}

/// Masses of one name are one body; so may be two masses of the same size that move in different directions.
fn is_same(template: &Template, case: &Case, first: &Body, second: &Body) -> bool {
    match (first, second) {
        (Body::Mass(a, i), Body::Mass(b, j)) => {
            let mass = |place: usize| template.masses[place].mass.value(case);
            let are_whole = [*i, *j]
                .iter()
                .all(|place| !template.masses[*place].name.contains('.'));
            a == b || are_whole && mass(*i).is_ok() && mass(*i) == mass(*j)
        }
        (first, second) => first == second,
    }
}
