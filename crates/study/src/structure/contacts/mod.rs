//! Contacts: laws, gaps, stiffnesses and friction limits.

mod compound;
pub(in crate::structure) mod plane;
mod pressing;

pub(in crate::structure) use compound::inner_nodes;
pub(in crate::structure) use pressing::with_pressing;

use crate::source::faults::Faults;
use crate::source::object::Object;
use crate::source::tree::{Node, Tree};
use crate::structure::keys::{CONTACT, LAW_TABLE, NORMAL_TABLE, PRESSING, WEIGHT};
use crate::structure::motions::loads::scaled;
use crate::structure::motions::table::table;
use crate::structure::reading::files;
use crate::structure::reading::reader::Part;
use crate::structure::reading::reader::{Reader, open};
use crate::value::{name, text};
use slipgap_problem::problem::numbers::parameter::Range;
use slipgap_problem::problem::structure::given::amount::{self, Amount};
use slipgap_problem::problem::structure::given::node::{NodeName, NodeRef};
use slipgap_problem::problem::structure::given::source::{Kind, Source};
use slipgap_problem::problem::structure::parts::contact_law::{NAMES, NUMBERS, law_named};
use slipgap_problem::problem::structure::{
    given::chosen::Chosen,
    parts::{
        along::Term,
        contact::{Contact, Normal},
        template::Spring,
    },
};
use slipgap_system::system::import::{self, ImportFault, Pair};
use std::sync::Arc;

/// Most bytes of a file of pairs.
const LARGEST: u64 = 64 << 20;

/// The contacts, of which normal forces may name these springs. One with `pairs` is a contact for each line of its file.
pub(in crate::structure) fn contacts(
    parts: &[Part],
    springs: &[Spring],
    reader: &Reader,
    faults: &mut Faults,
) -> Vec<Contact> {
    let one = |(name, node, path): &Part| contact(name, node, path, reader, faults);
    let mut contacts: Vec<Contact> = parts.iter().filter_map(one).flatten().collect();
    pressing::find(&mut contacts, springs, faults);
    contacts
}

fn contact(
    name: &str,
    node: &Node,
    path: &str,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Vec<Contact>> {
    let object = open(node, path, &CONTACT, faults)?;
    if let Some(list) = compound::list(&object) {
        return compound::contacts((name, node, path), &object, list, reader, faults);
    }
    let relation = relation(&object, Some(name), reader, faults);
    let origin = (node.at, path.to_owned());
    if plane::is_given(&object) {
        let places = plane::places(name, &object, reader, faults);
        let (places, relation) = (places?, relation?);
        let one = |(name, along, row)| Contact {
            row: Some(row),
            ..relation.clone().between(name, origin.clone(), along)
        };
        return Some(places.into_iter().map(one).collect());
    }
    let places = match object.get("pairs") {
        Some(node) => pairs(name, node, &object, reader, faults),
        None => {
            let along = reader.along(&object, "a contact", faults);
            along.map(|along| vec![(name.to_owned(), along)])
        }
    };
    let (places, relation) = (places?, relation?);
    let one = |(name, along)| relation.clone().between(name, origin.clone(), along);
    Some(places.into_iter().map(one).collect())
}

/// What acts between the nodes of a contact.
#[derive(Clone)]
struct Relation {
    law: Chosen,
    gap: Option<Amount>,
    normal: Option<Normal>,
    table: Option<[Vec<Amount>; 2]>,
    numbers: Vec<(&'static str, Amount)>,
}

impl Relation {
    fn between(self, name: String, origin: (usize, String), along: Vec<Term>) -> Contact {
        Contact {
            name,
            place: origin,
            along,
            row: None,
            law: self.law,
            gap: self.gap,
            normal: self.normal,
            table: self.table,
            numbers: self.numbers,
        }
    }
}

/// The law of an object with its gap and numbers; the object is the contact of this name, or in a list.
fn relation(
    object: &Object,
    name: Option<&str>,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Relation> {
    let law = law(object, reader, faults);
    if let Some(Chosen::Name(law)) = law {
        unsuitable(object, law, faults);
    }
    let before = faults.count();
    let mut optional = |key: &str, range| reader.optional(object, key, range, faults);
    let gap = optional("gap", Range::Any);
    // The normal force and the table are more than a number.
    let numbers = NUMBERS
        .iter()
        .filter(|number| !["N", "table"].contains(&number.key));
    let given =
        numbers.filter_map(|number| Some((number.key, optional(number.key, number.range)?)));
    let numbers: Vec<_> = given.collect();
    let normal = object
        .get("N")
        .and_then(|node| normal(node, &object.path("N"), name, reader, faults));
    let points = object.get("table").and_then(|node| {
        table(
            node,
            &object.path("table"),
            (LAW_TABLE, ["r", "S"]),
            reader,
            faults,
        )
    });
    let relation = Relation {
        law: law?,
        gap,
        normal,
        table: points,
        numbers,
    };
    (faults.count() == before).then_some(relation)
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
            let of_dof = |(name, factor): (String, f64)| {
                let found = reader.names.nodes(&name).ok_or_else(|| ImportFault {
                    line: pair.line,
                    message: reader.no_node(&name),
                });
                let tied = reader.names.tied(&name, &amount(factor)).map(Arc::new);
                let term = |(weight, found): (f64, NodeRef)| Term {
                    node: NodeName {
                        node: found,
                        at: node.at,
                        path: path.clone(),
                    },
                    factor: amount(factor * weight),
                    tied: tied.clone(),
                };
                Ok(found?.into_iter().map(term).collect::<Vec<Term>>())
            };
            let terms = pair
                .along
                .into_iter()
                .map(of_dof)
                .collect::<Result<Vec<_>, ImportFault>>()?;
            Ok((format!("{face}.{}", pair.name), terms.concat()))
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
    let Some(offered) = law_named(law) else {
        return;
    };
    let keys: Vec<&str> = offered
        .structure_numbers()
        .map(|number| number.key)
        .collect();
    for member in &object.members {
        let key = member.key.as_str();
        let of_all = [
            "law",
            "between",
            "along",
            "pairs",
            "gap",
            "plane",
            "directions",
        ];
        if !of_all.contains(&key) && !keys.contains(&key) {
            let message = format!(
                "a contact with law {law} has no {key}; it has {}",
                keys.join(", ")
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
        .filter_map(|number| Some((number.key, number.instead_of?)));
    for (second, first) in instead {
        if let (Some(node), Some(_)) = (has(second), has(first)) {
            let message = format!("give {first} or {second}, not both");
            faults.add(node.at, &object.path(second), message);
        }
    }
}

fn normal(
    node: &Node,
    path: &str,
    name: Option<&str>,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Normal> {
    let Tree::Object(members) = &node.tree else {
        let force = reader.amount(node, path, Range::Any, faults)?;
        return Some(Normal::Constant(force));
    };
    if pressing::is_contact(node) {
        return pressing::by_contact(name, (node.at, path), faults).map(Normal::Parts);
    }
    if members.iter().any(|member| member.key == PRESSING[0].0) {
        return pressing::parts(node, path, faults).map(Normal::Parts);
    }
    if members.iter().any(|member| member.key == "weight") {
        let object = open(node, path, WEIGHT, faults)?;
        let weight = reader.needed(&object, WEIGHT, "weight", faults);
        let given = object.need("vertical", WEIGHT[1].1, faults)?;
        let vertical = scaled(given, &object.path("vertical"), reader, faults);
        return Some(Normal::Weight {
            weight: weight?,
            vertical: vertical?,
        });
    }
    let [t, f] = table(node, path, (NORMAL_TABLE, ["t", "N"]), reader, faults)?;
    let source = Source::new(Kind::Table { t, f }, (node.at, path.to_owned()));
    Some(Normal::Table(source))
}
