//! The parts of the error of the impact: their sum, where they are undefined, and the order of the step error.

use crate::common;
use common::case;
use serde_json::{Value as Json, json};
use slipgap::problem::find;

const NAMES: [&str; 12] = [
    "regularisation_error_r",
    "regularisation_error_rdot",
    "mesh_error_r",
    "mesh_error_rdot",
    "step_error_r",
    "step_error_rdot",
    "regularisation_share_r",
    "regularisation_share_rdot",
    "mesh_share_r",
    "mesh_share_rdot",
    "step_share_r",
    "step_share_rdot",
];

/// Row of the first of them.
const FIRST: usize = 12;

/// Every metric of a case, including the budget.
fn metrics(given: Json) -> Vec<Option<f64>> {
    let problem = find("bar-impact").unwrap();
    problem
        .solve(&case(&*problem, &given), &[FIRST])
        .unwrap()
        .metrics
}

#[test]
fn the_rows_are_the_budget_and_are_computed_if_selected() {
    let problem = find("bar-impact").unwrap();
    for (row, name) in NAMES.into_iter().enumerate() {
        let metric = &problem.metrics()[FIRST + row];
        assert_eq!((&*metric.name, metric.default), (name, false));
    }
    let case = case(
        &*problem,
        &json!({"gamma": 1.0, "n": 10, "dt": 0.01, "duration": 1.5}),
    );
    // The exact columns after them do not need them, and they do not need the exact columns.
    let unasked = problem.solve(&case, &[0, FIRST - 1, 24]).unwrap().metrics;
    assert_eq!(unasked[FIRST..24], [None; 12]);
    let asked = problem.solve(&case, &[20]).unwrap().metrics;
    assert!(asked[FIRST..24].iter().all(Option::is_some));
    assert_eq!(asked[24..27], [None; 3]);
}

#[test]
fn parts_add_up_to_the_error() {
    for given in [
        json!({"gamma": 1.0, "n": 10, "dt": 0.01, "duration": 1.5}),
        json!({"gamma": 0.25, "n": 40, "dt": 0.003, "duration": 2.7, "gap": 0.31}),
        json!({"gamma": 5.0, "n": 2, "dt": 0.05, "duration": 1.2, "mass": "consistent"}),
        json!({"gamma": 2.1, "n": 20, "dt": 0.5, "duration": 3.0}),
        json!({"k_I": 1e4, "n": 10, "dt": 0.001, "duration": 1.5, "V0": 0.3, "right": {"V0": 0.1}}),
    ] {
        let m: Vec<f64> = metrics(given.clone())[..24]
            .iter()
            .map(|m| m.unwrap())
            .collect();
        for (of, total) in [(0, m[FIRST - 2]), (1, m[FIRST - 1])] {
            let part = |i: usize| [m[FIRST + of + 2 * i], m[FIRST + 6 + of + 2 * i]];
            let [[a, sa], [b, sb], [c, sc]] = [0, 1, 2].map(part);
            // Round-off of parts that may be larger than the error.
            let tiny = 1e-13 * (1.0 + (a + b + c) / total);
            assert!((sa + sb + sc - 1.0).abs() < tiny, "{given}: {m:?}");
            // The share of a part is at most its norm over that of the error (Cauchy-Schwarz).
            for [norm, share] in [[a, sa], [b, sb], [c, sc]] {
                assert!(share.abs() <= norm / total + tiny, "{given}: {m:?}");
            }
            assert!(total <= a + b + c && total >= a - b - c, "{given}: {m:?}");
        }
    }
}

#[test]
fn parts_without_a_reference_are_empty() {
    let budget = |given: Json| metrics(given)[FIRST..24].to_vec();
    let base = |more: Json| {
        let mut given = json!({"gamma": 1.0, "n": 4, "dt": 0.01, "duration": 1.5});
        for (key, value) in more.as_object().unwrap() {
            given[key] = value.clone();
        }
        budget(given)
    };
    for without in [
        json!({"right": "wall"}),
        json!({"right": {"L": 20.0}}),
        json!({"right": {"n": 8}}),
        json!({"right": {"E": 200.0, "rho": 0.005}}),
        json!({"gamma": 0.1}),
        json!({"n": 1001, "dt": 0.5}),
        json!({"gamma": 1e19}),
        json!({"gamma": 1e200}),
        json!({"gamma": 1e300}),
    ] {
        assert_eq!(base(without.clone()), [None; 12], "{without}");
    }
    // Only the numbers in the scaled equations have to be equal.
    let twins = json!({"right": {"V0": -0.3, "L": 10.0}});
    assert!(base(twins).iter().all(Option::is_some));
    assert!(base(json!({"gamma": 0.1011})).iter().all(Option::is_some));
    assert!(base(json!({"gamma": 6e18})).iter().all(Option::is_some));
}

#[test]
fn step_error_is_of_second_order_until_separation() {
    // gamma = 1: there is no event between the first touch, which is at a step, and 1.057 T_I.
    let errors = |dt: f64, duration: f64| {
        let m = metrics(json!({"gamma": 1.0, "n": 10, "dt": dt, "duration": duration}));
        [m[FIRST + 4].unwrap(), m[FIRST + 5].unwrap()]
    };
    let steps = [0.002, 0.001, 0.0005];
    let ladder = steps.map(|dt| errors(dt, 1.0));
    for pair in ladder.windows(2) {
        for i in [0, 1] {
            let ratio = pair[0][i] / pair[1][i];
            // Omega dt = 0.1 at the first of these steps: the next order is a few thousandths.
            assert!((ratio - 4.0).abs() < 0.02, "{i}: {ratio}");
        }
    }
    // After separation r has the same order in the mean, because the force is continuous.
    let [coarse, fine] = [0.004, 0.0005].map(|dt| errors(dt, 1.5)[0]);
    assert!(
        (20.0..200.0).contains(&(coarse / fine)),
        "{}",
        coarse / fine
    );
}
