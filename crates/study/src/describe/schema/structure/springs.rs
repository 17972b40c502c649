//! The schema of masses, bars and springs.

use super::rules::{along, between, described, direction, none_of, one_of, pair_of_directions};
use crate::describe::schema::values::{number, whole};
use crate::structure::keys::{self, BAR, MASS, SPRING};
use serde_json::{Value as Json, json};
use slipgap_problem::problem::structure::MOST_NODES;

/// A mass: a number, or one with its direction or two of them.
pub(super) fn mass() -> Json {
    let value = |key: &str| match key {
        "direction" => json!({ "anyOf": [direction(), pair_of_directions()] }),
        _ => number(keys::range(MASS, key)),
    };
    json!({ "anyOf": [value("mass"), described(MASS, value, &["mass"])] })
}

/// A bar.
pub(super) fn bar() -> Json {
    let value = |key: &str| match key {
        "direction" => direction(),
        "n" => whole(1, MOST_NODES.into()),
        _ => number(keys::range(BAR, key)),
    };
    described(BAR, value, &["L", "EA", "mass", "n"])
}

/// A spring; in two directions it may have two of each number.
pub(super) fn spring() -> Json {
    let value = |key: &str| match key {
        "between" => between(),
        "along" => along(),
        "direction" => direction(),
        "directions" => pair_of_directions(),
        "name" => json!({ "type": "string", "pattern": "^[A-Za-z_][A-Za-z0-9_]*$" }),
        _ => {
            let one = number(keys::range(SPRING, key));
            let two = json!({ "type": "array", "minItems": 2, "maxItems": 2, "items": one });
            json!({ "anyOf": [one, two] })
        }
    };
    let mut spring = described(SPRING, value, &[]);
    let by_period = ["mass", "period", "ratio"];
    let stiffness = json!({ "allOf": [
        { "anyOf": [{ "required": ["k"] }, { "required": ["c"] }] },
        none_of(&by_period),
    ] });
    let period = json!({ "required": ["mass", "period"], "not": { "anyOf": [
        { "required": ["k"] },
        { "required": ["c"] },
    ] } });
    spring["allOf"] = json!([
        one_of(&["between", "along"]),
        { "anyOf": [stiffness, period] },
    ]);
    spring
}
