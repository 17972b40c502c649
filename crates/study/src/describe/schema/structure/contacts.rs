//! The schema of contacts: what they are between, and each law with its own keys.

use crate::describe::schema::fields::{Shared, conjunction, each, object};
use crate::source::field::{Keys, Rule};
use crate::structure::keys::{CONTACT, PART};
use serde_json::{Map, Value as Json, json};
use slipgap_contact::contact::LAWS;
use slipgap_contact::contact::number::{Number, Usual};
use slipgap_contact::contact::offer::{Offered, Place};
use slipgap_problem::problem::structure::parts::contact_law::NUMBERS;

/// A contact.
pub(super) fn contact(shared: Shared) -> Json {
    let nodes = Rule::One(&["between", "along", "pairs", "plane"], &[]);
    let mut schema = with_law(&CONTACT, Some(nodes), shared);
    // Its normal force may be a contact.
    if let Some(forms) = schema["properties"]["N"]["anyOf"].as_array_mut() {
        forms.push(shared("contact"));
    }
    schema
}

/// A law in a list of laws.
pub(super) fn in_list(shared: Shared) -> Json {
    with_law(&PART, None, shared)
}

/// A law or a list of laws, with the keys of the law only where the study names it, and another rule.
fn with_law(keys: &Keys, more: Option<Rule>, shared: Shared) -> Json {
    let relation = Rule::One(&["law", "series", "parallel"], &[]);
    let of_structures = LAWS.iter().filter(|law| law.at(Place::Structure).is_some());
    let laws = of_structures.map(|law| of_law(law, keys));
    let rules = [relation].into_iter().chain(more);
    let mut schema = object(keys, shared);
    schema["allOf"] = laws.chain(rules.map(|rule| conjunction(&[rule]))).collect();
    schema
}

/// The keys of a law, and the numbers that it needs.
fn of_law(law: &Offered, keys: &Keys) -> Json {
    let numbers: Vec<&Number> = law.structure_numbers().collect();
    let is_of_law = |key: &str| NUMBERS.iter().any(|number| number.key == key);
    let of_all = keys.names().into_iter().filter(|key| !is_of_law(key));
    let of_law = numbers.iter().map(|number| number.key);
    let allowed: Vec<&str> = of_all.chain(of_law).chain(["//"]).collect();
    let mut needs: Vec<Json> = Vec::new();
    let has = |key: &str| numbers.iter().any(|number| number.key == key);
    for number in &numbers {
        let in_place_of = |other: &&&Number| other.instead_of == Some(number.key);
        let mut forms = vec![number.key];
        forms.extend(numbers.iter().filter(in_place_of).map(|other| other.key));
        let needed = number.usual == Usual::Needed && number.instead_of.is_none_or(|key| !has(key));
        match number.key {
            // The limit of friction: a number, or a coefficient and a normal force.
            "limit" => needs.push(json!({ "anyOf": [
                { "required": ["limit"], "not": { "anyOf": [
                    { "required": ["nu"] },
                    { "required": ["N"] },
                ] } },
                { "required": ["nu", "N"], "not": { "required": ["limit"] } },
            ] })),
            "nu" | "N" => {}
            _ if needed => needs.push(json!({ "oneOf": each(&forms, &[]) })),
            _ if forms.len() > 1 => needs.push(json!({ "not": { "required": forms } })),
            _ => {}
        }
    }
    let mut then = Map::from_iter([("propertyNames".to_owned(), json!({ "enum": allowed }))]);
    if !needs.is_empty() {
        then.insert("allOf".into(), needs.into());
    }
    json!({
        "if": { "properties": { "law": { "const": law.offer.name } }, "required": ["law"] },
        "then": then,
    })
}
