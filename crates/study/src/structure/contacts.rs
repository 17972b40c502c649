//! Contacts: laws, gaps, stiffnesses and friction limits.

use super::files;
use super::keys::{CONTACT, NORMAL_TABLE, WEIGHT};
use super::loads::{scaled, table};
use super::parts::Part;
use super::reader::{Reader, open};
use crate::source::faults::Faults;
use crate::source::object::Object;
use crate::source::tree::{Node, Tree};
use crate::value::{name, text};
use slipgap_solver::problem::parameter::Range;
use slipgap_solver::problem::structure::amount::{self, Amount};
use slipgap_solver::problem::structure::contacts::{NAMES, NUMBERS, law_named};
use slipgap_solver::problem::structure::loads::{Kind, Source};
use slipgap_solver::problem::structure::node::NodeName;
use slipgap_solver::problem::structure::template::{Chosen, Contact, Normal, Term};
use slipgap_solver::system::import::{self, ImportFault, Pair};

/// Most bytes of a file of pairs.
const LARGEST: u64 = 64 << 20;

/// The contacts. One with `pairs` is a contact for each line of its file.
pub(super) fn contacts(parts: &[Part], reader: &Reader, faults: &mut Faults) -> Vec<Contact> {
    let one = |(name, node, path): &Part| contact(name, node, path, reader, faults);
    parts.iter().filter_map(one).flatten().collect()
}

fn contact(
    name: &str,
    node: &Node,
    path: &str,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Vec<Contact>> {
    let object = open(node, path, &CONTACT, faults)?;
    let law = law(&object, reader, faults);
    let places = match object.get("pairs") {
        Some(node) => pairs(name, node, &object, reader, faults),
        None => {
            let along = reader.along(&object, "a contact", faults);
            along.map(|along| vec![(name.to_owned(), along)])
        }
    };
    if let Some(Chosen::Name(law)) = law {
        unsuitable(&object, law, faults);
    }
    let before = faults.count();
    let mut optional = |key: &str, range| reader.optional(&object, key, range, faults);
    let gap = optional("gap", Range::Any);
    // The normal force is more than a number.
    let numbers = NUMBERS.iter().filter(|number| number.key != "N");
    let given = numbers.filter_map(|own| Some((own.key, optional(own.key, own.range)?)));
    let numbers: Vec<_> = given.collect();
    let normal = object
        .get("N")
        .and_then(|node| normal(node, &object.path("N"), reader, faults));
    let complete = faults.count() == before;
    let (places, law) = (places?, law?);
    let one = |(name, along)| Contact {
        name,
        place: (node.at, path.to_owned()),
        along,
        law,
        gap: gap.clone(),
        normal: normal.clone(),
        numbers: numbers.clone(),
    };
    complete.then(|| places.into_iter().map(one).collect())
}

/// The names of the contacts of a face, and the nodes of each with their factors.
fn pairs(
    face: &str,
    node: &Node,
    object: &Object,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Vec<(String, Vec<Term>)>> {
    let path = object.path("pairs");
    if let Some(other) = object.get("between").or(object.get("along")) {
        faults.add(
            other.at,
            &path,
            "give pairs, between or along, and no other of them",
        );
        return None;
    }
    let amount = |factor: f64| Amount {
        source: amount::Source::Number(factor),
        range: Range::Any,
        at: node.at,
        path: path.clone(),
    };
    let file = text(node, &path, faults)?;
    files::read(&file, (node, &path), LARGEST, reader, faults, |bytes| {
        let pairs = import::pairs(bytes)?.into_iter();
        let contact = |pair: Pair| {
            let term = |(name, factor): (String, f64)| {
                let found = reader.names.node(&name).ok_or_else(|| ImportFault {
                    line: pair.line,
                    message: reader.no_node(&name),
                });
                Ok(Term {
                    node: NodeName {
                        node: found?,
                        at: node.at,
                        path: path.clone(),
                    },
                    factor: amount(factor),
                })
            };
            let terms = pair
                .along
                .into_iter()
                .map(term)
                .collect::<Result<_, ImportFault>>()?;
            Ok((format!("{face}.{}", pair.name), terms))
        };
        pairs.map(contact).collect()
    })
}

/// The law by its name, or the parameter that chooses it.
fn law(object: &Object, reader: &Reader, faults: &mut Faults) -> Option<Chosen> {
    let names: Vec<&str> = NAMES.iter().map(|law| law.0).collect();
    let node = object.need("law", &format!("one of {}", names.join(", ")), faults)?;
    if let Tree::Text(text) = &node.tree
        && let Some((row, _)) = reader.choices(text)
    {
        return Some(Chosen::Parameter(row));
    }
    let law = name(node, &object.path("law"), "law", &names, faults)?;
    Some(Chosen::Name(NAMES[law].0))
}

/// Reports keys of other laws.
fn unsuitable(object: &Object, law: &str, faults: &mut Faults) {
    let Some(own) = law_named(law) else {
        return;
    };
    let own: Vec<&str> = own.structure_numbers().map(|number| number.key).collect();
    for member in &object.members {
        let key = member.key.as_str();
        if !["law", "between", "along", "pairs", "gap"].contains(&key) && !own.contains(&key) {
            let message = format!(
                "a contact with law {law} has no {key}; it has {}",
                own.join(", ")
            );
            faults.add(member.node.at, &object.path(key), message);
        }
    }
    let has = |key| object.get(key);
    if let (Some(limit), Some(_)) = (has("limit"), has("nu").or(has("N"))) {
        let message = "give limit, or nu and N, not both";
        faults.add(limit.at, &object.path("limit"), message);
    }
    let instead = NUMBERS
        .iter()
        .filter_map(|own| Some((own.key, own.instead_of?)));
    for (second, first) in instead {
        if let (Some(node), Some(_)) = (has(second), has(first)) {
            let message = format!("give {first} or {second}, not both");
            faults.add(node.at, &object.path(second), message);
        }
    }
}

fn normal(node: &Node, path: &str, reader: &Reader, faults: &mut Faults) -> Option<Normal> {
    let Tree::Object(members) = &node.tree else {
        let force = reader.amount(node, path, Range::Any, faults)?;
        return Some(Normal::Constant(force));
    };
    if members.iter().any(|member| member.key == "weight") {
        let object = open(node, path, WEIGHT, faults)?;
        let weight = reader.needed(&object, WEIGHT, "weight", Range::Positive, faults);
        let vertical = object.need("vertical", WEIGHT[1].1, faults)?;
        let vertical = scaled(vertical, &object.path("vertical"), reader, faults);
        return Some(Normal::Weight {
            weight: weight?,
            vertical: vertical?,
        });
    }
    let [t, f] = table(node, path, (NORMAL_TABLE, ["t", "N"]), reader, faults)?;
    let source = Source::new(Kind::Table { t, f }, (node.at, path.to_owned()));
    Some(Normal::Table(source))
}
