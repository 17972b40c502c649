//! The schema of studies of structures, whose parameters, channels and metrics have free names.

mod contacts;
mod motions;
mod results;
mod rules;
mod springs;

use motions::{function, ground, load, support};
use results::{check, figure, metric};
use rules::{all_numbers, any, described, each_required, named, parts_by_name};
use springs::{bar, mass, spring};

use crate::describe::schema::parts::{
    block_keys, calibrate, computed, listed_metrics, reduction, several,
};
use crate::describe::schema::values::{
    self, EXPRESSION, INTERVAL, RULE, names, number, object, refer,
};
use crate::figure::kinds::KINDS;
use crate::structure::keys;
use serde_json::{Map, Value as Json, json};
use slipgap_problem::problem::method::PARAMETERS;
use slipgap_problem::problem::numbers::parameter::Range;
use slipgap_problem::problem::structure::channels::sample::FEWEST_TESTS;
use slipgap_problem::problem::structure::tables::schema::{FIXED, MEANING, NAME};
use slipgap_system::system::loads::Unit;
use slipgap_system::system::loads::pair::Component;

/// The rules for studies of structures.
pub(super) fn rules(definitions: &mut Map<String, Json>) -> Json {
    let mut define = |what: &str, schema: Json| {
        let name = format!("{NAME}.{what}");
        definitions.insert(name.clone(), schema);
        refer(&name)
    };
    let function = define("function", function());
    let part = format!("{NAME}.part");
    let contact = define("contact", contacts::contact(&function, &part));
    define("part", contacts::in_list(&function, &part));
    let parameters = define("parameters", parameters());
    let structure = define("structure", structure(&function, &contact));
    let metric = define("metric", metric());
    let mut block = block_keys();
    block.insert("parameters".into(), parameters.clone());
    let figures: Vec<Json> = KINDS.iter().map(figure).collect();
    json!({
        "if": { "properties": { "problem": { "const": NAME } }, "required": ["problem"] },
        "then": { "required": ["structure"], "properties": {
            "measured": measured(),
            "problem": { "description": MEANING },
            "parameters": parameters,
            "shared": parameters,
            "blocks": { "minItems": 1, "items": object(block, &["parameters"]) },
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
            "checks": { "items": check(&json!({ "anyOf": [metric, reduction(), computed()] })) },
        } },
        "else": { "properties": { "structure": false, "measured": false } },
    })
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

fn numbers() -> Json {
    json!({ "type": "array", "minItems": 1, "items": any() })
}

/// Adds the properties of a schema to those of another one.
fn add_properties(schema: &mut Json, more: &Json) {
    if let (Json::Object(to), Json::Object(from)) = (&mut schema["properties"], &more["properties"])
    {
        to.extend(from.clone());
    }
}

fn structure(function: &Json, contact: &Json) -> Json {
    let value = |key: &str| match key {
        "units" => json!({ "type": "string" }),
        "masses" => parts_by_name(mass()),
        "bars" => parts_by_name(bar()),
        "matrices" => {
            let value = |key: &str| match key {
                "reduce" => {
                    let mut reduce = all_numbers(keys::REDUCE, &[]);
                    reduce["oneOf"] = each_required(&keys::names(keys::REDUCE));
                    reduce
                }
                "dofs" => {
                    let row = json!({ "type": "array", "minItems": 2, "maxItems": 5 });
                    json!({ "anyOf": [{ "type": "string" }, { "type": "array", "items": row }] })
                }
                _ => json!({ "type": "string" }),
            };
            parts_by_name(described(keys::MATRICES, value, &["M", "K", "dofs"]))
        }
        "springs" => json!({ "type": "array", "items": spring() }),
        "rayleigh" => rayleigh(),
        keys::MODAL_DAMPING => {
            let ratio = number(keys::range(keys::STRUCTURE, key));
            let list = json!({ "type": "array", "items": ratio });
            json!({ "anyOf": [ratio, list] })
        }
        "contacts" => parts_by_name(contact.clone()),
        "loads" => json!({ "type": "array", "items": load() }),
        "ground" => ground(function),
        "supports" => parts_by_name(support(function)),
        "static" => {
            let mut loads = named(any());
            loads["properties"] = json!({ keys::GRAVITY.0: gravity() });
            loads
        }
        "gravity" => gravity(),
        "start" => named(all_numbers(keys::START, &[])),
        "contacts_reference" => json!({ "enum": keys::REFERENCES }),
        "damping_stiffness" => {
            let [first, ..] = keys::DAMPING_STIFFNESSES;
            json!({ "enum": keys::DAMPING_STIFFNESSES, "default": first })
        }
        _ => number(keys::range(keys::STRUCTURE, key)),
    };
    described(keys::STRUCTURE, value, &[])
}

/// An acceleration in y, or one in each direction.
fn gravity() -> Json {
    json!({ "anyOf": [any(), all_numbers(keys::GROUND, &[])] })
}

/// The factors of M and K, or two ratios.
fn rayleigh() -> Json {
    let value = |key: &str| {
        let one = number(keys::range(keys::RAYLEIGH, key));
        match key {
            "mass" | "stiffness" => one,
            _ => json!({ "type": "array", "minItems": 2, "maxItems": 2, "items": one }),
        }
    };
    let mut schema = described(keys::RAYLEIGH, value, &[]);
    let by_ratios = json!({ "required": ["ratios"], "oneOf": each_required(&["modes", "periods"]),
        "not": { "anyOf": each_required(&["mass", "stiffness"]) } });
    let by_factors = json!({ "not": { "anyOf": each_required(&["ratios", "modes", "periods"]) } });
    schema["anyOf"] = json!([by_factors, by_ratios]);
    schema
}

/// A column of a file.
fn column() -> Json {
    let text = || json!({ "type": "string" });
    json!({ "anyOf": [text(), described(keys::COLUMN, |_| text(), &["column"])] })
}

/// What was measured.
fn measured() -> Json {
    let value = |key: &str| match key {
        "file" => {
            let text = || json!({ "type": "string" });
            let list = json!({ "type": "array", "minItems": FEWEST_TESTS, "items": text() });
            json!({ "anyOf": [text(), list, files()] })
        }
        "compare" => json!({ "enum": keys::COMPARE, "default": keys::COMPARE[0] }),
        "time" => column(),
        "columns" => named(column()),
        _ => any(),
    };
    let required = keys::names(&keys::MEASURED[..3]);
    described(keys::MEASURED, value, &required)
}

/// Values of a parameter with a free name.
fn axis_values() -> Json {
    let mut values = free_values();
    if let Some(forms) = values["anyOf"].as_array_mut() {
        forms.push(files());
    }
    values
}

/// The same without files.
pub(super) fn free_values() -> Json {
    let list = json!({ "type": "array", "minItems": 1, "items": { "type": ["number", "string"] } });
    json!({ "anyOf": [{ "type": "number" }, refer(EXPRESSION), list, refer(RULE), refer(INTERVAL)] })
}

/// All files of a folder or a pattern.
fn files() -> Json {
    let value = |key: &str| match key {
        "files" => json!({ "type": "string" }),
        _ => choose(),
    };
    described(keys::FILES, value, &["files"])
}

/// A choice among files.
fn choose() -> Json {
    let value = |key: &str| match key {
        "T" | "median" | "sigma" => {
            let one = number(keys::range(keys::CHOOSE, key));
            json!({ "type": "array", "items": one, "minItems": 1 })
        }
        "unit" => json!({ "enum": Unit::ALL.map(Unit::name) }),
        "pair" => json!({ "type": "string" }),
        "component" => json!({ "enum": Component::ALL.map(Component::name) }),
        _ => number(keys::range(keys::CHOOSE, key)),
    };
    let needed = ["n", "T", "median", "sigma", "unit"];
    let mut schema = described(keys::CHOOSE, value, &needed);
    schema["dependencies"] =
        json!({ "factor": ["at"], "pair": ["component"], "component": ["pair"] });
    schema
}
