//! The schema of studies of structures, whose parameters, channels and metrics have free names.

mod contacts;
mod results;

use results::{channels, figure, metric};

use crate::decode::checks;
use crate::describe::schema::fields::{self, named, object};
use crate::describe::schema::parts::{calibrate, computed, listed_metrics, reduction, several};
use crate::describe::schema::programs;
use crate::describe::schema::values::{self, EXPRESSION, INTERVAL, RULE, names, number, refer};
use crate::describe::schema::{block, need, take_needed};
use crate::figure::kinds::KINDS;
use crate::structure::keys;
use serde_json::{Map, Value as Json, json};
use slipgap_problem::problem::method::PARAMETERS;
use slipgap_problem::problem::numbers::parameter::Range;
use slipgap_problem::problem::structure::tables::schema::{FIXED, MEANING, NAME};

/// The rules for studies of structures.
pub(super) fn rules(definitions: &mut Map<String, Json>) -> Json {
    let mut define = |what: &str, schema: Json| {
        let name = format!("{NAME}.{what}");
        definitions.insert(name.clone(), schema);
        refer(&name)
    };
    define("function", object(&keys::FUNCTION, &shared));
    define("contact", contacts::contact(&shared));
    define("part", contacts::in_list(&shared));
    let mut parameters = parameters();
    let needed = take_needed(&mut parameters);
    let method = define("method", programs::with_programs(&mut parameters));
    let parameters = define("parameters", parameters);
    let structure = define("structure", object(&keys::STRUCTURE, &shared));
    let metric = define("metric", metric());
    let block = block(parameters.clone());
    let figures: Vec<Json> = KINDS.iter().map(figure).collect();
    let mut rules = json!({
        "if": { "properties": { "problem": { "const": NAME } }, "required": ["problem"] },
        "then": { "required": ["structure"], "properties": {
            "measured": object(&keys::MEASURED, &shared),
            "problem": { "description": MEANING },
            "parameters": parameters,
            "shared": parameters,
            "blocks": { "minItems": 1, "items": block },
            "structure": structure,
            "metrics": listed_metrics(&metric),
            "ensemble": several(json!({ "type": "string" })),
            "calibrate": calibrate(),
            "units": false,
            "figures": { "items": {
                "type": "object",
                "properties": { "kind": names(KINDS.iter().map(|kind| (kind.name, kind.meaning))) },
                "required": ["kind"],
                "allOf": figures,
            } },
            "checks": { "items": object(&checks::KEYS, &|name| match name {
                "where" => json!({ "type": "object" }),
                _ => json!({ "anyOf": [metric, reduction(), computed()] }),
            }) },
        } },
        "else": { "properties": { "structure": false, "measured": false } },
    });
    need(&mut rules, &needed);
    rules["then"]["allOf"] = json!([programs::known_without(&method, json!({})), channels()]);
    rules
}

/// The parts that tables of keys name.
fn shared(name: &str) -> Json {
    match name {
        "pulse" => object(&keys::PULSE, &shared),
        "static" => {
            let mut loads = named(number(Range::Any));
            loads["properties"] = fields::properties(keys::STATIC.fields(), &shared).into();
            loads
        }
        definition => refer(&format!("{NAME}.{definition}")),
    }
}

/// The step and the duration, those of the method, and others with free names.
fn parameters() -> Json {
    let mut schema = values::parameters(&PARAMETERS, "");
    schema["additionalProperties"] = axis_values();
    for (name, meaning) in FIXED {
        let one = number(Range::Positive);
        let list = json!({ "type": "array", "minItems": 1, "items": one });
        schema["properties"][name] = json!({
            "anyOf": [one, list, refer(RULE), refer(INTERVAL)],
            "description": meaning,
        });
    }
    schema["required"] = json!(FIXED.map(|fixed| fixed.0));
    schema
}

/// Values of a parameter with a free name.
fn axis_values() -> Json {
    let mut values = free_values();
    if let Some(forms) = values["anyOf"].as_array_mut() {
        forms.push(object(&keys::FILES, &shared));
    }
    values
}

/// The same without files.
pub(super) fn free_values() -> Json {
    let list = json!({ "type": "array", "minItems": 1, "items": { "type": ["number", "string"] } });
    json!({ "anyOf": [{ "type": "number" }, refer(EXPRESSION), list, refer(RULE), refer(INTERVAL)] })
}
