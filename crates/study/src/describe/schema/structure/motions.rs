//! The schema of loads, supports and functions of time.

use super::rules::{all_numbers, any, described, each_required, none_of};
use super::{add_properties, column, files, numbers};
use crate::describe::schema::values::{number, whole};
use crate::structure::keys::{self, FUNCTION, FUNCTIONS};
use serde_json::{Value as Json, json};
use slipgap_problem::problem::structure::given::supports::Line;
use slipgap_system::system::loads::Unit;
use slipgap_system::system::loads::pair::Component;
use slipgap_system::system::loads::pulse::PULSES;
use slipgap_system::system::loads::record::Mean;
use slipgap_system::system::loads::target::Fit;
use slipgap_system::system::structure::Baseline;

/// Keys of a function with points.
const OF_POINTS: [&str; 5] = ["start", "end", "baseline", "scale_to", "delay"];

/// Keys of a record.
const OF_RECORD: [&str; 5] = ["unit", "mean", "column", "dt", "component"];

/// Most seeds of synthetic motions.
const SEEDS: u64 = u32::MAX as u64;

/// A function of time: exactly one kind, with the keys of this kind.
pub(super) fn function() -> Json {
    let mut schema = described(FUNCTION, function_value, &[]);
    let kinds = keys::names(&FUNCTION[..FUNCTIONS]);
    schema["oneOf"] = each_required(&kinds);
    schema["dependencies"] = dependencies();
    schema
}

/// What a key of a function needs or excludes.
fn dependencies() -> Json {
    let mut needs = json!({ "sine": none_of(&OF_POINTS) });
    for key in OF_RECORD {
        needs[key] = json!(["record"]);
    }
    needs
}

/// A load: a function with its node.
pub(super) fn load() -> Json {
    let mut schema = function();
    schema["properties"]["at"] = json!({ "type": "string", "description": keys::LOAD_AT.1 });
    schema["required"] = json!(["at"]);
    schema
}

/// A function in each direction.
fn by_directions(function: &Json) -> Json {
    let mut schema = described(keys::GROUND, |_| function.clone(), &[]);
    schema["anyOf"] = each_required(&keys::names(keys::GROUND));
    schema
}

/// The ground: a function in x, or one in each direction.
pub(super) fn ground(function: &Json) -> Json {
    let mut schema = by_directions(function);
    let strength = described(&[keys::OF_GROUND], |_| scale_to(true), &[]);
    add_properties(&mut schema, &strength);
    schema["dependencies"] = json!({ "scale_to": ["x", "y"] });
    json!({ "anyOf": [function, schema] })
}

fn function_value(key: &str) -> Json {
    match key {
        "sine" => all_numbers(keys::SINE, &["amplitude", "omega"]),
        "table" => described(keys::TABLE, |_| numbers(), &["t", "f"]),
        "record" => json!({ "anyOf": [{ "type": "string" }, files()] }),
        "unit" => json!({ "anyOf": [{ "enum": Unit::ALL.map(Unit::name) }, parameter()] }),
        "mean" => json!({ "enum": Mean::ALL.map(Mean::name) }),
        "column" | "component" => {
            let number = json!({ "type": "integer", "minimum": 1, "maximum": 1_000_000 });
            json!({ "anyOf": [number, parameter()] })
        }
        "baseline" => json!({ "enum": Baseline::ALL.map(Baseline::name) }),
        "scale_to" => json!({ "anyOf": [scale_to(false), { "const": keys::AS_GROUND }] }),
        "pulse" => pulse(),
        "synthetic" => {
            let seed = whole(0, SEEDS);
            let mut object = all_numbers(keys::SYNTHETIC, &["seed"]);
            object["properties"]["seed"]["anyOf"] = seed["anyOf"].clone();
            json!({ "anyOf": [object, seed] })
        }
        _ => number(keys::range(FUNCTION, key)),
    }
}

/// The name of a parameter.
fn parameter() -> Json {
    json!({ "type": "string", "pattern": "^[A-Za-z_][A-Za-z0-9_]*$" })
}

/// A pulse of one form.
fn pulse() -> Json {
    let numbers = |name: &str| {
        let pulse = PULSES.iter().find(|pulse| pulse.name == name);
        let keys = pulse.map_or(&[][..], |pulse| pulse.numbers);
        described(keys, |key| number(keys::of_pulse(key)), &keys::names(keys))
    };
    let forms = PULSES.map(|pulse| (pulse.name, pulse.meaning));
    let mut schema = described(&forms, numbers, &[]);
    schema["oneOf"] = each_required(&PULSES.map(|pulse| pulse.name));
    schema
}

/// The strength of a motion; of `together`, that of x and y.
fn scale_to(together: bool) -> Json {
    let components = names_of(Component::ALL.map(Component::name));
    let value = |key: &str| match key {
        "spectrum" => spectrum(),
        "unit" => names_of(Unit::ALL.map(Unit::name)),
        "fit" => names_of(Fit::ALL.map(Fit::name)),
        "component" if together => components.clone(),
        "component" => json!({ "const": "each" }),
        "set" => set(),
        _ => number(keys::range(keys::SCALE_TO, key)),
    };
    let mut schema = described(keys::SCALE_TO, value, &[]);
    schema["oneOf"] = each_required(&keys::names(&keys::SCALE_TO[..keys::GOALS]));
    schema["dependencies"] = json!({
        "T": ["Sa"],
        "Sa": ["T"],
        "from": ["spectrum"],
        "to": ["spectrum"],
        "fit": ["spectrum"],
        "spectrum": ["from", "to"],
        "factor": ["set"],
        "ratio": { "anyOf": [{ "not": { "required": ["pga"] } }, { "required": ["set"] }] },
    });
    schema
}

/// A target spectrum.
fn spectrum() -> Json {
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
    spectrum
}

/// A set of motions.
fn set() -> Json {
    let value = |key: &str| match key {
        "rule" => names_of(keys::RULES.map(|rule| rule.name)),
        "period" => {
            let one = number(keys::range(keys::SET, key));
            json!({ "anyOf": [one, { "type": "array", "items": one, "minItems": 1 }] })
        }
        "statistic" => names_of(keys::STATISTICS.map(|row| row.0)),
        "component" => names_of(Component::ALL.map(Component::name)),
        "spectrum" => spectrum(),
        _ => number(keys::range(keys::SET, key)),
    };
    let mut schema = described(keys::SET, value, &[]);
    schema["dependencies"] = json!({ "period": ["rule"] });
    schema
}

/// One of some names.
fn names_of<const N: usize>(names: [&str; N]) -> Json {
    json!({ "enum": names.as_slice() })
}

/// A support: a function of time in x, or one in each direction, with its delay.
pub(super) fn support(function: &Json) -> Json {
    let mut schema = described(FUNCTION, function_value, &[]);
    schema["dependencies"] = dependencies();
    let mut kinds = keys::names(&FUNCTION[..FUNCTIONS]);
    kinds.push(keys::DISPLACEMENT.0);
    let mut courses = each_required(&kinds);
    let mut moving = described(FUNCTION, function_value, &[]);
    let velocity = described(&[keys::VELOCITY], |_| any(), &[keys::VELOCITY.0]);
    add_properties(&mut moving, &velocity);
    moving["required"] = velocity["required"].clone();
    moving["dependencies"] = dependencies();
    let course = json!({ "anyOf": [function, all_of_displacement(), moving] });
    let directions = by_directions(&course);
    if let Some(courses) = courses.as_array_mut() {
        courses.push(json!({ "anyOf": directions["anyOf"] }));
        courses.push(
            json!({ "required": [keys::VELOCITY.0], "not": { "anyOf": each_required(&kinds) } }),
        );
    }
    schema["oneOf"] = courses;
    let of_support = described(
        keys::SUPPORT,
        |key| match key {
            "baseline" => json!({ "enum": Baseline::ALL.map(Baseline::name) }),
            "displacement" => imposed(),
            _ => number(keys::range(keys::SUPPORT, key)),
        },
        &[],
    );
    for more in [directions, of_support] {
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
    let between = || names_of(Line::ALL.map(Line::name));
    let file = |key: &str| match key {
        "file" => json!({ "type": "string" }),
        "between" => between(),
        _ => column(),
    };
    let list = |key: &str| match key {
        "between" => between(),
        _ => numbers(),
    };
    let by_file = keys::names(&keys::IMPOSED_BY_FILE[..3]);
    let sine = |_: &str| all_numbers(keys::SINE, &["amplitude", "omega"]);
    json!({ "anyOf": [
        described(keys::IMPOSED, list, &["t", "u"]),
        described(keys::IMPOSED_BY_FILE, file, &by_file),
        described(keys::IMPOSED_SINE, sine, &["sine"]),
    ] })
}
