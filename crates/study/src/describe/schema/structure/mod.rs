//! The schema of studies of structures, whose parameters, channels and metrics have free names.

mod motions;
mod results;

use motions::{contact_value, function_value, support};
use results::{check, figure, metric};

use crate::describe::schema::parts::{
    block_keys, calibrate, computed, listed_metrics, reduction, several,
};
use crate::describe::schema::values::{INTERVAL, RULE, expression, names, number, object, refer};
use crate::figure::kinds::KINDS;
use crate::structure::keys::{self, Keys};
use serde_json::{Map, Value as Json, json};
use slipgap_problem::problem::method::PARAMETERS;
use slipgap_problem::problem::numbers::parameter::Range;
use slipgap_problem::problem::structure::tables::schema::{FIXED, MEANING, NAME};
use slipgap_system::system::structure::Direction;

/// The rules for studies of structures.
pub(super) fn rules(definitions: &mut Map<String, Json>) -> Json {
    let mut define = |what: &str, schema: Json| {
        let name = format!("{NAME}.{what}");
        definitions.insert(name.clone(), schema);
        refer(&name)
    };
    let function = define("function", described(keys::FUNCTION, function_value, &[]));
    let mut of_laws = |what: &str, keys: Keys| {
        let mut one = described(keys, |key| contact_value(key, &function), &[]);
        let relations = ["law"].into_iter().chain(keys::LISTS.map(|list| list.0));
        let relations = relations.map(|key| json!({ "required": [key] }));
        one["oneOf"] = relations.collect();
        define(what, one)
    };
    let contact = of_laws("contact", &keys::CONTACT);
    of_laws(PART, &keys::PART);
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

/// What a list of laws consists of.
const PART: &str = "part";

/// The name of its definition.
fn part() -> String {
    format!("{NAME}.{PART}")
}

/// An object with these keys; `value` gives the schema of each.
fn described(keys: Keys, value: impl Fn(&str) -> Json, required: &[&str]) -> Json {
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

/// An object with free names as keys.
fn named(one: Json) -> Json {
    json!({ "type": "object", "additionalProperties": one, "properties": { "//": { "description": "a remark" } } })
}

fn any() -> Json {
    number(Range::Any)
}

fn parameters() -> Json {
    let mut schema = named(axis_values());
    for (name, meaning) in FIXED {
        let mut value = axis_values();
        value["description"] = meaning.into();
        schema["properties"][name] = value;
    }
    for parameter in PARAMETERS.iter() {
        let mut value = axis_values();
        value["description"] = parameter.meaning.as_ref().into();
        schema["properties"][parameter.name.as_ref()] = value;
    }
    schema
}

fn between() -> Json {
    json!({ "type": "array", "minItems": 2, "maxItems": 2, "items": { "type": "string" } })
}

/// Nodes with their factors.
fn along() -> Json {
    json!({ "type": "object", "minProperties": 1, "additionalProperties": any() })
}

fn direction() -> Json {
    json!({ "enum": Direction::TRANSLATIONS.map(Direction::name), "default": Direction::X.name() })
}

/// Numbers, but a direction under its key.
fn moving(keys: Keys, required: &[&str]) -> Json {
    let value = |key: &str| match key {
        "direction" => direction(),
        _ => any(),
    };
    described(keys, value, required)
}

fn numbers() -> Json {
    json!({ "type": "array", "minItems": 1, "items": any() })
}

fn all_numbers(keys: Keys, required: &[&str]) -> Json {
    described(keys, |_| any(), required)
}

/// Adds the properties of a schema to those of another one.
fn add_properties(schema: &mut Json, more: &Json) {
    if let (Json::Object(to), Json::Object(from)) = (&mut schema["properties"], &more["properties"])
    {
        to.extend(from.clone());
    }
}

fn structure(function: &Json, contact: &Json) -> Json {
    let load = || {
        let mut schema = described(keys::FUNCTION, function_value, &["at"]);
        schema["properties"]["at"] = json!({ "type": "string", "description": keys::LOAD_AT.1 });
        schema
    };
    let value = |key: &str| match key {
        "units" => json!({ "type": "string" }),
        "masses" => {
            let object = moving(keys::MASS, &["mass"]);
            named(json!({ "anyOf": [any(), object] }))
        }
        "bars" => named(moving(keys::BAR, &["L", "EA", "mass", "n"])),
        "matrices" => {
            let value = |key: &str| match key {
                "reduce" => {
                    let mut reduce = all_numbers(keys::REDUCE, &[]);
                    reduce["minProperties"] = 1.into();
                    reduce["maxProperties"] = 1.into();
                    reduce
                }
                "dofs" => {
                    let row = json!({ "type": "array", "minItems": 2, "maxItems": 5 });
                    json!({ "anyOf": [{ "type": "string" }, { "type": "array", "items": row }] })
                }
                _ => json!({ "type": "string" }),
            };
            named(described(keys::MATRICES, value, &["M", "K", "dofs"]))
        }
        "springs" => {
            let spring = |key: &str| match key {
                "between" => between(),
                "along" => along(),
                "direction" => direction(),
                "name" => json!({ "type": "string", "pattern": "^[A-Za-z_][A-Za-z0-9_]*$" }),
                _ => any(),
            };
            let spring = described(keys::SPRING, spring, &[]);
            json!({ "type": "array", "items": spring })
        }
        "rayleigh" => all_numbers(keys::RAYLEIGH, &[]),
        "contacts" => named(contact.clone()),
        "loads" => json!({ "type": "array", "items": load() }),
        "ground" => {
            let directions = described(keys::GROUND, |_| function.clone(), &[]);
            json!({ "anyOf": [function.clone(), directions] })
        }
        "supports" => named(support(function)),
        "static" => {
            let gravity = json!({ "anyOf": [any(), all_numbers(keys::GROUND, &[])] });
            let mut loads = named(any());
            loads["properties"] = json!({ keys::GRAVITY.0: gravity });
            loads
        }
        "start" => named(all_numbers(keys::START, &[])),
        "contacts_reference" => json!({ "enum": keys::REFERENCES }),
        "damping_stiffness" => {
            let [first, ..] = keys::DAMPING_STIFFNESSES;
            json!({ "enum": keys::DAMPING_STIFFNESSES, "default": first })
        }
        _ => any(),
    };
    described(keys::STRUCTURE, value, &[])
}

/// A column of a file.
fn column() -> Json {
    let text = || json!({ "type": "string" });
    json!({ "anyOf": [text(), described(keys::COLUMN, |_| text(), &["column"])] })
}

/// What was measured.
fn measured() -> Json {
    let value = |key: &str| match key {
        "file" => json!({ "anyOf": [{ "type": "string" }, files()] }),
        "time" => column(),
        "columns" => named(column()),
        _ => any(),
    };
    let required = keys::names(&keys::MEASURED[..3]);
    described(keys::MEASURED, value, &required)
}

/// Values of a parameter with a free name.
fn axis_values() -> Json {
    let list = json!({ "type": "array", "minItems": 1, "items": { "type": ["number", "string"] } });
    json!({ "anyOf": [{ "type": "number" }, expression(), list, refer(RULE), refer(INTERVAL), files()] })
}

/// All files of a folder or a pattern.
fn files() -> Json {
    described(keys::FILES, |_| json!({ "type": "string" }), &["files"])
}
