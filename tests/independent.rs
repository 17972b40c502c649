//! Histories and metrics against independent programs (tests/reference), which worked with 50 digits.

use serde_json::Value as Json;
use slipgap::problem::parameter::{Default, Kind, Value};
use slipgap::problem::{Case, Problem, Solution, find};

fn data(file: &str) -> Json {
    let path = format!("{}/tests/data/{file}", env!("CARGO_MANIFEST_DIR"));
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// The case that a table of plain values means, completed as a study's would be.
fn case(problem: &dyn Problem, given: &Json) -> Case {
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

/// Largest difference of the thinned history, row by row.
fn history_difference(solution: &Solution, rows: &Json) -> f64 {
    let (c, e) = (&solution.computed, &solution.exact);
    let mut largest: f64 = 0.0;
    for row in rows.as_array().unwrap() {
        let row: Vec<f64> = row
            .as_array()
            .unwrap()
            .iter()
            .map(|x| x.as_f64().unwrap())
            .collect();
        let i = row[0] as usize;
        let ours = [
            c.time[i],
            c.displacement[i],
            c.velocity[i],
            c.force[i],
            e.displacement[i],
            e.velocity[i],
        ];
        for (ours, theirs) in ours.iter().zip(&row[1..]) {
            largest = largest.max((ours - theirs).abs());
        }
    }
    largest
}

/// Solves every case of a file and compares; `tolerance` of the history from the case's data.
fn compare(file: &str, tolerance: impl Fn(&Json) -> f64) {
    let data = data(file);
    let problem = find(data["problem"].as_str().unwrap()).unwrap();
    let cases = data["cases"].as_array().unwrap();
    assert!(cases.len() > 30);
    let mut faults = Vec::new();
    for record in cases {
        let parameters = &record["parameters"];
        let case = case(problem, parameters);
        assert_eq!(
            problem.steps(&case),
            record["steps"].as_u64().unwrap(),
            "{parameters}"
        );
        let solution = problem.solve(&case).unwrap();
        let tolerance = tolerance(record);
        let difference = history_difference(&solution, &record["history"]);
        if !(difference <= tolerance) {
            faults.push(format!(
                "history {difference:e} > {tolerance:e}: {parameters}"
            ));
        }
        for (metric, ours) in problem.metrics().iter().zip(&solution.metrics) {
            let theirs = record["metrics"][metric.name].as_f64();
            // An arc cosine near 1 turns an error of 1e-16 into one of 1e-8.
            let tolerance = match metric.name {
                "sprague_geers_phase" | "sprague_geers_combined" => 2e-8,
                _ => tolerance,
            };
            let near = match (ours, theirs) {
                (Some(a), Some(b)) => (a - b).abs() <= tolerance,
                (None, None) => true,
                _ => false,
            };
            if !near {
                faults.push(format!(
                    "{} {ours:?}, not {theirs:?}: {parameters}",
                    metric.name
                ));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn friction() {
    // Round-off of numbers of the size of x0, a random walk over the steps; S is a displacement over alpha.
    compare("friction.json", |record| {
        let number = |name: &str| record["parameters"][name].as_f64();
        let x0 = number("x0").unwrap().abs().max(1.0);
        let steps = record["steps"].as_f64().unwrap();
        let width = number("alpha").or(number("beta")).unwrap().min(1.0);
        4.0 * f64::EPSILON * x0 * steps.sqrt() / width
    });
}

#[test]
fn impact() {
    // The data say how far each case's history moves for a unit of r(0): its own measure of round-off.
    compare("impact.json", |record| {
        (1e-14 * record["sensitivity"].as_f64().unwrap()).max(1e-12)
    });
}
