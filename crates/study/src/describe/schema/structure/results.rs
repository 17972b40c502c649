//! The schema of metrics, checks and figures of structures.

use super::rules::{any, described};
use crate::decode::checks;
use crate::describe::schema::figures::{Named, rules};
use crate::describe::schema::values::constant;
use crate::figure::kinds::{Kind, Needs};
use serde_json::{Value as Json, json};
use slipgap_problem::problem::structure::metrics::ground_metric::PREFIX;
use slipgap_problem::problem::structure::metrics::reduction::{REDUCTIONS, in_brackets};

/// The name of a metric.
pub(super) fn metric() -> Json {
    let one = |name: &str| {
        let pattern = match name.strip_prefix(PREFIX) {
            Some(measure) => format!("ground\\.([xyz]\\.)?{measure}"),
            None => name.to_owned(),
        };
        match in_brackets(name) {
            Some(_) => pattern + " *\\(.+\\)",
            None => pattern,
        }
    };
    let example = |name: &str| match in_brackets(name) {
        Some(inside) => format!("{name}({inside})"),
        None => name.to_owned(),
    };
    let patterns: Vec<String> = REDUCTIONS.iter().map(|known| one(known.0)).collect();
    // Editors offer them as completions.
    let examples: Vec<String> = REDUCTIONS.iter().map(|known| example(known.0)).collect();
    json!({
        "type": "string",
        "pattern": format!("^({})$", patterns.join("|")),
        "examples": examples,
        "description": "a reduction of a channel, such as peak(g1.right - p2) or impacts(gap12), or a measure of the ground, such as ground.pga or, of several directions, ground.y.pga",
    })
}

pub(super) fn check(metric: &Json) -> Json {
    let value = |key: &str| match key {
        "metric" => metric.clone(),
        "where" => json!({ "type": "object" }),
        _ => constant(),
    };
    let mut schema = described(&checks::KEYS, value, &["metric"]);
    schema["anyOf"] = json!([{ "required": ["min"] }, { "required": ["max"] }]);
    schema
}

/// The rules for figures of one kind, whose quantities and metrics have free names.
pub(super) fn figure(kind: &Kind) -> Json {
    let text = || json!({ "type": "string" });
    let named = Named {
        filter: json!({ "type": "object" }),
        parameter: text(),
        numeric: text(),
        quantity: text(),
        profile: text(),
        column: text(),
        metric: text(),
        budget: text(),
        marks: json!({ "type": "object" }),
        number: any(),
        has_units: false,
    };
    let suits = kind.needs != Needs::Profiles && kind.name != "law";
    rules(kind, suits, &named)
}
