//! The parameters of a problem and their values in JSON Schema.

use serde_json::{Map, Value as Json, json};

use slipgap_problem::problem::expression::{CONSTANTS, FUNCTIONS};
use slipgap_problem::problem::numbers::parameter::{
    Condition, Default, Kind, Parameter, Range, Value,
};

/// The `parameters` object, or the object under one of its keys.
pub(super) fn parameters(table: &[Parameter], prefix: &str) -> Json {
    let mut properties: Map<String, Json> = Map::new();
    let mut required = Vec::new();
    let mut conditions = Vec::new();
    // Keys that may be objects, as `right`.
    let mut objects = Vec::new();
    for parameter in table {
        let Some(rest) = parameter.name.strip_prefix(prefix) else {
            continue;
        };
        if let Some((key, _)) = rest.split_once('.') {
            if objects.contains(&key) {
                continue;
            }
            objects.push(key);
            let within = parameters(table, &format!("{prefix}{key}."));
            let mut schema = properties
                .remove(key)
                .unwrap_or_else(|| json!({ "anyOf": [] }));
            match schema.get_mut("anyOf").and_then(Json::as_array_mut) {
                Some(forms) => forms.push(within),
                None => schema = json!({ "anyOf": [schema, within] }),
            }
            properties.insert(key.into(), schema);
            continue;
        }
        properties.insert(rest.into(), axis(parameter));
        let needed = matches!(parameter.default, Default::Required);
        match &parameter.applies {
            None if needed => required.push(rest),
            Some(on) if prefix.is_empty() => {
                conditions.extend(condition(rest, on, needed, table));
            }
            None | Some(_) => {}
        }
    }
    let mut schema = object(properties, &required);
    if !conditions.is_empty() {
        schema["allOf"] = conditions.into();
    }
    schema
}

/// The rule that a parameter is required or allowed only with some names of its governor.
fn condition(key: &str, on: &Condition, needed: bool, table: &[Parameter]) -> Vec<Json> {
    let governor = on.governor;
    let of_governor = table.iter().find(|p| p.name == governor);
    let names: Vec<&str> = match of_governor.map(|p| p.kind) {
        Some(Kind::Choice(choices)) => choices.iter().map(|c| c.0).collect(),
        Some(Kind::Number(_) | Kind::Whole { .. }) | None => Vec::new(),
    };
    let others: Vec<&str> = names.into_iter().filter(|name| !on.allows(name)).collect();
    let when = |choice: Json| json!({ "properties": { governor: choice }, "required": [governor] });
    let mut refuse = when(json!({ "enum": others }));
    // A governor that is left out has its default.
    if let Some(Default::Is(value)) = of_governor.map(|p| &p.default)
        && !on.allows(value.name())
    {
        refuse = json!({ "properties": { governor: { "enum": others } } });
    }
    let refused = json!({ "if": refuse, "then": { "properties": { key: false } } });
    let chosen = match on.names {
        [one] => json!({ "const": one }),
        names => json!({ "enum": names }),
    };
    let required = json!({ "if": when(chosen), "then": { "required": [key] } });
    match needed {
        true => vec![required, refused],
        false => vec![refused],
    }
}

/// One value of a parameter or a list of them.
fn axis(parameter: &Parameter) -> Json {
    let one = value(parameter);
    let list = json!({ "type": "array", "minItems": 1, "items": one });
    let mut forms = vec![one.clone(), list];
    if !matches!(parameter.kind, Kind::Choice(_)) {
        forms.push(refer(RULE));
        forms.push(refer(INTERVAL));
    }
    let unit = match &*parameter.unit {
        "1" => String::new(),
        unit => format!(", in {unit}"),
    };
    let mut description = format!("{}{unit}; {}", parameter.meaning, allowed(parameter));
    if let Some(on) = &parameter.applies {
        description += &format!("; for {} {}", on.governor, on.choices());
    }
    let mut schema = json!({ "anyOf": forms });
    match &parameter.default {
        Default::Required => {}
        Default::Is(value) => {
            description += &format!("; default {value}");
            schema["default"] = match value {
                Value::Number(x) => json!(x),
                Value::Whole(n) => json!(n),
                Value::Name(name) => json!(name),
            };
        }
        Default::Follows(from) => description += &format!("; if left out, {from}"),
    }
    schema["description"] = description.into();
    schema
}

/// The range as text, or the names with their meanings.
pub(in crate::describe) fn allowed(parameter: &Parameter) -> String {
    match parameter.kind {
        Kind::Number(range) => range.to_string(),
        Kind::Whole { min, max } => format!("a whole number from {min} to {max}"),
        Kind::Choice(choices) => {
            let names = choices
                .iter()
                .map(|(name, meaning)| format!("{name}: {meaning}"));
            names.collect::<Vec<_>>().join("; ")
        }
    }
}

/// A single value of a parameter.
pub(super) fn value(parameter: &Parameter) -> Json {
    match parameter.kind {
        Kind::Number(range) => number(range),
        Kind::Whole { min, max } => whole(min, max),
        Kind::Choice(choices) => names(choices.iter().copied()),
    }
}

/// A whole number, or an expression.
pub(super) fn whole(min: u64, max: u64) -> Json {
    json!({ "anyOf": [{ "type": "integer", "minimum": min, "maximum": max }, refer(EXPRESSION)] })
}

/// A number in a range, or an expression.
pub(super) fn number(range: Range) -> Json {
    let plain = match range {
        Range::Positive => json!({ "type": "number", "exclusiveMinimum": 0 }),
        Range::Fraction => json!({ "type": "number", "exclusiveMinimum": 0, "maximum": 1 }),
        Range::ZeroOrOne => json!({ "enum": [0, 1] }),
        Range::FromTenthToTwo => json!({ "type": "number", "minimum": 0.1, "maximum": 2 }),
        Range::UpToOne => json!({ "type": "number", "minimum": 0, "maximum": 1 }),
        Range::AtMostOne => json!({ "type": "number", "maximum": 1 }),
        Range::AtLeastOne => json!({ "type": "number", "minimum": 1 }),
        Range::AtLeastHalf => json!({ "type": "number", "minimum": 0.5 }),
        Range::FromHalfToOne => json!({ "type": "number", "minimum": 0.5, "maximum": 1 }),
        Range::HilberHughesTaylor => {
            json!({ "type": "number", "minimum": -1.0 / 3.0, "maximum": 0 })
        }
        Range::NotNegative => json!({ "type": "number", "minimum": 0 }),
        Range::NotZero => json!({ "type": "number", "not": { "const": 0 } }),
        Range::Any => json!({ "type": "number" }),
    };
    json!({ "anyOf": [plain, refer(EXPRESSION)] })
}

/// Name of the definition of expressions.
pub(super) const EXPRESSION: &str = "expression";

/// Name of the definition of axes by rule.
pub(super) const RULE: &str = "rule";

/// Name of the definition of intervals.
pub(super) const INTERVAL: &str = "interval";

/// A damping ratio.
pub(super) fn ratio() -> Json {
    let plain = json!({ "type": "number", "minimum": 0, "exclusiveMaximum": 1 });
    json!({ "anyOf": [plain, refer(EXPRESSION)] })
}

/// An expression in a string.
pub(super) fn expression() -> Json {
    json!({
        "type": "string",
        "pattern": "^(?! *[-+]?[0-9.]+(,|_|[dD][-+]?)[0-9_]+ *$).*[0-9A-Za-z]",
        "description": "an expression: numbers, + - * / ^ ( ), pi, e, sqrt and other functions; the value of a parameter may also name other parameters",
    })
}

/// A number, or an expression without parameters.
pub(super) fn constant() -> Json {
    let functions = FUNCTIONS.iter().map(|row| row.0);
    let words: Vec<&str> = CONSTANTS.into_iter().chain(functions).collect();
    let text = json!({
        "type": "string",
        "pattern": format!("^([-+*/^(),. 0-9E]|{})+$", words.join("|")),
    });
    json!({ "anyOf": [{ "type": "number" }, text] })
}

/// One of several names. Editors that support `enumDescriptions` show the meanings.
pub(super) fn names<'a>(names: impl Iterator<Item = (&'a str, &'a str)>) -> Json {
    let (names, meanings): (Vec<&str>, Vec<&str>) = names.unzip();
    json!({ "enum": names, "enumDescriptions": meanings })
}

/// An object with these keys and remarks, and no others.
pub(super) fn object(mut properties: Map<String, Json>, required: &[&str]) -> Json {
    properties.insert("//".into(), json!({ "description": "a remark" }));
    json!({
        "type": "object",
        "properties": properties,
        "required": required,
        "additionalProperties": false,
    })
}

/// A reference to a definition. It is in `allOf` because draft 7 ignores other keys next to `$ref`.
pub(super) fn refer(name: &str) -> Json {
    json!({ "allOf": [{ "$ref": format!("#/definitions/{name}") }] })
}
