//! Parts of the schema that occur several times, each written once as a definition.

use serde_json::{Map, Value as Json, json};
use std::collections::BTreeMap;

/// Lines of the longest part that is written out wherever it occurs: a reference with a description has as many.
const SHORT: usize = 6;

/// Keys next to a reference, which differ between uses of the same part.
const ANNOTATIONS: [&str; 2] = ["description", "default"];

/// Moves the parts that occur several times to the definitions. A part has the name of the first key under which it is.
pub(super) fn share(schema: &mut Json) {
    let mut parts = Parts::default();
    parts.count(schema);
    parts.replace_within(schema, "");
    if let Json::Object(definitions) = &mut schema["definitions"] {
        definitions.extend(parts.definitions);
    }
}

#[derive(Default)]
struct Parts {
    /// How often each part occurs, by its text; inside a part that occurs again nothing is counted again.
    counts: BTreeMap<String, usize>,
    names: BTreeMap<String, String>,
    definitions: Map<String, Json>,
}

impl Parts {
    fn count(&mut self, schema: &mut Json) {
        visit(schema, &mut |_, part, is_rule| {
            if let Some((text, _)) = long(part).filter(|_| !is_rule) {
                let count = self.counts.entry(text).or_default();
                *count += 1;
                if *count > 1 {
                    return;
                }
            }
            self.count(part);
        });
    }

    fn replace_within(&mut self, schema: &mut Json, key: &str) {
        visit(schema, &mut |within, part, is_rule| {
            let key = match (key, within) {
                (key, "") => key.to_owned(),
                ("", within) => within.to_owned(),
                (key, within) => format!("{key}.{within}"),
            };
            let repeated = long(part).filter(|(text, _)| {
                !is_rule && self.counts.get(text).is_some_and(|count| *count > 1)
            });
            let Some((text, body)) = repeated else {
                self.replace_within(part, &key);
                return;
            };
            let reference =
                json!({ "$ref": format!("#/definitions/{}", self.name(text, body, &key)) });
            let annotations = annotations(part);
            *part = match annotations.is_empty() {
                true => reference,
                // Draft 7 ignores other keys next to `$ref`.
                false => {
                    let mut annotated = Json::from(annotations);
                    annotated["allOf"] = json!([reference]);
                    annotated
                }
            };
        });
    }

    /// The name of a part, which becomes a definition when it first occurs.
    fn name(&mut self, text: String, mut body: Json, key: &str) -> String {
        if let Some(name) = self.names.get(&text) {
            return name.clone();
        }
        let plain = |c: char| {
            if c.is_ascii_alphanumeric() || "._-".contains(c) {
                c
            } else {
                '_'
            }
        };
        let key: String = format!("as.{key}").chars().map(plain).collect();
        let is_new = |name: &String| !self.names.values().any(|other| other == name);
        let name = std::iter::once(key.clone())
            .chain((2_u32..).map(|n| format!("{key}.{n}")))
            .find(is_new)
            .unwrap_or(key);
        self.names.insert(text, name.clone());
        self.replace_within(&mut body, name.trim_start_matches("as."));
        self.definitions.insert(name.clone(), body);
        name
    }
}

/// A part without its annotations, if it is long enough to be a definition, and its text.
fn long(part: &Json) -> Option<(String, Json)> {
    let keys = part.as_object()?.iter();
    let kept = keys.filter(|(key, _)| !ANNOTATIONS.contains(&key.as_str()));
    let body = Json::Object(
        kept.map(|(key, value)| (key.clone(), value.clone()))
            .collect(),
    );
    let is_reference = body.as_object()?.len() == 1 && body["allOf"][0]["$ref"].is_string();
    let text = format!("{body:#}");
    (!is_reference && text.lines().count() > SHORT).then_some((text, body))
}

fn annotations(part: &Json) -> Map<String, Json> {
    let keys = part.as_object().into_iter().flatten();
    let annotations = keys.filter(|(key, _)| ANNOTATIONS.contains(&key.as_str()));
    annotations
        .map(|(key, value)| (key.clone(), value.clone()))
        .collect()
}

/// Calls `each` with every schema directly within a schema, its key or name, and whether it is in a rule, `if` and `then`.
fn visit(schema: &mut Json, each: &mut dyn FnMut(&str, &mut Json, bool)) {
    for (keyword, value) in schema.as_object_mut().into_iter().flatten() {
        match (keyword.as_str(), value) {
            ("properties" | "dependencies" | "definitions", Json::Object(named)) => {
                let is_rule = keyword == "definitions";
                named
                    .iter_mut()
                    .for_each(|(key, part)| each(key, part, is_rule));
            }
            ("anyOf" | "allOf" | "oneOf", Json::Array(forms)) => {
                forms.iter_mut().for_each(|part| each("", part, false));
            }
            ("if" | "then" | "else", part) => each("", part, true),
            ("items" | "additionalProperties" | "not" | "propertyNames", part) => {
                each("", part, false);
            }
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Writes out the parts that `share` moved.
    fn expand(schema: &mut Json, definitions: &Json) {
        let keys = annotations(schema);
        // An annotated reference has no other keys than these and `allOf`.
        let is_annotated = schema
            .as_object()
            .is_some_and(|keywords| keywords.len() == keys.len() + 1);
        let reference = match keys.is_empty() || !is_annotated {
            true => schema["$ref"].as_str(),
            false => schema["allOf"][0]["$ref"].as_str(),
        };
        let name = reference.and_then(|text| text.strip_prefix("#/definitions/"));
        if let Some(name) = name.filter(|name| name.starts_with("as.")) {
            let mut part = definitions[name].clone();
            if let Json::Object(part) = &mut part {
                part.extend(keys);
            }
            *schema = part;
        }
        visit(schema, &mut |_, part, _| expand(part, definitions));
    }

    #[test]
    fn shared_parts_written_out_are_the_schema() {
        let whole = super::super::whole();
        let mut shared = whole.clone();
        share(&mut shared);
        let definitions = shared["definitions"].clone();
        if let Json::Object(named) = &mut shared["definitions"] {
            named.retain(|name, _| !name.starts_with("as."));
        }
        assert_ne!(shared, whole);
        expand(&mut shared, &definitions);
        assert_eq!(shared, whole);
    }
}
