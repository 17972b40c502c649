//! The schema of studies of structures, whose parameters, channels and metrics have free names.

use super::schema::{
    block_keys, calibrate, computed, listed_metrics, reduction, several, width_and_pair,
};
use super::values::{INTERVAL, RULE, expression, names, number, object, ratio, refer};
use crate::decode::checks;
use crate::figure::keys::{COMMON, FITS, Key, ORDINATES, RIDGES, SCALES, Takes};
use crate::figure::kinds::{KINDS, Needs};
use crate::structure::keys::{self, Keys};
use serde_json::{Map, Value as Json, json};
use slipgap_solver::problem::method::PARAMETERS;
use slipgap_solver::problem::parameter::Range;
use slipgap_solver::problem::structure::contacts::NAMES;
use slipgap_solver::problem::structure::ground_metric::PREFIX;
use slipgap_solver::problem::structure::metric::REDUCTIONS;
use slipgap_solver::problem::structure::schema::{FIXED, MEANING, NAME};
use slipgap_solver::system::loads::Unit;
use slipgap_solver::system::loads::record::Mean;
use slipgap_solver::system::structure::{Baseline, Direction};

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

fn function_value(key: &str) -> Json {
    match key {
        "sine" => all_numbers(keys::SINE, &["amplitude", "omega"]),
        "table" => described(keys::TABLE, |_| numbers(), &["t", "f"]),
        "record" => json!({ "anyOf": [{ "type": "string" }, files()] }),
        "unit" => json!({ "enum": Unit::ALL.map(Unit::name) }),
        "mean" => json!({ "enum": Mean::ALL.map(Mean::name) }),
        "column" | "component" => json!({ "type": "integer", "minimum": 1 }),
        "dt" => number(Range::Positive),
        "baseline" => json!({ "enum": Baseline::ALL.map(Baseline::name) }),
        "scale_to" => scale_to(),
        "pulse" => described(
            keys::PULSE,
            |key| match key {
                "ricker" => all_numbers(keys::RICKER, &keys::names(keys::RICKER)),
                _ => all_numbers(keys::COSINE, &keys::names(keys::COSINE)),
            },
            &[],
        ),
        "synthetic" => json!({ "anyOf": [all_numbers(keys::SYNTHETIC, &["seed"]), any()] }),
        _ => any(),
    }
}

/// The strength of a motion.
fn scale_to() -> Json {
    let mut spectrum = described(
        keys::SPECTRUM,
        |key| match key {
            "ASCE 7" => all_numbers(keys::ASCE_7, &keys::names(keys::ASCE_7)),
            _ => all_numbers(keys::EN_1998, &keys::names(keys::EN_1998)),
        },
        &[],
    );
    add_properties(
        &mut spectrum,
        &described(keys::TARGET_TABLE, |_| numbers(), &[]),
    );
    described(
        keys::SCALE_TO,
        |key| match key {
            "spectrum" => spectrum.clone(),
            "unit" => json!({ "enum": Unit::ALL.map(Unit::name) }),
            _ => any(),
        },
        &[],
    )
}

/// Adds the properties of a schema to those of another one.
fn add_properties(schema: &mut Json, more: &Json) {
    if let (Json::Object(to), Json::Object(from)) = (&mut schema["properties"], &more["properties"])
    {
        to.extend(from.clone());
    }
}

fn contact_value(key: &str, function: &Json) -> Json {
    match key {
        "law" => {
            json!({ "anyOf": [names(NAMES.iter().copied()), { "type": "string" }] })
        }
        "between" => between(),
        "along" => along(),
        "pairs" => json!({ "type": "string" }),
        "N" => {
            let table = described(keys::NORMAL_TABLE, |_| numbers(), &["t", "N"]);
            let value = |key: &str| match key {
                "vertical" => function.clone(),
                _ => any(),
            };
            let weight = described(keys::WEIGHT, value, &["weight", "vertical"]);
            let pressing = described(
                keys::PRESSING,
                |_| json!({ "anyOf": [{ "type": "string" }, { "type": "array", "minItems": 1, "items": { "type": "string" } }] }),
                &["contact"],
            );
            json!({ "anyOf": [any(), table, weight, pressing] })
        }
        "series" | "parallel" => {
            json!({ "type": "array", "minItems": 2, "items": refer(&part()) })
        }
        "table" => described(keys::LAW_TABLE, |_| numbers(), &["r", "S"]),
        _ => any(),
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

/// A support: a function of time in x, or one in each direction, with its delay.
fn support(function: &Json) -> Json {
    let mut schema = described(keys::FUNCTION, function_value, &[]);
    let course = json!({ "anyOf": [function, all_of_displacement()] });
    let directions = described(keys::GROUND, |_| course.clone(), &[]);
    let own = described(
        keys::SUPPORT,
        |key| match key {
            "baseline" => json!({ "enum": Baseline::ALL.map(Baseline::name) }),
            "displacement" => imposed(),
            _ => any(),
        },
        &[],
    );
    for more in [directions, own] {
        add_properties(&mut schema, &more);
    }
    schema
}

/// Imposed displacements under their key.
fn all_of_displacement() -> Json {
    described(
        &[keys::DISPLACEMENT],
        |_| imposed(),
        &[keys::DISPLACEMENT.0],
    )
}

fn imposed() -> Json {
    let file = |key: &str| match key {
        "file" => json!({ "type": "string" }),
        _ => column(),
    };
    let by_file = keys::names(keys::IMPOSED_BY_FILE);
    json!({ "anyOf": [
        described(keys::IMPOSED, |_| numbers(), &["t", "u"]),
        described(keys::IMPOSED_BY_FILE, file, &by_file),
    ] })
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

/// The name of a metric.
fn metric() -> Json {
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

fn check(metric: &Json) -> Json {
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
fn figure(kind: &crate::figure::kinds::Kind) -> Json {
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

fn taken(key: &Key) -> Json {
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

/// Values of a parameter with a free name.
fn axis_values() -> Json {
    let list = json!({ "type": "array", "minItems": 1, "items": { "type": ["number", "string"] } });
    json!({ "anyOf": [{ "type": "number" }, expression(), list, refer(RULE), refer(INTERVAL), files()] })
}

/// All files of a folder or a pattern.
fn files() -> Json {
    described(keys::FILES, |_| json!({ "type": "string" }), &["files"])
}
