//! The schema of figures and checks.

use super::parts::{pair, several, width};
use serde_json::{Map, Value as Json, json};

use super::values::{constant, names, number, object, ratio, refer, value};
use crate::decode::checks;
use crate::figure::decoded_value::MARKS;
use crate::figure::keys::{COMMON, EACH, FITS, ORDINATES, RIDGES, SCALES, Takes};
use crate::figure::kinds::Kind;
use slipgap_problem::problem::Problem;
use slipgap_problem::problem::numbers::parameter::{self, Parameter, Range};

/// The name of a definition that belongs to a problem.
pub(super) fn name_of(problem: &dyn Problem, what: &str) -> String {
    format!("{}.{what}", problem.name())
}

/// The rules for figures of one kind; those of a kind that does not suit the problem are refused.
pub(super) fn rules(kind: &Kind, suits: bool, named: &Named) -> Json {
    let mut properties = Map::new();
    let mut required = Vec::new();
    for key in COMMON.iter().chain(kind.keys) {
        let mut schema = taken(key.takes, named);
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

/// What the keys of figures of a problem name, and other values that differ between problems.
pub(super) struct Named {
    pub(super) filter: Json,
    pub(super) parameter: Json,
    pub(super) numeric: Json,
    pub(super) quantity: Json,
    pub(super) profile: Json,
    pub(super) column: Json,
    pub(super) metric: Json,
    pub(super) budget: Json,
    pub(super) marks: Json,
    pub(super) number: Json,
    pub(super) has_units: bool,
}

impl Named {
    pub(super) fn of(problem: &dyn Problem) -> Named {
        let schema = problem.schema();
        let numeric = parameter_names(problem, true);
        let metric = refer(&name_of(problem, "column"));
        Named {
            filter: refer(&name_of(problem, "where")),
            parameter: parameter_names(problem, false),
            column: json!({ "anyOf": [numeric, metric] }),
            numeric,
            quantity: names(schema.quantities.iter().map(|q| (&*q.name, &*q.title))),
            profile: names(schema.profiles.iter().map(|p| (&*p.name, &*p.title))),
            metric,
            budget: names(schema.budgets.iter().map(|b| (&*b.name, &*b.title))),
            marks: marks(),
            number: number(Range::Any),
            has_units: !schema.units.is_empty(),
        }
    }
}

/// The value of a key of a figure.
fn taken(takes: Takes, named: &Named) -> Json {
    match takes {
        Takes::Filter => named.filter.clone(),
        Takes::Parameter => named.parameter.clone(),
        Takes::Parameters => several(named.parameter.clone()),
        Takes::NumericParameter => named.numeric.clone(),
        Takes::Quantity => named.quantity.clone(),
        Takes::Quantities => several(named.quantity.clone()),
        Takes::Number => named.number.clone(),
        Takes::Column => named.column.clone(),
        Takes::Columns => several(named.column.clone()),
        Takes::Profile => named.profile.clone(),
        Takes::Profiles => several(named.profile.clone()),
        Takes::Metric => named.metric.clone(),
        Takes::Metrics => several(named.metric.clone()),
        Takes::Budgets => several(named.budget.clone()),
        Takes::Marks => named.marks.clone(),
        Takes::InUnits if named.has_units => json!({ "type": "boolean", "default": false }),
        Takes::InUnits => json!({ "const": false }),
        Takes::FileName => {
            json!({ "type": "string", "pattern": "^[A-Za-z0-9_][A-Za-z0-9_-]{0,99}$" })
        }
        Takes::Kind => json!({}),
        Takes::Text => json!({ "type": "string" }),
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
        Takes::Each => json!({ "enum": EACH, "default": EACH[0] }),
        Takes::Scale => json!({ "enum": SCALES, "default": SCALES[0] }),
        Takes::ScaleOrLog => json!({ "enum": SCALES, "default": SCALES[1] }),
    }
}

fn marks() -> Json {
    let coordinates = pair();
    let mut properties = Map::new();
    for (key, meaning) in MARKS {
        properties.insert(
            key.into(),
            match key {
                "at" => json!({ "type": "array", "items": coordinates, "description": meaning }),
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
