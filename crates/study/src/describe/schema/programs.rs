//! Programs of others in the schema: a study that has some may name them as methods.

use crate::structure::programs::KEY;
use serde_json::{Value as Json, json};

/// The parameter that chooses the method.
const METHOD: &str = "method";

/// Lets a method be the name of a program. Returns the methods of a study without programs.
pub(super) fn with_programs(parameters: &mut Json) -> Json {
    let method = &mut parameters["properties"][METHOD];
    let known = json!({ "anyOf": method["anyOf"] });
    let name = json!({ "type": "string" });
    let list = json!({ "type": "array", "minItems": 1, "items": name });
    if let Some(forms) = method["anyOf"].as_array_mut() {
        forms.extend([name, list]);
    }
    known
}

/// The rule of a problem that a study without programs has only these methods, and such other properties.
pub(super) fn known_without(method: &Json, others: Json) -> Json {
    let known = json!({ "properties": { METHOD: method } });
    let mut properties = others;
    properties["parameters"] = known.clone();
    properties["shared"] = known.clone();
    properties["blocks"] = json!({ "items": { "properties": { "parameters": known } } });
    let without = json!({ "not": { "required": [KEY.name] } });
    json!({ "if": without, "then": { "properties": properties } })
}
