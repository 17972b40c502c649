//! Parts of the schema that studies of all problems have.

use super::values::{EXPRESSION, names, number, object, refer};
use crate::axes::design;
use crate::calibrate;
use crate::computed::sources::NAMED;
use crate::decode::blocks::BLOCK_KEYS;
use crate::figure::extent::WIDTHS;
use crate::reduction::OPERATORS;
use serde_json::{Map, Value as Json, json};
use slipgap_problem::problem::expression::FUNCTIONS;
use slipgap_problem::problem::numbers::parameter::Range;

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
    let mut properties = Map::new();
    for ((key, meaning), schema) in calibrate::decode::KEYS.into_iter().zip([
        json!({ "type": "string" }),
        number(Range::NotNegative),
        number(Range::Positive),
        several(json!({ "type": "string" })),
    ]) {
        let mut schema = schema;
        schema["description"] = meaning.into();
        properties.insert(key.into(), schema);
    }
    with_free(properties, &[calibrate::decode::KEYS[0].0])
}

/// The key `recommend`.
pub(super) fn recommend() -> Json {
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
pub(super) fn pair() -> Json {
    json!({ "type": "array", "minItems": 2, "maxItems": 2, "items": number(Range::Any) })
}
