//! The schema of figures and checks.

use super::parts::{pair, several, width};
use serde_json::{Map, Value as Json, json};

use super::values::{constant, names, number, object, ratio, refer, value};
use crate::decode::checks;
use crate::figure::decoded_value::MARKS;
use crate::figure::keys::{COMMON, FITS, Key, ORDINATES, RIDGES, SCALES, Takes};
use crate::figure::kinds::Kind;
use slipgap_problem::problem::Problem;
use slipgap_problem::problem::numbers::parameter::{self, Parameter, Range};

/// The name of a definition that belongs to a problem.
pub(super) fn name_of(problem: &dyn Problem, what: &str) -> String {
    format!("{}.{what}", problem.name())
}

/// The rules for figures of one kind.
pub(super) fn of_kind(kind: &Kind, problem: &dyn Problem) -> Json {
    rules(kind, kind.suits(problem), |key| taken(key, problem))
}

/// The same with what the keys take; figures of a kind that does not suit the problem are refused.
pub(super) fn rules(kind: &Kind, suits: bool, taken: impl Fn(&Key) -> Json) -> Json {
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
    let then = match suits {
        true => object(properties, &required),
        false => json!(false),
    };
    json!({
        "if": { "properties": { "kind": { "const": kind.name } }, "required": ["kind"] },
        "then": then,
    })
}

/// The name of a parameter; of one that is a number, if `numeric`.
pub(super) fn parameter_names(problem: &dyn Problem, numeric: bool) -> Json {
    let table = problem.parameters().iter();
    let suitable = table.filter(|p| !numeric || !matches!(p.kind, parameter::Kind::Choice(_)));
    names(suitable.map(|p| (&*p.name, &*p.meaning)))
}

/// The value of a key of a figure.
pub(super) fn taken(key: &Key, problem: &dyn Problem) -> Json {
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
        Takes::Filter => defined("where"),
        Takes::Parameter => parameters(false),
        Takes::Parameters => several(parameters(false)),
        Takes::NumericParameter => parameters(true),
        Takes::Quantity => quantities(),
        Takes::Quantities => several(quantities()),
        Takes::Number => number(Range::Any),
        Takes::Column => json!({ "anyOf": [parameters(true), defined("column")] }),
        Takes::Columns => several(json!({ "anyOf": [parameters(true), defined("column")] })),
        Takes::Profile => profiles(),
        Takes::Profiles => several(profiles()),
        Takes::Metric => defined("column"),
        Takes::Metrics => several(defined("column")),
        Takes::Budgets => several(names(
            problem
                .schema()
                .budgets
                .iter()
                .map(|b| (&*b.name, &*b.title)),
        )),
        Takes::Marks => marks(),
        Takes::InUnits if problem.schema().units.is_empty() => json!({ "const": false }),
        Takes::InUnits => json!({ "type": "boolean", "default": false }),
        Takes::FileName
        | Takes::Kind
        | Takes::Text
        | Takes::Times
        | Takes::Width
        | Takes::Range
        | Takes::Scale
        | Takes::ScaleOrLog
        | Takes::Ridge
        | Takes::Fit
        | Takes::Switch
        | Takes::Ordinates
        | Takes::Ratios
        | Takes::Periods
        | Takes::Probabilities
        | Takes::Hazard => of_any_problem(key.takes),
    }
}

/// The value of a key that takes the same for every problem; a text for others.
pub(super) fn of_any_problem(takes: Takes) -> Json {
    match takes {
        Takes::FileName => {
            json!({ "type": "string", "pattern": "^[A-Za-z0-9_][A-Za-z0-9_-]{0,99}$" })
        }
        Takes::Kind => json!({}),
        Takes::Ordinates => several(names(ORDINATES.into_iter())),
        Takes::Ratios => several(ratio()),
        Takes::Times => several(number(Range::NotNegative)),
        Takes::Width => width(),
        Takes::Range | Takes::Periods | Takes::Probabilities => pair(),
        Takes::Hazard => {
            let mut point = pair();
            point["items"] = number(Range::Positive);
            json!({ "type": "array", "minItems": 2, "items": point })
        }
        Takes::Switch => json!({ "type": "boolean" }),
        Takes::Ridge => json!({ "enum": RIDGES }),
        Takes::Fit => json!({ "enum": FITS, "default": FITS[0] }),
        Takes::Scale => json!({ "enum": SCALES, "default": SCALES[0] }),
        Takes::ScaleOrLog => json!({ "enum": SCALES, "default": SCALES[1] }),
        Takes::Text
        | Takes::Filter
        | Takes::Parameter
        | Takes::Parameters
        | Takes::NumericParameter
        | Takes::Quantity
        | Takes::Quantities
        | Takes::Column
        | Takes::Columns
        | Takes::Profile
        | Takes::Profiles
        | Takes::Metric
        | Takes::Metrics
        | Takes::Budgets
        | Takes::Marks
        | Takes::InUnits
        | Takes::Number => json!({ "type": "string" }),
    }
}

pub(super) fn marks() -> Json {
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
pub(super) fn filter(problem: &dyn Problem) -> Json {
    let table = problem.parameters().iter();
    let term = |p: &Parameter| {
        let list = json!({ "type": "array", "minItems": 1, "items": value(p) });
        let schema = json!({ "anyOf": [value(p), list], "description": p.meaning });
        (p.name.to_string(), schema)
    };
    object(table.map(term).collect(), &[])
}

pub(super) fn check(problem: &dyn Problem) -> Json {
    let mut properties = Map::new();
    for (key, meaning) in checks::KEYS {
        let mut schema = match key {
            "metric" => refer(&name_of(problem, "column")),
            "where" => refer(&name_of(problem, key)),
            _ => constant(),
        };
        schema["description"] = meaning.into();
        properties.insert(key.into(), schema);
    }
    let mut schema = object(properties, &["metric"]);
    schema["anyOf"] = json!([{ "required": ["min"] }, { "required": ["max"] }]);
    schema
}
