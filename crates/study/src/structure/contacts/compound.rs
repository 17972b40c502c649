//! Laws in series, with nodes without mass between them, and laws in parallel.

use super::{Relation, relation};
use crate::source::faults::Faults;
use crate::source::object::Object;
use crate::source::tree::{Member, Node, Tree};
use crate::structure::keys::{LISTS, PART};
use crate::structure::parts::Part;
use crate::structure::reader::{Reader, open};
use slipgap_solver::problem::parameter::Range;
use slipgap_solver::problem::structure::amount::{Amount, Source};
use slipgap_solver::problem::structure::node::{NodeName, NodeRef};
use slipgap_solver::problem::structure::template::{Contact, Mass, Term};
use slipgap_solver::system::structure::Direction;

/// The list of laws of a contact that has one.
pub(super) fn list<'a>(object: &Object<'a>) -> Option<&'a Member> {
    let mut members = object.members.iter().copied();
    members.find(|member| LISTS.iter().any(|list| list.0 == member.key))
}

/// The nodes between laws in series, as masses of 0: NAME.node1, NAME.node2, ..
pub(in crate::structure) fn inner_nodes(parts: &[Part]) -> Vec<Mass> {
    let mut nodes = Vec::new();
    for (name, node, path) in parts {
        let Tree::Object(members) = &node.tree else {
            continue;
        };
        let series = members.iter().find(|member| member.key == LISTS[0].0);
        let Some(Tree::List(items)) = series.map(|member| &member.node.tree) else {
            continue;
        };
        nodes.extend((1..items.len()).map(|i| Mass {
            name: format!("{name}.node{i}"),
            mass: number(0.0, node.at, path),
            direction: Direction::X,
        }));
    }
    nodes
}

/// The contacts NAME.1, NAME.2, .. of a list of laws.
pub(super) fn contacts(
    (name, node, path): (&str, &Node, &str),
    object: &Object,
    list: &Member,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Vec<Contact>> {
    let allowed = ["between", "along", &list.key];
    let mut others = object.members.iter();
    if let Some(other) = others.find(|own| !allowed.contains(&own.key.as_str())) {
        let message = format!(
            "a contact with {} has no {}: the laws of the list have their own",
            list.key, other.key
        );
        faults.add(other.node.at, &object.path(&other.key), message);
        return None;
    }
    let list_path = object.path(&list.key);
    let relations: Vec<Option<Relation>> = match &list.node.tree {
        Tree::List(items) if items.len() > 1 => {
            let items = items.iter().enumerate();
            let items = items.map(|(i, item)| {
                let own = open(item, &format!("{list_path}[{i}]"), &PART, faults)?;
                relation(&own, reader, faults)
            });
            items.collect()
        }
        _ => {
            faults.must_be(&list.node, &list_path, "a list of two laws or more");
            return None;
        }
    };
    let along = reader.along(object, "a contact", faults);
    let relations: Vec<Relation> = relations.into_iter().collect::<Option<_>>()?;
    let along = along?;
    let places = match list.key == LISTS[0].0 {
        true => in_series(name, &along, relations.len(), (node.at, path), reader)?,
        false => vec![along; relations.len()],
    };
    let contacts = relations.into_iter().zip(places).enumerate();
    let contact = |(i, (relation, along)): (usize, (Relation, Vec<Term>))| {
        relation.between(
            format!("{name}.{}", i + 1),
            (node.at, path.to_owned()),
            along,
        )
    };
    Some(contacts.map(contact).collect())
}

/// The nodes of each of several laws in series: from node I over the inner nodes to node J. With other factors, the displacements of the
/// inner nodes are the sums of r - gap of the laws before them.
fn in_series(
    name: &str,
    along: &[Term],
    count: usize,
    (at, path): (usize, &str),
    reader: &Reader,
) -> Option<Vec<Vec<Term>>> {
    let term = |node: NodeRef, factor: f64| Term {
        node: NodeName {
            node,
            at,
            path: path.to_owned(),
        },
        factor: number(factor, at, path),
        tied: false,
    };
    let inner: Option<Vec<NodeRef>> = (1..count)
        .map(|i| reader.names.node(&format!("{name}.node{i}")))
        .collect();
    let inner = inner?;
    let is =
        |term: &Term, factor: f64| matches!(term.factor.source, Source::Number(x) if x == factor);
    let (first, last) = match along {
        [i, j] if is(i, -1.0) && is(j, 1.0) => (vec![i.clone()], vec![j.clone()]),
        all => (Vec::new(), all.to_vec()),
    };
    let mut places = Vec::with_capacity(count);
    for place in 0..count {
        let mut own = match place.checked_sub(1) {
            None => first.clone(),
            Some(before) => vec![term(inner[before], -1.0)],
        };
        match inner.get(place) {
            Some(next) => own.push(term(*next, 1.0)),
            None => own.extend(last.clone()),
        }
        places.push(own);
    }
    Some(places)
}

fn number(x: f64, at: usize, path: &str) -> Amount {
    Amount {
        source: Source::Number(x),
        range: Range::Any,
        at,
        path: path.to_owned(),
    }
}
