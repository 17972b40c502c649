//! Contacts: laws, gaps, stiffnesses and friction limits.

use super::keys::{CONTACT, NORMAL_TABLE, WEIGHT};
use super::loads::{scaled, table};
use super::parts::Part;
use super::reader::{Reader, open};
use crate::source::faults::Faults;
use crate::source::object::Object;
use crate::source::tree::{Node, Tree};
use crate::value::name;
use slipgap_solver::problem::parameter::Range;
use slipgap_solver::problem::structure::contacts::{NAMES, NUMBERS, law_named};
use slipgap_solver::problem::structure::loads::{Kind, Source};
use slipgap_solver::problem::structure::template::{Chosen, Contact, Normal};

/// The contacts.
pub(super) fn contacts(parts: &[Part], reader: &Reader, faults: &mut Faults) -> Vec<Contact> {
    let one = |(name, node, path): &Part| contact(name, node, path, reader, faults);
    parts.iter().filter_map(one).collect()
}

fn contact(
    name: &str,
    node: &Node,
    path: &str,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Contact> {
    let object = open(node, path, &CONTACT, faults)?;
    let law = law(&object, reader, faults);
    let between = reader.between(&object, "a contact", faults);
    if let Some(Chosen::Name(law)) = law {
        unsuitable(&object, law, faults);
    }
    let before = faults.count();
    let mut optional = |key: &str, range| reader.optional(&object, key, range, faults);
    let gap = optional("gap", Range::Any);
    // The normal force is more than a number.
    let numbers = NUMBERS.iter().filter(|number| number.key != "N");
    let given = numbers.filter_map(|own| Some((own.key, optional(own.key, own.range)?)));
    let numbers = given.collect();
    let normal = object
        .get("N")
        .and_then(|node| normal(node, &object.path("N"), reader, faults));
    let complete = faults.count() == before;
    Some(Contact {
        name: name.to_owned(),
        place: (node.at, path.to_owned()),
        between: between?,
        law: law?,
        gap,
        normal,
        numbers,
    })
    .filter(|_| complete)
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
        if !["law", "between", "gap"].contains(&key) && !own.contains(&key) {
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
    let [t, f] = table(node, path, (NORMAL_TABLE, "N"), reader, faults)?;
    let source = Source::new(Kind::Table { t, f }, (node.at, path.to_owned()));
    Some(Normal::Table(source))
}
