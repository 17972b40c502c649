//! The request of a case, and the study of the structure that describes a case of a textbook problem.

use crate::Study;
use crate::source::input::Input;
use serde_json::{Map, Value as Json, json};
use slipgap_motion::solve::Unsolvable;
use slipgap_problem::problem::method::PARAMETERS;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_problem::problem::structure::programs::{Program, Programs};
use slipgap_problem::problem::structure::tables::schema::NAME;
use slipgap_problem::problem::{Case, Described, ProblemKind, Schema};

/// The request of a completed case to a program of others, as a line of JSON.
///
/// # Errors
/// The case cannot be assembled, or the format does not have a part of it.
pub fn request(study: &Study, case: &Case) -> Result<String, Unsolvable> {
    let textbook = match study.problem.kind() {
        ProblemKind::Structure(structure) => return structure.request(case),
        ProblemKind::Textbook(textbook) => textbook,
    };
    let described = textbook.described(case).map_err(Unsolvable::Program)?;
    let program = textbook.programs().and_then(|programs| {
        let name = case.choice(&PARAMETERS[0].name);
        Some((programs, programs.named(name)?))
    });
    let (study, inner) = structure(case, study.problem.schema(), &described, program)?;
    match study.problem.as_structure() {
        Some(structure) => structure.request(&inner),
        None => Err(Unsolvable::ParameterMissing),
    }
}

/// The study of the structure that describes a case, with the program if it has one, and its only case.
pub(super) fn structure(
    case: &Case,
    schema: &Schema,
    described: &Described,
    program: Option<(&Programs, &Program)>,
) -> Result<(Study, Case), Unsolvable> {
    let broken = |why: String| Unsolvable::Program(why);
    let mut parameters = Map::new();
    for (row, value) in case.values.iter().enumerate() {
        let name = &schema.parameters[row].name;
        match value {
            Some(Value::Number(x)) if !name.contains('.') => {
                parameters.insert(name.to_string(), json!(x))
            }
            Some(Value::Whole(n)) if !name.contains('.') => {
                parameters.insert(name.to_string(), json!(n))
            }
            Some(Value::Number(_) | Value::Whole(_) | Value::Name(_)) | None => None,
        };
    }
    for (name, row) in [("dt", schema.step), ("duration", schema.duration)] {
        parameters.insert(name.to_owned(), json!(case.at(row)));
    }
    let mut study = json!({
        "problem": NAME,
        "structure": described.structure,
        "figures": [{ "name": "channels", "kind": "history", "y": described.channels }],
    });
    let (mut file, mut folder, mut runner) = (String::new(), Default::default(), None);
    if let Some((programs, program)) = program {
        let mut numbers = Map::new();
        for (name, amount) in &program.numbers {
            let value = amount
                .value(case)
                .map_err(|why| broken(format!("{}: {}", why.parameter, why.message)))?;
            numbers.insert(name.clone(), json!(value));
        }
        let [timeout, start_timeout] = program.timeouts;
        study["programs"] = json!({ program.name: {
            "command": program.command, "parameters": numbers, "timeout": timeout, "start_timeout": start_timeout,
        } });
        study["metrics"] = json!(["cost"]);
        parameters.insert(PARAMETERS[0].name.to_string(), json!(program.name));
        file = programs.study().to_owned();
        folder = program.folder.clone();
        runner = programs.runner().cloned();
    }
    study["parameters"] = Json::Object(parameters);
    let input = Input {
        folder,
        ..Input::new(&file, &study.to_string())
    };
    let read = input.with_programs(runner).edited(1, |_| ());
    let study = read.map_err(|error| broken(error.to_string()))?;
    let mut inner = study.case(0).ok_or(Unsolvable::ParameterMissing)?;
    inner.number = case.number;
    Ok((study, inner))
}
