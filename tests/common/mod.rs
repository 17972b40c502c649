//! What several tests need: a case from plain values.

use serde_json::Value as Json;
use slipgap::problem::numbers::parameter::{Kind, Value};
use slipgap::problem::{Case, Problem};

/// The completed case with these values; the other parameters have their defaults.
pub fn case(problem: &dyn Problem, given: &Json) -> Case {
    let mut given = given.as_object().unwrap().clone();
    if let Some(Json::Object(right)) = given.get("right").cloned() {
        given.remove("right");
        for (key, value) in right {
            given.insert(format!("right.{key}"), value);
        }
    }
    let value = |(name, json): (&String, &Json)| {
        let found = problem.parameters().iter().find(|p| p.name == *name);
        let parameter = found.unwrap_or_else(|| panic!("unknown parameter {name}"));
        match parameter.kind {
            Kind::Number(_) => Value::Number(json.as_f64().unwrap()),
            Kind::Whole { .. } => Value::Whole(json.as_u64().unwrap()),
            Kind::Choice(choices) => {
                let chosen = json.as_str().unwrap();
                Value::Name(choices.iter().find(|choice| choice.0 == chosen).unwrap().0)
            }
        }
    };
    let values: Vec<(&str, Value)> = given
        .iter()
        .map(|member| (member.0.as_str(), value(member)))
        .collect();
    let (case, broken) = Case::given(problem, &values);
    assert_eq!(broken, []);
    case
}
