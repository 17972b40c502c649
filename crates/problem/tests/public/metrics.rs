//! No metric of the textbook problems is an empty column: each has a value in one of a few cases.

use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_problem::problem::{Case, Problem, find};
use std::f64::consts::PI;

fn number(name: &'static str, x: f64) -> (&'static str, Value) {
    (name, Value::Number(x))
}

/// The metrics that no case has.
fn empty(problem: &dyn Problem, cases: &[Vec<(&str, Value)>]) -> Vec<String> {
    let indices: Vec<usize> = (0..problem.metrics().len()).collect();
    let solved = cases.iter().map(|given| {
        let (case, broken) = Case::given(problem, given);
        assert!(broken.is_empty(), "{broken:?}");
        problem.solve(&case, &indices).expect("a solution").metrics
    });
    let metrics: Vec<Vec<Option<f64>>> = solved.collect();
    let none = |row: &usize| metrics.iter().all(|values| values[*row].is_none());
    let rows = indices.iter().filter(|row| none(row));
    rows.map(|row| problem.metrics()[*row].name.to_string())
        .collect()
}

#[test]
fn every_metric_of_friction_has_a_value() {
    let law = |name, more: (&'static str, Value)| {
        let end = number("duration", 10.0 * PI);
        vec![
            ("law", Value::Name(name)),
            more,
            number("dT", PI / 20.0),
            number("x0", 7.5),
            end,
        ]
    };
    // An integrated reference has an error of its own, a closed form has none.
    let cases = [
        law("displacement-control", number("alpha", 0.1)),
        law("dahl", number("alpha", 0.1)),
    ];
    assert_eq!(
        empty(&*find("friction-oscillator").unwrap(), &cases),
        [""; 0]
    );
}

#[test]
fn every_metric_of_bars_has_a_value() {
    // As for friction.
    let given = |pairs: [(&'static str, Value); 2]| {
        let steps = [
            ("n", Value::Whole(10)),
            number("dt", 0.02),
            number("duration", 1.6),
        ];
        [&pairs[..], &steps].concat()
    };
    let cases = [
        given([("law", Value::Name("impact-spring")), number("gamma", 2.0)]),
        given([("law", Value::Name("hertz")), number("k_h", 50.0)]),
    ];
    assert_eq!(empty(&*find("bar-impact").unwrap(), &cases), [""; 0]);
}
