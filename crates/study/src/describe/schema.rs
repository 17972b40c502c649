//! The JSON Schema of study files, made from the same tables that decode them.
//!
//! It is draft 7, which most editors support. Rules across parameters are tested only by `read`.

use serde_json::{Map, Value as Json, json};

use super::structure;
use super::values::{
    EXPRESSION, INTERVAL, RULE, expression, interval, names, number, object, parameters, ratio,
    refer, rule, value,
};
use crate::axes::design;
use crate::calibrate;
use crate::computed::sources::NAMED;
use crate::decode::blocks::BLOCK_KEYS;
use crate::decode::{self, checks, units};
use crate::figure::decoded_value::MARKS;
use crate::figure::extent::WIDTHS;
use crate::figure::keys::{COMMON, FITS, Key, ORDINATES, RIDGES, SCALES, Takes};
use crate::figure::kinds::{self, KINDS};
use crate::reduction::OPERATORS;
use crate::structure::names::SHOWN;
use crate::units::IN;
use slipgap_solver::expression::FUNCTIONS;
use slipgap_solver::problem::parameter::{Kind, Parameter, Range};
use slipgap_solver::problem::{self, Metric, PROBLEMS, Problem};
use std::sync::Arc;

/// The schema as indented JSON with a newline at its end.
pub fn schema() -> String {
    let mut properties = Map::new();
    for (key, meaning) in decode::KEYS.into_iter().chain(BLOCK_KEYS) {
        properties.insert(key.into(), json!({ "description": meaning }));
    }
    properties.extend(block_keys());
    for (key, kind) in [
        ("$schema", "string"),
        ("title", "string"),
        ("parameters", "object"),
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
    if let (Json::Object(own), Json::Object(keys)) = (&mut properties["recommend"], recommend()) {
        own.extend(keys);
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
    schema["allOf"] = each.into();
    schema["definitions"] = definitions.into();
    format!("{schema:#}\n")
}

/// The keys of a block in addition to `parameters`.
pub(super) fn block_keys() -> Map<String, Json> {
    let described = |key: &str, mut schema: Json, table: &[(&str, &str)]| {
        let meaning = table.iter().find(|row| row.0 == key).map(|row| row.1);
        schema["description"] = meaning.unwrap_or_default().into();
        (key.to_owned(), schema)
    };
    let group = json!({ "type": "array", "minItems": 2, "items": { "type": "string" } });
    let kind = names(design::KINDS.into_iter());
    let keys = [
        described("kind", kind, &design::KEYS),
        described("n", number(Range::Positive), &design::KEYS),
        described("seed", number(Range::NotNegative), &design::KEYS),
    ];
    let design = object(keys.into_iter().collect(), &["kind", "n"]);
    let keys = [
        described(
            "zip",
            json!({ "type": "array", "items": group }),
            &BLOCK_KEYS,
        ),
        described("when", json!({ "type": "string" }), &BLOCK_KEYS),
        described("design", design, &BLOCK_KEYS),
    ];
    keys.into_iter().collect()
}

/// The rules for studies of one problem. Parts that occur several times are definitions.
fn of_problem(problem: &dyn Problem, definitions: &mut Map<String, Json>) -> Json {
    let mut define = |what: &str, schema: Json| {
        definitions.insert(name_of(problem, what), schema);
        refer(&name_of(problem, what))
    };
    let parameters = define("parameters", parameters(problem.parameters(), ""));
    let metric = define("metric", metric(problem));
    define(
        "column",
        json!({ "anyOf": [metric, reduction(), computed()] }),
    );
    define("where", filter(problem));
    let mut block = block_keys();
    block.insert("parameters".into(), parameters.clone());
    let figures: Vec<Json> = KINDS.iter().map(|kind| of_kind(kind, problem)).collect();
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

/// The text of a reduction.
pub(super) fn reduction() -> Json {
    let words = OPERATORS.map(|word| word.0.replace('P', "[^ ]+"));
    json!({
        "type": "string",
        "pattern": format!("^({}) .+ over .+$", words.join("|")),
        "description": "a metric reduced over parameters, such as least rms_error over alpha",
    })
}

/// Names and units of parameters for figures.
fn shown_names() -> Json {
    let pair =
        json!({ "type": "array", "minItems": 1, "maxItems": 2, "items": { "type": "string" } });
    json!({ "type": "object", "additionalProperties": pair, "description": SHOWN.1 })
}

/// Arithmetic of metrics, or a ratio to a reference case.
fn arithmetic() -> Json {
    let functions = FUNCTIONS.map(|own| own.0).join("|");
    let name = "[A-Za-z_][A-Za-z0-9_.]*";
    json!({
        "type": "string",
        "pattern": format!("^[-+(.0-9]|^({functions}) *\\(|\\) *[-+*/^]|^{name} *[-+*/^]| relative to "),
        "description": "arithmetic of metrics such as max(a3 - a2)/h, or a ratio to a reference case such as peak(gap.S) relative to gamma = 1, n = 10",
    })
}

/// The same, or a name that the study gives a metric.
pub(super) fn computed() -> Json {
    let name = json!({
        "type": "string",
        "pattern": "^[A-Za-z][A-Za-z0-9_]*$",
        "description": "a metric with a name of the study",
    });
    json!({ "anyOf": [arithmetic(), name] })
}

/// The key `metrics`: names of metrics, arithmetic, and objects that give names.
pub(super) fn listed_metrics(metric: &Json) -> Json {
    let mut properties = Map::new();
    for (key, meaning) in NAMED {
        properties.insert(
            key.into(),
            json!({ "type": "string", "description": meaning }),
        );
    }
    let one = json!({ "anyOf": [{ "type": "string" }, object(properties, &[NAMED[0].0])] });
    let named = json!({
        "type": "object",
        "propertyNames": { "pattern": "^([A-Za-z][A-Za-z0-9_]*|//)$" },
        "properties": { "//": { "description": "a remark" } },
        "additionalProperties": one,
    });
    let item = json!({ "anyOf": [metric, arithmetic(), named.clone()] });
    let mut schema = named;
    schema["type"] = json!(["array", "object"]);
    schema["items"] = item;
    schema
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

/// The name of a definition that belongs to a problem.
fn name_of(problem: &dyn Problem, what: &str) -> String {
    format!("{}.{what}", problem.name())
}

/// The rules for figures of one kind.
fn of_kind(kind: &kinds::Kind, problem: &dyn Problem) -> Json {
    let mut properties = Map::new();
    let mut required = Vec::new();
    for key in COMMON.iter().chain(kind.keys) {
        let mut schema = taken(key, problem);
        schema["description"] = key.meaning.into();
        properties.insert(key.name.into(), schema);
        if key.required {
            required.push(key.name);
        }
    }
    let then = match kind.suits(problem) {
        true => object(properties, &required),
        false => json!(false),
    };
    json!({
        "if": { "properties": { "kind": { "const": kind.name } }, "required": ["kind"] },
        "then": then,
    })
}

/// The name of a parameter; of one that is a number, if `numeric`.
fn parameter_names(problem: &dyn Problem, numeric: bool) -> Json {
    let table = problem.parameters().iter();
    let suitable = table.filter(|p| !numeric || !matches!(p.kind, Kind::Choice(_)));
    names(suitable.map(|p| (&*p.name, &*p.meaning)))
}

/// The value of a key of a figure.
fn taken(key: &Key, problem: &dyn Problem) -> Json {
    let parameters = |numeric: bool| parameter_names(problem, numeric);
    let profiles = || {
        names(
            problem
                .schema()
                .profiles
                .iter()
                .map(|p| (&*p.name, &*p.title)),
        )
    };
    let quantities = || {
        let all = problem.schema().quantities.iter();
        names(all.map(|q| (&*q.name, &*q.title)))
    };
    let defined = |what: &str| refer(&name_of(problem, what));
    match key.takes {
        Takes::FileName => {
            json!({ "type": "string", "pattern": "^[A-Za-z0-9_][A-Za-z0-9_-]{0,99}$" })
        }
        Takes::Kind => json!({}),
        Takes::Text => json!({ "type": "string" }),
        Takes::Filter => defined("where"),
        Takes::Parameter => parameters(false),
        Takes::Parameters => several(parameters(false)),
        Takes::NumericParameter => parameters(true),
        Takes::Quantity => quantities(),
        Takes::Quantities => several(quantities()),
        Takes::Ordinates => several(names(ORDINATES.into_iter())),
        Takes::Ratios => several(ratio()),
        Takes::Periods | Takes::Probabilities => pair(),
        Takes::Number => number(Range::Any),
        Takes::Column => json!({ "anyOf": [parameters(true), defined("column")] }),
        Takes::Profile => profiles(),
        Takes::Profiles => several(profiles()),
        Takes::Metric => defined("column"),
        Takes::Metrics => several(defined("column")),
        Takes::Times => several(number(Range::NotNegative)),
        Takes::Budgets => several(names(
            problem
                .schema()
                .budgets
                .iter()
                .map(|b| (&*b.name, &*b.title)),
        )),
        Takes::Width => width(),
        Takes::Range => pair(),
        Takes::Marks => marks(),
        Takes::InUnits if problem.schema().units.is_empty() => json!({ "const": false }),
        Takes::InUnits => json!({ "type": "boolean", "default": false }),
        Takes::Switch => json!({ "type": "boolean" }),
        Takes::Ridge => json!({ "enum": RIDGES }),
        Takes::Fit => json!({ "enum": FITS, "default": FITS[0] }),
        Takes::Scale => json!({ "enum": SCALES, "default": SCALES[0] }),
        Takes::ScaleOrLog => json!({ "enum": SCALES, "default": SCALES[1] }),
    }
}

pub(super) fn several(one: Json) -> Json {
    json!({ "anyOf": [one, { "type": "array", "minItems": 1, "items": one }] })
}

/// A width in mm.
fn width() -> Json {
    let [least, most] = WIDTHS;
    let plain = json!({ "type": "number", "minimum": least, "maximum": most });
    json!({ "anyOf": [plain, refer(EXPRESSION)] })
}

/// A width in mm, and the two ends of an axis.
pub(super) fn width_and_pair() -> (Json, Json) {
    (width(), pair())
}

/// The key `calibrate`.
pub(super) fn calibrate() -> Json {
    let mut properties = Map::new();
    for ((key, meaning), schema) in calibrate::decode::KEYS.into_iter().zip([
        json!({ "type": "string" }),
        number(Range::NotNegative),
        number(Range::Positive),
    ]) {
        let mut schema = schema;
        schema["description"] = meaning.into();
        properties.insert(key.into(), schema);
    }
    with_free(properties, &[calibrate::decode::KEYS[0].0])
}

/// The key `recommend`.
fn recommend() -> Json {
    let tolerances = json!({
        "type": "object",
        "properties": { "//": { "description": "a remark" } },
        "minProperties": 1,
        "additionalProperties": number(Range::Positive),
    });
    let keys = calibrate::recommend::KEYS;
    let schemas = [several(json!({ "type": "string" })), tolerances];
    let properties = keys.iter().zip(schemas).map(|((key, meaning), schema)| {
        let mut schema = schema;
        schema["description"] = (*meaning).into();
        ((*key).to_owned(), schema)
    });
    with_free(properties.collect(), &keys.map(|key| key.0))
}

/// An object with these properties, remarks, and ranges of free parameters.
fn with_free(mut properties: Map<String, Json>, required: &[&str]) -> Json {
    properties.insert("//".into(), json!({ "description": "a remark" }));
    let (key, meaning) = calibrate::range::LOG;
    let mut log = pair();
    log["description"] = meaning.into();
    let log = object(Map::from_iter([(key.to_owned(), log)]), &[key]);
    json!({
        "type": "object",
        "properties": properties,
        "required": required,
        "additionalProperties": { "anyOf": [pair(), log], "description": "range of a free parameter" },
    })
}

/// Two numbers.
fn pair() -> Json {
    json!({ "type": "array", "minItems": 2, "maxItems": 2, "items": number(Range::Any) })
}

fn marks() -> Json {
    let place = pair();
    let mut properties = Map::new();
    for (key, meaning) in MARKS {
        properties.insert(
            key.into(),
            match key {
                "at" => json!({ "type": "array", "items": place, "description": meaning }),
                _ => json!({ "type": "string", "description": meaning }),
            },
        );
    }
    object(properties, &MARKS.map(|key| key.0))
}

/// A `where`: values of parameters, one or several of each.
fn filter(problem: &dyn Problem) -> Json {
    let table = problem.parameters().iter();
    let term = |p: &Parameter| {
        let list = json!({ "type": "array", "minItems": 1, "items": value(p) });
        let schema = json!({ "anyOf": [value(p), list], "description": p.meaning });
        (p.name.to_string(), schema)
    };
    object(table.map(term).collect(), &[])
}

fn check(problem: &dyn Problem) -> Json {
    let mut properties = Map::new();
    for (key, meaning) in checks::KEYS {
        let mut schema = match key {
            "metric" => refer(&name_of(problem, "column")),
            "where" => refer(&name_of(problem, key)),
            _ => number(Range::Any),
        };
        schema["description"] = meaning.into();
        properties.insert(key.into(), schema);
    }
    let mut schema = object(properties, &["metric"]);
    schema["anyOf"] = json!([{ "required": ["min"] }, { "required": ["max"] }]);
    schema
}

#[cfg(test)]
mod tests {
    use super::*;

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
