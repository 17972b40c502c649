//! The schema of metrics, checks and figures of structures.

use crate::describe::schema::figures::{Named, rules};
use crate::describe::schema::values::number;
use crate::figure::kinds::{Kind, Needs};
use serde_json::{Value as Json, json};
use slipgap_problem::problem::numbers::parameter::Range;
use slipgap_problem::problem::structure::channels::channel::QUANTITIES;
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

/// Refuses channels of contacts in other letters, and `F`, in metrics and in what figures draw; only of studies without matrices, whose
/// nodes and forces have any name.
pub(super) fn channels() -> Json {
    let names = QUANTITIES.iter().map(|row| row.0);
    let other = names.map(|name| match name.chars().all(char::is_uppercase) {
        true => name.to_lowercase(),
        false => name[..1].to_uppercase() + &name[1..],
    });
    let names: Vec<String> = other.chain(["F".to_owned()]).collect();
    let (name, names) = ("[A-Za-z][A-Za-z0-9_]*", names.join("|"));
    let pattern = format!("(^|[-+*/(, ]){name}\\.({names})($|[-+*/), ])");
    let known = json!({ "not": { "type": "string", "pattern": pattern } });
    let drawn = json!({ "allOf": [known], "items": known });
    json!({
        "if": { "properties": { "structure": { "not": { "required": ["matrices"] } } } },
        "then": { "properties": {
            "metrics": { "items": known },
            "figures": { "items": { "properties": { "x": drawn, "y": drawn } } },
            "checks": { "items": { "properties": { "metric": known } } },
        } },
    })
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
        number: number(Range::Any),
        has_units: false,
    };
    let suits = kind.needs != Needs::Profiles && kind.name != "law";
    rules(kind, suits, &named)
}
