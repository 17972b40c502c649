//! Rules that parts of a structure share.

use crate::describe::schema::values::{number, object};
use crate::structure::keys::{self, Keys};
use serde_json::{Map, Value as Json, json};
use slipgap_problem::problem::numbers::parameter::Range;
use slipgap_system::system::structure::Direction;

/// An object with these keys; `value` gives the schema of each.
pub(super) fn described(
    keys: &[(&str, &str)],
    value: impl Fn(&str) -> Json,
    required: &[&str],
) -> Json {
    let mut properties = Map::new();
    for (key, meaning) in keys {
        let mut schema = value(key);
        if let Json::Object(schema) = &mut schema {
            schema.insert("description".into(), (*meaning).into());
        }
        properties.insert((*key).into(), schema);
    }
    object(properties, required)
}

/// Numbers in their ranges under these keys.
pub(super) fn all_numbers(keys: Keys, required: &[&str]) -> Json {
    described(keys, |key| number(keys::range(keys, key)), required)
}

/// Each of these keys as a form that requires it, for `oneOf` and `anyOf`.
pub(super) fn each_required(keys: &[&str]) -> Json {
    keys.iter()
        .map(|key| json!({ "required": [key] }))
        .collect()
}

/// Exactly one of these keys.
pub(super) fn one_of(keys: &[&str]) -> Json {
    json!({ "oneOf": each_required(keys) })
}

/// None of these keys.
pub(super) fn none_of(keys: &[&str]) -> Json {
    json!({ "not": { "anyOf": each_required(keys) } })
}

/// Parts by names, several alike as `a|b`; no part is called `ground`.
pub(super) fn parts_by_name(one: Json) -> Json {
    let mut schema = named(one);
    let name = "(?! *ground *(\\||$)) *[A-Za-z_][A-Za-z0-9_]* *";
    schema["propertyNames"] = json!({ "pattern": format!("^({name}(\\|{name})*|//)$") });
    schema
}

/// An object with free names as keys.
pub(super) fn named(one: Json) -> Json {
    json!({ "type": "object", "additionalProperties": one, "properties": { "//": { "description": "a remark" } } })
}

/// Any number.
pub(super) fn any() -> Json {
    number(Range::Any)
}

/// Two nodes.
pub(super) fn between() -> Json {
    json!({ "type": "array", "minItems": 2, "maxItems": 2, "items": { "type": "string" } })
}

/// Nodes with their factors.
pub(super) fn along() -> Json {
    json!({ "type": "object", "minProperties": 1, "additionalProperties": any() })
}

/// A direction.
pub(super) fn direction() -> Json {
    json!({ "enum": Direction::TRANSLATIONS.map(Direction::name), "default": Direction::X.name() })
}

/// Two different directions.
pub(super) fn pair_of_directions() -> Json {
    let one = json!({ "enum": Direction::TRANSLATIONS.map(Direction::name) });
    json!({ "type": "array", "minItems": 2, "maxItems": 2, "uniqueItems": true, "items": one })
}
