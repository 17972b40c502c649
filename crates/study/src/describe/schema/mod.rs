//! The JSON Schema of study files, made from the same tables that decode them.
//!
//! It is draft 7, which most editors support. Rules across parameters are tested only by `read`.

mod figures;
mod parts;
mod share;
mod structure;
pub(super) mod values;

use crate::decode::blocks::BLOCK_KEYS;
use crate::decode::{self, SHARED, units};
use crate::figure::kinds::KINDS;
use crate::structure::named::shown::SHOWN;
use crate::units::IN;
use figures::{Named, check, filter, name_of, parameter_names};
use parts::{block_keys, computed, listed_metrics, recommend, reduction, several};
use serde_json::{Map, Value as Json, json};
use slipgap_problem::problem::{self, Metric, PROBLEMS, Problem};
use std::sync::Arc;
use values::{
    EXPRESSION, INTERVAL, RULE, expression, interval, names, object, parameters, refer, rule,
};

/// The schema as indented JSON with a newline at its end.
pub fn schema() -> String {
    let mut schema = whole();
    share::share(&mut schema);
    lines(&schema)
}

/// The schema with parts that occur several times written out.
fn whole() -> Json {
    let mut properties = Map::new();
    for (key, meaning) in decode::KEYS.into_iter().chain(BLOCK_KEYS) {
        properties.insert(key.into(), json!({ "description": meaning }));
    }
    properties.extend(block_keys());
    for (key, kind) in [
        ("$schema", "string"),
        ("title", "string"),
        ("parameters", "object"),
        (SHARED.0, "object"),
    ] {
        properties[key]["type"] = kind.into();
    }
    for key in ["blocks", "reductions", "figures", "checks"] {
        properties[key]["type"] = "array".into();
    }
    let problems: Vec<&str> = problem::names().collect();
    properties["metrics"]["type"] = json!(["array", "object"]);
    properties["names"] = shown_names();
    properties["reductions"]["items"] = reduction();
    if let (Json::Object(object), Json::Object(keys)) = (&mut properties["recommend"], recommend())
    {
        object.extend(keys);
    }
    properties["problem"]["enum"] = json!(problems);
    properties["iteration"]["enum"] = json!(decode::ITERATIONS);
    let mut definitions = Map::new();
    definitions.insert(EXPRESSION.into(), expression());
    definitions.insert(RULE.into(), rule());
    definitions.insert(INTERVAL.into(), interval());
    let rules = |problem: &Arc<dyn Problem>| of_problem(&**problem, &mut definitions);
    let mut each: Vec<Json> = PROBLEMS.iter().map(rules).collect();
    each.push(structure::rules(&mut definitions));
    let mut schema = object(properties, &["problem"]);
    schema["$schema"] = "http://json-schema.org/draft-07/schema#".into();
    schema["title"] = "slipgap study".into();
    schema["oneOf"] = json!([{ "required": ["parameters"] }, { "required": ["blocks"] }]);
    schema["dependencies"] = json!({ SHARED.0: ["blocks"] });
    schema["allOf"] = each.into();
    schema["definitions"] = definitions.into();
    schema
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
    let parameters = define("parameters", parameters);
    let metric = define("metric", metric(problem));
    define(
        "column",
        json!({ "anyOf": [metric, reduction(), computed()] }),
    );
    define("where", filter(problem));
    let mut block = block_keys();
    block.insert("parameters".into(), parameters.clone());
    let named = Named::of(problem);
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
    json!({
        "if": { "properties": { "problem": { "const": problem.name() } }, "required": ["problem"] },
        "then": { "properties": {
            "problem": { "description": problem.schema().meaning },
            "parameters": parameters,
            "shared": parameters,
            "blocks": { "minItems": 1, "items": object(block, &["parameters"]) },
            "metrics": listed_metrics(&metric),
            "ensemble": several(parameter_names(problem, false)),
            "calibrate": false,
            "units": if problem.schema().units.is_empty() { json!(false) } else { units() },
            "figures": { "items": figure },
            "checks": { "items": check(problem) },
        } },
    })
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
    let in_units = json!({
        "type": "string",
        "pattern": format!("^({}){}{UNIT}(_per_{UNIT})?$", of_unit.join("|"), IN),
        "description": "a metric in the units of the study",
    });
    json!({ "anyOf": [scaled, in_units] })
}

/// Names and units of parameters for figures.
fn shown_names() -> Json {
    let pair =
        json!({ "type": "array", "minItems": 1, "maxItems": 2, "items": { "type": "string" } });
    json!({ "type": "object", "additionalProperties": pair, "description": SHOWN.1 })
}

/// A name of a unit, as a regular expression.
const UNIT: &str = "[A-Za-zµ][A-Za-z0-9µ]{0,15}";

/// The key `units`.
fn units() -> Json {
    let one = |(key, meaning): (&str, &str)| {
        let schema =
            json!({ "type": "string", "pattern": format!("^{UNIT}$"), "description": meaning });
        (key.to_owned(), schema)
    };
    object(
        units::KEYS.into_iter().map(one).collect(),
        &units::KEYS.map(|key| key.0),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::decode::checks;

    #[test]
    fn every_key_of_every_table_is_described() {
        let text = schema();
        let schema: Json = serde_json::from_str(&text).unwrap_or_default();
        for (key, _) in decode::KEYS {
            assert!(
                schema["properties"][key]["description"].is_string(),
                "{key}"
            );
        }
        for (problem, rules) in PROBLEMS
            .iter()
            .zip(schema["allOf"].as_array().into_iter().flatten())
        {
            let properties = &rules["then"]["properties"];
            for parameter in problem.parameters() {
                let meaning = Json::from(&*parameter.meaning).to_string();
                assert!(
                    text.contains(meaning.trim_end_matches('"')),
                    "{}",
                    parameter.name
                );
            }
            for key in checks::KEYS {
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
