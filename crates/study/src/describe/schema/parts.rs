//! Parts of the schema that studies of all problems have.

use super::fields::{named, object, value};
use super::values::{EXPRESSION, number, refer};
use crate::calibrate;
use crate::computed::sources::NAMED;
use crate::figure::extent::WIDTHS;
use crate::reduction::OPERATORS;
use crate::source::field::Kind;
use serde_json::{Value as Json, json};
use slipgap_problem::problem::expression::FUNCTIONS;
use slipgap_problem::problem::numbers::parameter::Range;

/// The text of a reduction.
pub(super) fn reduction() -> Json {
    let words = OPERATORS.map(|word| word.0.replace('P', "[^ ]+"));
    json!({
        "type": "string",
        "pattern": format!("^({}) .+ over .+$", words.join("|")),
        "description": "a metric reduced over parameters, such as least rms_error over alpha",
    })
}

/// Arithmetic of metrics, or a ratio to a reference case.
pub(super) fn arithmetic() -> Json {
    let functions = FUNCTIONS.map(|row| row.0).join("|");
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
    let one = Kind::Named(&Kind::OneOf(&[Kind::Text, Kind::Object(&NAMED)]));
    let mut named = value(&one, &refer);
    named["propertyNames"] = json!({ "pattern": "^([A-Za-z][A-Za-z0-9_]*|//)$" });
    let item = json!({ "anyOf": [metric, arithmetic(), named.clone()] });
    let mut schema = named;
    schema["type"] = json!(["array", "object"]);
    schema["items"] = item;
    schema
}

pub(super) fn several(one: Json) -> Json {
    json!({ "anyOf": [one, { "type": "array", "minItems": 1, "items": one }] })
}

/// A width in mm.
pub(super) fn width() -> Json {
    let [least, most] = WIDTHS;
    let plain = json!({ "type": "number", "minimum": least, "maximum": most });
    json!({ "anyOf": [plain, refer(EXPRESSION)] })
}

/// The key `calibrate`.
pub(super) fn calibrate() -> Json {
    with_free(object(&calibrate::decode::KEYS, &refer))
}

/// The key `recommend`.
pub(super) fn recommend() -> Json {
    let tolerances = |_: &str| {
        let mut schema = named(number(Range::Positive));
        schema["minProperties"] = 1.into();
        schema
    };
    with_free(object(&calibrate::recommend::KEYS, &tolerances))
}

/// An object with ranges of free parameters, too.
fn with_free(mut schema: Json) -> Json {
    let log = object(&calibrate::range::LOG, &refer);
    schema["additionalProperties"] =
        json!({ "anyOf": [pair(), log], "description": "range of a free parameter" });
    schema
}

/// Two numbers.
pub(super) fn pair() -> Json {
    json!({ "type": "array", "minItems": 2, "maxItems": 2, "items": number(Range::Any) })
}
