//! The impact's error in parts: that they make the whole, where they are undefined, and the order of the step's.

mod common;

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

/// Every metric of a case, the budget included.
fn metrics(given: Json) -> Vec<Option<f64>> {
    let problem = find("bar-impact").unwrap();
    problem
        .solve(&case(&*problem, &given), &[FIRST])
        .unwrap()
        .metrics
}

#[test]
fn the_rows_are_the_budget_and_come_when_asked_for() {
    let problem = find("bar-impact").unwrap();
    for (row, name) in NAMES.into_iter().enumerate() {
        let metric = &problem.metrics()[FIRST + row];
        assert_eq!((&*metric.name, metric.default), (name, false));
    }
    let case = case(
        &*problem,
        &json!({"gamma": 1.0, "n": 10, "dt": 0.01, "duration": 1.5}),
    );
    // The exact columns below them do not ask for them, nor they for those.
    let unasked = problem.solve(&case, &[0, FIRST - 1, 24]).unwrap().metrics;
    assert_eq!(unasked[FIRST..24], [None; 12]);
    let asked = problem.solve(&case, &[20]).unwrap().metrics;
    assert!(asked[FIRST..24].iter().all(Option::is_some));
    assert_eq!(asked[24..], [None; 3]);
}

#[test]
fn parts_make_the_whole() {
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
            // Round-off of parts that may be larger than the whole.
            let tiny = 1e-13 * (1.0 + (a + b + c) / total);
            assert!((sa + sb + sc - 1.0).abs() < tiny, "{given}: {m:?}");
            // A share of a part is at most its norm over the whole's, and the parts span the whole.
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
    // Only what enters the scaled equations has to be alike.
    let twins = json!({"right": {"V0": -0.3, "L": 10.0}});
    assert!(base(twins).iter().all(Option::is_some));
    assert!(base(json!({"gamma": 0.1011})).iter().all(Option::is_some));
    assert!(base(json!({"gamma": 6e18})).iter().all(Option::is_some));
}

#[test]
fn step_error_is_of_second_order_until_the_ends_part() {
    // gamma = 1: nothing happens between the first touch, which falls on a step, and 1.057 T_I.
    let errors = |dt: f64, duration: f64| {
        let m = metrics(json!({"gamma": 1.0, "n": 10, "dt": dt, "duration": duration}));
        [m[FIRST + 4].unwrap(), m[FIRST + 5].unwrap()]
    };
    let steps = [0.002, 0.001, 0.0005];
    let ladder = steps.map(|dt| errors(dt, 1.0));
    for pair in ladder.windows(2) {
        for i in [0, 1] {
            let ratio = pair[0][i] / pair[1][i];
            // Omega dt = 0.1 at the first of these steps: the next order is some thousandths.
            assert!((ratio - 4.0).abs() < 0.02, "{i}: {ratio}");
        }
    }
    // Past the parting r keeps the order in the mean, since the force is continuous: eight halvings' worth by 8.
    let [coarse, fine] = [0.004, 0.0005].map(|dt| errors(dt, 1.5)[0]);
    assert!(
        (20.0..200.0).contains(&(coarse / fine)),
        "{}",
        coarse / fine
    );
}
