//! The schema of objects, from the tables of their keys.

use super::values::{self, constant, names, number, whole};
use crate::source::field::{ANY, Field, Keys, Kind, Rule};
use serde_json::{Map, Value as Json, json};
use slipgap_problem::problem::numbers::parameter::Range;
use slipgap_system::system::structure::Direction;

/// Gives the definitions of a problem by their names.
pub(super) type Shared<'a> = &'a dyn Fn(&str) -> Json;

/// An object with these keys and no others.
pub(super) fn object(keys: &Keys, shared: Shared) -> Json {
    let needed = keys.fields().filter(|field| field.needed);
    let needed: Vec<&str> = needed.map(|field| field.name).collect();
    let mut schema = values::object(properties(keys.fields(), shared), &needed);
    add(&mut schema, keys.rules);
    schema
}

/// The value of each key with its meaning.
pub(super) fn properties(
    fields: impl Iterator<Item = &'static Field>,
    shared: Shared,
) -> Map<String, Json> {
    let one = |field: &Field| {
        let mut schema = value(&field.kind, shared);
        schema["description"] = field.meaning.into();
        (field.name.to_owned(), schema)
    };
    fields.map(one).collect()
}

/// A value of a key.
pub(super) fn value(kind: &Kind, shared: Shared) -> Json {
    match kind {
        Kind::Any => json!({}),
        Kind::Number(range) | Kind::Likely(_, range) => number(*range),
        Kind::Constant => constant(),
        Kind::Whole([least, most]) => whole(*least, *most),
        Kind::Count(most) => json!({ "type": "integer", "minimum": 1, "maximum": most }),
        Kind::Text => json!({ "type": "string" }),
        Kind::Like(form) => json!({ "type": "string", "pattern": form }),
        Kind::Words(_, names, None) => match &names()[..] {
            [one] => json!({ "const": one }),
            several => json!({ "enum": several }),
        },
        Kind::Words(_, names, Some(_)) => json!({ "enum": names(), "default": names()[0] }),
        Kind::Meant(meanings) => names(meanings().iter().copied()),
        Kind::Chooses(meanings) => chooses(meanings().iter().map(|row| row.0)),
        Kind::Shared(name) => shared(name),
        Kind::Object(keys) => object(keys, shared),
        Kind::Named(one) => named(value(one, shared)),
        Kind::Parts(one) => parts(value(one, shared)),
        Kind::Factors => {
            json!({ "type": "object", "minProperties": 1, "additionalProperties": number(Range::Any) })
        }
        Kind::Directions => {
            let one = json!({ "enum": Direction::TRANSLATIONS.map(Direction::name) });
            json!({ "type": "array", "minItems": 2, "maxItems": 2, "uniqueItems": true, "items": one })
        }
        Kind::List(one, counts) => list(value(one, shared), *counts),
        Kind::Several(one, counts) => {
            let one = value(one, shared);
            json!({ "anyOf": [one, list(one, *counts)] })
        }
        Kind::OneOf(kinds) => {
            let forms = kinds.iter().map(|kind| value(kind, shared));
            json!({ "anyOf": forms.collect::<Vec<_>>() })
        }
    }
}

/// The name of a parameter, and none of these names in other letters or with another hyphen.
fn chooses(names: impl Iterator<Item = &'static str>) -> Json {
    let any_letters = |name: &str| -> String {
        let form = |c: char| match c {
            '-' => "[-_ ]?".to_owned(),
            c => format!("[{}{c}]", c.to_ascii_uppercase()),
        };
        name.chars().map(form).collect()
    };
    let forms: Vec<String> = names.map(any_letters).collect();
    json!({ "type": "string", "not": { "pattern": format!("^({})$", forms.join("|")) } })
}

fn list(one: Json, [least, most]: [usize; 2]) -> Json {
    let mut schema = json!({ "type": "array" });
    if least > 0 {
        schema["minItems"] = least.into();
    }
    if most < ANY {
        schema["maxItems"] = most.into();
    }
    if one != json!({}) {
        schema["items"] = one;
    }
    schema
}

/// An object with free names as keys.
pub(super) fn named(one: Json) -> Json {
    json!({ "type": "object", "additionalProperties": one, "properties": { "//": { "description": "a remark" } } })
}

/// Parts by names, several alike as `a|b`; no part is called `ground`.
fn parts(one: Json) -> Json {
    let mut schema = named(one);
    let name = "(?! *ground *(\\||$)) *[A-Za-z_][A-Za-z0-9_]* *";
    schema["propertyNames"] = json!({ "pattern": format!("^({name}(\\|{name})*|//)$") });
    schema
}

/// Adds rules to the schema of an object.
pub(super) fn add(schema: &mut Json, rules: &[Rule]) {
    for rule in rules {
        match rule {
            Rule::One(keys, forms) => schema["oneOf"] = each(keys, forms),
            Rule::Any(keys, forms) => schema["anyOf"] = each(keys, forms),
            Rule::All(forms) => schema["allOf"] = each(&[], forms),
            Rule::Has(keys) => schema["required"] = json!(keys),
            Rule::No(keys) => schema["not"] = json!({ "anyOf": each(keys, &[]) }),
            Rule::NotAll(keys) => schema["not"] = json!({ "required": keys }),
            Rule::With(keys, needs) => {
                for key in *keys {
                    schema["dependencies"][*key] = match needs {
                        [Rule::Has(others)] => json!(others),
                        needs => conjunction(needs),
                    };
                }
            }
        }
    }
}

/// The schema of rules that hold together.
pub(super) fn conjunction(rules: &[Rule]) -> Json {
    let mut schema = json!({});
    add(&mut schema, rules);
    schema
}

/// A form for each of these keys, which requires it, and for each list of rules.
pub(super) fn each(keys: &[&str], forms: &[&[Rule]]) -> Json {
    let keys = keys.iter().map(|key| json!({ "required": [key] }));
    keys.chain(forms.iter().copied().map(conjunction)).collect()
}
