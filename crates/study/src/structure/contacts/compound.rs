//! Laws in series, with nodes without mass between them, and laws in parallel; one list may hold the other.

use super::{Relation, relation};
use crate::source::faults::Faults;
use crate::source::object::Object;
use crate::source::tree::{Member, Node, Tree};
use crate::structure::keys::{LISTS, PART};
use crate::structure::reading::reader::Part;
use crate::structure::reading::reader::{Reader, open};
use slipgap_problem::problem::numbers::parameter::Range;
use slipgap_problem::problem::structure::given::amount::{Amount, Source};
use slipgap_problem::problem::structure::given::node::{NodeName, NodeRef};
use slipgap_problem::problem::structure::parts::{along::Term, contact::Contact, template::Mass};
use slipgap_system::system::structure::Direction;

/// A law of a list, or a list in it.
enum Item {
    Law(Box<Relation>),
    List(Laws),
}

/// A list of laws.
struct Laws {
    is_series: bool,
    items: Vec<Item>,
}

/// Where a contact is in its file.
type Place<'a> = (usize, &'a str);

/// The list of laws of a contact that has one.
pub(super) fn list<'a>(object: &Object<'a>) -> Option<&'a Member> {
    let mut members = object.members.iter().copied();
    members.find(|member| is_list(member))
}

fn is_list(member: &Member) -> bool {
    LISTS.iter().any(|list| list.0 == member.key)
}

fn is_series(list: &Member) -> bool {
    list.key == LISTS[0].0
}

/// The nodes between laws in series, as masses of 0: NAME.node1, NAME.node2, ..
pub(in crate::structure) fn inner_nodes(parts: &[Part]) -> Vec<Mass> {
    let mut nodes = Vec::new();
    for (name, node, path) in parts {
        add_inner_nodes(name, node, (node.at, path), &mut nodes);
    }
    nodes
}

fn add_inner_nodes(name: &str, node: &Node, (at, path): Place, nodes: &mut Vec<Mass>) {
    let Tree::Object(members) = &node.tree else {
        return;
    };
    for list in members.iter().filter(|member| is_list(member)) {
        let Tree::List(items) = &list.node.tree else {
            continue;
        };
        if is_series(list) {
            nodes.extend((1..items.len()).map(|i| Mass {
                name: inner_node(name, i),
                mass: number(0.0, at, path),
                direction: Direction::X,
            }));
        }
        for (i, item) in items.iter().enumerate() {
            add_inner_nodes(&numbered(name, i), item, (at, path), nodes);
        }
    }
}

fn inner_node(name: &str, number: usize) -> String {
    format!("{name}.node{number}")
}

/// The name of an item of a list.
fn numbered(name: &str, index: usize) -> String {
    format!("{name}.{}", index + 1)
}

/// The contacts NAME.1, NAME.2, .. of a list of laws; those of a list in it are NAME.1.1, NAME.1.2, ..
pub(super) fn contacts(
    (name, node, path): (&str, &Node, &str),
    object: &Object,
    list: &Member,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Vec<Contact>> {
    alone(object, list, &["between", "along", &list.key], faults)?;
    let laws = laws(list, &object.path(&list.key), &[], reader, faults);
    let along = reader.along(object, "a contact", faults);
    let (laws, along) = (laws?, along?);
    let mut contacts = Vec::new();
    add(laws, name, &along, (node.at, path), reader, &mut contacts)?;
    Some(contacts)
}

/// Whether an object with a list has no other keys.
fn alone(object: &Object, list: &Member, allowed: &[&str], faults: &mut Faults) -> Option<()> {
    let mut others = object.members.iter();
    let Some(other) = others.find(|member| !allowed.contains(&member.key.as_str())) else {
        return Some(());
    };
    let message = format!(
        "a contact with {} has no {}: the laws of the list have their own",
        list.key, other.key
    );
    faults.add(other.node.at, &object.path(&other.key), message);
    None
}

/// The laws of a list within these lists.
fn laws(
    list: &Member,
    path: &str,
    within: &[bool],
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Laws> {
    let items = match &list.node.tree {
        Tree::List(items) if items.len() > 1 => items,
        Tree::Object(_)
        | Tree::List(_)
        | Tree::Text(_)
        | Tree::Number(_)
        | Tree::Bool(_)
        | Tree::Null => {
            faults.must_be(&list.node, path, "a list of two laws or more");
            return None;
        }
    };
    let is_series = is_series(list);
    let within = [within, &[is_series]].concat();
    let decoded = items.iter().enumerate().map(|(i, item)| {
        let part = open(item, &format!("{path}[{i}]"), &PART, faults)?;
        match self::list(&part) {
            None => Some(Item::Law(Box::new(relation(&part, None, reader, faults)?))),
            Some(inner) => {
                alone(&part, inner, &[&inner.key], faults)?;
                let inner_path = part.path(&inner.key);
                if let Some(why) = misplaced(&within, inner) {
                    faults.add(inner.node.at, &inner_path, why.to_owned());
                    return None;
                }
                let inner = laws(inner, &inner_path, &within, reader, faults)?;
                Some(Item::List(inner))
            }
        }
    });
    let read: Vec<Option<Item>> = decoded.collect();
    let items = read.into_iter().collect::<Option<_>>()?;
    Some(Laws { is_series, items })
}

/// Why a list may not be within these, series or not.
fn misplaced(within: &[bool], inner: &Member) -> Option<&'static str> {
    match within {
        [.., last] if *last == is_series(inner) => {
            Some("a list in a list of its kind: write its laws into the outer one")
        }
        [.., true, false] => Some("parallel in series has laws only"),
        _ => None,
    }
}

/// Adds the contacts of a list between these nodes.
fn add(
    laws: Laws,
    name: &str,
    along: &[Term],
    origin: Place,
    reader: &Reader,
    contacts: &mut Vec<Contact>,
) -> Option<()> {
    let count = laws.items.len();
    let places = match laws.is_series {
        true => in_series(name, along, count, origin, reader)?,
        false => vec![along.to_vec(); count],
    };
    for (i, (item, along)) in laws.items.into_iter().zip(places).enumerate() {
        let name = numbered(name, i);
        match item {
            Item::Law(relation) => {
                contacts.push(relation.between(name, (origin.0, origin.1.to_owned()), along));
            }
            Item::List(laws) => add(laws, &name, &along, origin, reader, contacts)?,
        }
    }
    Some(())
}

/// The nodes of each of several laws in series: from node I over the inner nodes to node J. With other factors, the displacements of the
/// inner nodes are the sums of r - gap of the laws before them.
fn in_series(
    name: &str,
    along: &[Term],
    count: usize,
    (at, path): Place,
    reader: &Reader,
) -> Option<Vec<Vec<Term>>> {
    let term = |node: NodeRef, factor: f64| Term {
        node: NodeName {
            node,
            at,
            path: path.to_owned(),
        },
        factor: number(factor, at, path),
        tied: None,
    };
    let inner = (1..count)
        .map(|i| reader.names.node(&inner_node(name, i)))
        .collect::<Option<Vec<NodeRef>>>()?;
    let is =
        |term: &Term, factor: f64| matches!(term.factor.source, Source::Number(x) if x == factor);
    let (first, last) = match along {
        [i, j] if is(i, -1.0) && is(j, 1.0) => (vec![i.clone()], vec![j.clone()]),
        several => (Vec::new(), several.to_vec()),
    };
    let mut places = Vec::with_capacity(count);
    for index in 0..count {
        let mut ends = match index.checked_sub(1) {
            None => first.clone(),
            Some(before) => vec![term(inner[before], -1.0)],
        };
        match inner.get(index) {
            Some(next) => ends.push(term(*next, 1.0)),
            None => ends.extend(last.clone()),
        }
        places.push(ends);
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
