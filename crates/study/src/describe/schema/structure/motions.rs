//! The schema of contacts, supports and functions of time.

use super::{
    add_properties, all_numbers, along, any, between, column, described, files, numbers, part,
};
use crate::describe::schema::values::{names, number, refer};
use crate::structure::keys::{self};
use serde_json::{Value as Json, json};
use slipgap_problem::problem::numbers::parameter::Range;
use slipgap_problem::problem::structure::parts::contacts::NAMES;
use slipgap_system::system::loads::Unit;
use slipgap_system::system::loads::record::Mean;
use slipgap_system::system::structure::Baseline;

pub(super) fn function_value(key: &str) -> Json {
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
pub(super) fn scale_to() -> Json {
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

pub(super) fn contact_value(key: &str, function: &Json) -> Json {
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

/// A support: a function of time in x, or one in each direction, with its delay.
pub(super) fn support(function: &Json) -> Json {
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
pub(super) fn all_of_displacement() -> Json {
    described(
        &[keys::DISPLACEMENT],
        |_| imposed(),
        &[keys::DISPLACEMENT.0],
    )
}

pub(super) fn imposed() -> Json {
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
