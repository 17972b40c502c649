//! The JSON Schema of study files, made from the same tables that decode them.
//!
//! It is draft 7, which most editors support. Rules across parameters are tested only by `read`.

mod fields;
mod figures;
mod parts;
mod programs;
mod share;
mod structure;
pub(super) mod values;

use crate::axes::axis_rule::RULES;
use crate::axes::interval::INTERVALS;
use crate::decode::blocks::BLOCK_KEYS;
use crate::decode::{self, checks, units};
use crate::figure::kinds::KINDS;
use crate::source::field::{Keys, Kind};
use crate::units::IN;
use figures::{Named, filter, name_of, parameter_names};
use parts::{computed, listed_metrics, recommend, reduction, several};
use serde_json::{Map, Value as Json, json};
use slipgap_problem::problem::{Metric, PROBLEMS, Problem};
use std::sync::Arc;
use values::{EXPRESSION, INTERVAL, RULE, expression, names, object, parameters, refer};

/// The schema as indented JSON with a newline at its end.
pub fn schema() -> String {
    let mut schema = whole();
    share::share(&mut schema);
    lines(&schema)
}

/// The schema with parts that occur several times written out.
fn whole() -> Json {
    let mut definitions = Map::new();
    definitions.insert(EXPRESSION.into(), expression());
    definitions.insert(RULE.into(), one_of(&RULES, "a rule for the values of an axis; a whole-number parameter takes the nearest whole numbers"));
    definitions.insert(
        INTERVAL.into(),
        one_of(
            &INTERVALS,
            "the distribution of a parameter that a design samples",
        ),
    );
    let rules = |problem: &Arc<dyn Problem>| of_problem(&**problem, &mut definitions);
    let mut each: Vec<Json> = PROBLEMS.iter().map(rules).collect();
    each.push(structure::rules(&mut definitions));
    let mut schema = fields::object(&decode::KEYS, &shared);
    schema["$schema"] = "http://json-schema.org/draft-07/schema#".into();
    schema["title"] = "slipgap study".into();
    schema["allOf"] = each.into();
    schema["definitions"] = definitions.into();
    schema
}

/// The parts of studies of all problems.
fn shared(name: &str) -> Json {
    match name {
        "parameters" => json!({ "type": "object" }),
        "metrics" => json!({ "type": ["array", "object"] }),
        "names" => {
            let text = Kind::List(&Kind::Text, [1, 2]);
            json!({ "type": "object", "additionalProperties": fields::value(&text, &shared) })
        }
        "reduction" => reduction(),
        "recommend" => recommend(),
        definition => refer(definition),
    }
}

/// An object with one of several keys.
fn one_of(keys: &Keys, meaning: &str) -> Json {
    let mut schema = fields::object(keys, &shared);
    schema["description"] = meaning.into();
    schema
}

/// The keys of a block.
fn block(parameters: Json) -> Json {
    let mut properties = fields::properties(BLOCK_KEYS.iter(), &shared);
    properties.insert("parameters".into(), parameters);
    object(properties, &["parameters"])
}

/// A value with one key or item in each line, without the spaces before it: they would be more than half of the schema.
fn lines(value: &Json) -> String {
    let shown = format!("{value:#}\n");
    shown
        .lines()
        .map(|line| format!("{}\n", line.trim_start()))
        .collect()
}

/// The rules for studies of one problem. Parts that occur several times are definitions.
fn of_problem(problem: &dyn Problem, definitions: &mut Map<String, Json>) -> Json {
    let mut define = |what: &str, schema: Json| {
        definitions.insert(name_of(problem, what), schema);
        refer(&name_of(problem, what))
    };
    let mut parameters = parameters(problem.parameters(), "");
    parameters["additionalProperties"] = structure::free_values();
    let needed = take_needed(&mut parameters);
    let method = define("method", programs::with_programs(&mut parameters));
    let parameters = define("parameters", parameters);
    let metric = define("metric", metric(problem));
    define(
        "column",
        json!({ "anyOf": [metric, reduction(), computed()] }),
    );
    define("where", filter(problem));
    let block = block(parameters.clone());
    let named = Named::of(problem);
    let of_this = |name: &str| refer(&name_of(problem, name));
    let figures: Vec<Json> = KINDS
        .iter()
        .map(|kind| figures::rules(kind, kind.suits(problem), &named))
        .collect();
    let figure = json!({
        "type": "object",
        "properties": { "kind": names(KINDS.iter().map(|kind| (kind.name, kind.meaning))) },
        "required": ["kind"],
        "allOf": figures,
    });
    let mut rules = json!({
        "if": { "properties": { "problem": { "const": problem.name() } }, "required": ["problem"] },
        "then": { "properties": {
            "problem": { "description": problem.schema().meaning },
            "parameters": parameters,
            "shared": parameters,
            "blocks": { "minItems": 1, "items": block },
            "metrics": listed_metrics(&metric),
            "ensemble": several(parameter_names(problem, false)),
            "calibrate": false,
            "units": if problem.schema().units.is_empty() { json!(false) } else { fields::object(&units::KEYS, &shared) },
        } },
    });
    need(&mut rules, &needed);
    // Figures and checks may name programs and their numbers, too.
    let named_in_results = json!({
        "figures": { "items": figure },
        "checks": { "items": fields::object(&checks::KEYS, &of_this) },
    });
    rules["then"]["allOf"] = json!([programs::known_without(&method, named_in_results)]);
    rules
}

/// Takes out of the schema of parameters which of them a study needs.
fn take_needed(parameters: &mut Json) -> Json {
    let needed = parameters
        .as_object_mut()
        .and_then(|schema| schema.remove("required"));
    needed.unwrap_or_else(|| json!([]))
}

/// Adds that a study needs these parameters: in each block, unless `shared` may have them.
fn need(rules: &mut Json, needed: &Json) {
    let study = &mut rules["then"];
    study["properties"]["parameters"]["required"] = needed.clone();
    study["if"] = json!({ "not": { "required": ["shared"] } });
    study["then"] = json!({ "properties": { "blocks": { "items": { "properties": { "parameters": { "required": needed } } } } } });
}

/// The name of a metric, or of one in the units of the study.
fn metric(problem: &dyn Problem) -> Json {
    let metrics = || problem.metrics().iter();
    let scaled = names(metrics().map(|m| (&*m.name, &*m.meaning)));
    let has_unit = |m: &&Metric| {
        problem
            .schema()
            .units
            .iter()
            .any(|unit| unit.name == m.unit)
    };
    let of_unit: Vec<&str> = metrics().filter(has_unit).map(|m| &*m.name).collect();
    if of_unit.is_empty() {
        return scaled;
    }
    let unit = units::NAME.trim_matches(['^', '$']);
    let in_units = json!({
        "type": "string",
        "pattern": format!("^({}){}{unit}(_per_{unit})?$", of_unit.join("|"), IN),
        "description": "a metric in the units of the study",
    });
    json!({ "anyOf": [scaled, in_units] })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_of_every_table_is_described() {
        let text = schema();
        let schema: Json = serde_json::from_str(&text).unwrap_or_default();
        for (key, _) in decode::KEYS.rows() {
            assert!(
                schema["properties"][key]["description"].is_string(),
                "{key}"
            );
        }
        for (problem, rules) in PROBLEMS
            .iter()
            .zip(schema["allOf"].as_array().into_iter().flatten())
        {
            let properties = &rules["then"]["allOf"][0]["then"]["properties"];
            for parameter in problem.parameters() {
                let meaning = Json::from(&*parameter.meaning).to_string();
                assert!(
                    text.contains(meaning.trim_end_matches('"')),
                    "{}",
                    parameter.name
                );
            }
            for key in checks::KEYS.rows() {
                assert!(
                    properties["checks"]["items"]["properties"][key.0].is_object(),
                    "{}",
                    key.0
                );
            }
            for (kind, rules) in KINDS.iter().zip(
                properties["figures"]["items"]["allOf"]
                    .as_array()
                    .into_iter()
                    .flatten(),
            ) {
                for key in kind.keys.iter().filter(|_| rules["then"].is_object()) {
                    assert!(
                        rules["then"]["properties"][key.name]["description"].is_string(),
                        "{}",
                        key.name
                    );
                }
            }
        }
    }
}
