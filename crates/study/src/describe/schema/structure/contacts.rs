//! The schema of contacts: what they are between, and each law with its own keys.

use super::rules::{along, any, between, described, none_of, one_of, pair_of_directions};
use crate::describe::schema::parts::several;
use crate::describe::schema::values::{names, number, refer};
use crate::structure::keys::{self, CONTACT, Keys, LISTS, PART};
use serde_json::{Map, Value as Json, json};
use slipgap_contact::contact::LAWS;
use slipgap_contact::contact::number::{Number, Usual};
use slipgap_contact::contact::offer::{Offered, Place};
use slipgap_problem::problem::structure::parts::contact_law::{NAMES, NUMBERS};

/// A contact. `part` is the name of the definition of a law in a list.
pub(super) fn contact(function: &Json, part: &str) -> Json {
    let mut one = with_law(&CONTACT, function, part);
    // Its normal force may be a contact.
    if let Some(forms) = one["properties"]["N"]["anyOf"].as_array_mut() {
        forms.push(refer("structure.contact"));
    }
    let nodes = one_of(&["between", "along", "pairs", "plane"]);
    one["dependencies"]["plane"] = none_of(&["gap"]);
    one["dependencies"]["directions"] = none_of(&["gap", "along", "pairs"]);
    if let Some(rules) = one["allOf"].as_array_mut() {
        rules.push(nodes);
    }
    one
}

/// A law in a list of laws.
pub(super) fn in_list(function: &Json, part: &str) -> Json {
    with_law(&PART, function, part)
}

/// A law or a list of laws, with the keys of the law only where the study names it.
fn with_law(keys: Keys, function: &Json, part: &str) -> Json {
    let mut one = described(keys, |key| value(key, function, part), &[]);
    let mut relations = vec!["law"];
    relations.extend(LISTS.map(|list| list.0));
    let laws = LAWS.iter().filter(|law| law.at(Place::Structure).is_some());
    let mut rules: Vec<Json> = laws.map(|law| of_law(law, keys)).collect();
    rules.push(one_of(&relations));
    one["allOf"] = rules.into();
    one["dependencies"] = json!({
        "nu_min": ["nu_rate"],
        "nu_rate": ["nu_min"],
        "pressure_exponent": ["N"],
    });
    one
}

/// The keys of a law, and the numbers that it needs.
fn of_law(law: &Offered, keys: Keys) -> Json {
    let numbers: Vec<&Number> = law.structure_numbers().collect();
    let is_of_law = |key: &str| NUMBERS.iter().any(|number| number.key == key);
    let of_all = keys.iter().map(|key| key.0).filter(|key| !is_of_law(key));
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
            _ if needed => needs.push(one_of(&forms)),
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

/// The value of a key.
fn value(key: &str, function: &Json, part: &str) -> Json {
    match key {
        "law" => {
            json!({ "anyOf": [names(NAMES.iter().copied()), { "type": "string" }] })
        }
        "between" => between(),
        "along" => along(),
        "pairs" => json!({ "type": "string" }),
        "plane" => {
            json!({ "type": "array", "minItems": 2, "maxItems": 2, "items": between() })
        }
        "directions" => pair_of_directions(),
        "N" => normal_force(function),
        "series" | "parallel" => {
            json!({ "type": "array", "minItems": 2, "items": refer(part) })
        }
        "table" => described(keys::LAW_TABLE, |_| super::numbers(), &["r", "S"]),
        _ => {
            let found = NUMBERS.iter().find(|number| number.key == key);
            found.map_or_else(any, |row| number(row.range))
        }
    }
}

/// A normal force: a number, a table, a weight, or the force of other contacts and springs.
fn normal_force(function: &Json) -> Json {
    let table = described(keys::NORMAL_TABLE, |_| super::numbers(), &["t", "N"]);
    let value = |key: &str| match key {
        "vertical" => function.clone(),
        _ => number(keys::range(keys::WEIGHT, key)),
    };
    let weight = described(keys::WEIGHT, value, &["weight", "vertical"]);
    let name = || several(json!({ "type": "string" }));
    let pressing = described(keys::PRESSING, |_| name(), &["contact"]);
    json!({ "anyOf": [any(), table, weight, pressing] })
}
