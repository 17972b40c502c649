//! What several tests need: a case from plain values.

use serde_json::Value as Json;
use slipgap::problem::parameter::{Default, Kind, Value};
use slipgap::problem::{Case, Problem};

/// The case that a table of plain values means, completed as a study's would be.
pub fn case(problem: &dyn Problem, given: &Json) -> Case {
    let mut case = Case::new(problem.parameters());
    let mut given = given.as_object().unwrap().clone();
    if let Some(Json::Object(right)) = given.get("right").cloned() {
        given.remove("right");
        for (key, value) in right {
            given.insert(format!("right.{key}"), value);
        }
    }
    for (row, parameter) in problem.parameters().iter().enumerate() {
        let value = match (given.remove(parameter.name), parameter.kind) {
            (None, _) => match (parameter.default, parameter.applies) {
                (Default::Is(value), None) => Some(value),
                (Default::Is(value), Some((other, name))) if case.choice(other) == name => {
                    Some(value)
                }
                _ => None,
            },
            (Some(value), Kind::Number(_)) => value.as_f64().map(Value::Number),
            (Some(value), Kind::Whole { .. }) => value.as_u64().map(Value::Whole),
            (Some(value), Kind::Choice(choices)) => {
                let name = value.as_str().unwrap();
                let choice = choices.iter().find(|choice| choice.0 == name).unwrap();
                Some(Value::Name(choice.0))
            }
        };
        case.values[row] = value;
    }
    assert!(given.is_empty(), "unknown parameters: {given:?}");
    assert_eq!(problem.complete(&mut case), []);
    case
}
