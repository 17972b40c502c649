//! The schema of metrics, checks and figures of structures.

use super::{any, described};
use crate::decode::checks;
use crate::describe::schema::parts::{several, width_and_pair};
use crate::describe::schema::values::{names, number, object, ratio};
use crate::figure::keys::{COMMON, FITS, Key, ORDINATES, RIDGES, SCALES, Takes};
use crate::figure::kinds::Needs;
use serde_json::{Map, Value as Json, json};
use slipgap_solver::problem::parameter::Range;
use slipgap_solver::problem::structure::ground_metric::PREFIX;
use slipgap_solver::problem::structure::metric::REDUCTIONS;

/// The name of a metric.
pub(super) fn metric() -> Json {
    let one = |name: &str| match name.strip_prefix(PREFIX) {
        Some(measure) => format!("ground\\.([xyz]\\.)?{measure}"),
        None => name.to_owned(),
    };
    let all: Vec<String> = REDUCTIONS.iter().map(|known| one(known.0)).collect();
    json!({
        "type": "string",
        "pattern": format!("^({})( *\\(.+\\))?$", all.join("|")),
        "description": "a reduction of a channel, such as peak(g1.right - p2) or impacts(gap12), or a measure of the ground, such as ground.pga or, of several directions, ground.y.pga",
    })
}

pub(super) fn check(metric: &Json) -> Json {
    let value = |key: &str| match key {
        "metric" => metric.clone(),
        "where" => json!({ "type": "object" }),
        _ => any(),
    };
    let mut schema = described(&checks::KEYS, value, &["metric"]);
    schema["anyOf"] = json!([{ "required": ["min"] }, { "required": ["max"] }]);
    schema
}

/// The rules for figures of one kind.
pub(super) fn figure(kind: &crate::figure::kinds::Kind) -> Json {
    let mut properties = Map::new();
    let mut required = Vec::new();
    for key in COMMON.iter().chain(kind.keys) {
        let mut schema = taken(key);
        schema["description"] = key.meaning.into();
        properties.insert(key.name.into(), schema);
        if key.required {
            required.push(key.name);
        }
    }
    let then = match kind.needs == Needs::Profiles || kind.name == "law" {
        true => json!(false),
        false => object(properties, &required),
    };
    json!({
        "if": { "properties": { "kind": { "const": kind.name } }, "required": ["kind"] },
        "then": then,
    })
}

pub(super) fn taken(key: &Key) -> Json {
    let text = json!({ "type": "string" });
    match key.takes {
        Takes::FileName => {
            json!({ "type": "string", "pattern": "^[A-Za-z0-9_][A-Za-z0-9_-]{0,99}$" })
        }
        Takes::Kind => json!({}),
        Takes::Filter => json!({ "type": "object" }),
        Takes::Quantities
        | Takes::Profiles
        | Takes::Metrics
        | Takes::Budgets
        | Takes::Parameters => several(text),
        Takes::Ordinates => several(names(ORDINATES.into_iter())),
        Takes::Ratios => several(ratio()),
        Takes::Times => several(number(Range::NotNegative)),
        Takes::Width => width_and_pair().0,
        Takes::Range | Takes::Periods | Takes::Probabilities => width_and_pair().1,
        Takes::Number => any(),
        Takes::Marks => json!({ "type": "object" }),
        Takes::InUnits => json!({ "const": false }),
        Takes::Switch => json!({ "type": "boolean" }),
        Takes::Ridge => json!({ "enum": RIDGES }),
        Takes::Fit => json!({ "enum": FITS, "default": FITS[0] }),
        Takes::Scale => json!({ "enum": SCALES, "default": SCALES[0] }),
        Takes::ScaleOrLog => json!({ "enum": SCALES, "default": SCALES[1] }),
        Takes::Text
        | Takes::Parameter
        | Takes::NumericParameter
        | Takes::Column
        | Takes::Quantity
        | Takes::Profile
        | Takes::Metric => text,
    }
}
