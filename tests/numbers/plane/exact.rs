//! Exact motions in a plane beside an independent integration: DOP853 with restarts at events, collocation of order 17 from rest,
//! and time stretched by 1/|rdot| at stops.

use serde_json::{Value as Json, json};
use slipgap::study;

/// r and S of the exact motion at these steps, by channels.
fn exact(mut study: Json, channels: &[&str], steps: &[usize]) -> Vec<Vec<f64>> {
    study["metrics"] = json!(["rms_error(f.r)", "reference_error(f.r)"]);
    study["figures"] = json!([{"name": "h", "kind": "history", "y": channels}]);
    let study =
        study::parse("study.json", &study.to_string()).unwrap_or_else(|why| panic!("{why}"));
    let case = study.case(0).unwrap();
    let solution = study
        .problem
        .solve(&case, &study.metrics)
        .unwrap_or_else(|why| panic!("{why}"));
    let error = solution.metrics[1].unwrap();
    assert!(error < 1e-9, "reference_error {error}");
    let channel = |i: usize| -> Vec<f64> {
        let values = solution.exact.channel(i);
        steps.iter().map(|step| values[*step]).collect()
    };
    (0..channels.len()).map(channel).collect()
}

fn sine(amplitude: f64, omega: f64, phase: f64) -> Json {
    json!({"sine": {"amplitude": amplitude, "omega": omega, "phase": phase}})
}

/// Two blocks of 20 and 10 kN, one on the other, on a ground that moves from rest.
fn stacked(nu: [f64; 2], x: Json, y: Json) -> Json {
    json!({
        "problem": "structure", "parameters": {"dt": 0.01, "duration": 3},
        "structure": {
            "masses": {"a": {"mass": 2, "direction": ["x", "y"]}, "b": {"mass": 1, "direction": ["x", "y"]}},
            "contacts": {
                "f": {"law": "coulomb", "between": ["ground", "a"], "directions": ["x", "y"], "nu": nu[0], "N": 30},
                "h": {"law": "coulomb", "between": ["a", "b"], "directions": ["x", "y"], "nu": nu[1], "N": 10}
            },
            "ground": {"x": x, "y": y}, "contacts_reference": "softened"
        }
    })
}

/// Compares with rows of a.x, a.y, b.x, b.y and of forces.
fn compare(study: Json, channels: &[&str], steps: &[usize], known: &[&[f64]]) {
    let curves = exact(study, channels, steps);
    for (i, row) in known.iter().enumerate() {
        for (curve, (known, channel)) in curves.iter().zip(row.iter().zip(channels)) {
            // Both integrations agree to 1e-10; the numbers have 13 digits.
            let tolerance = if channel.contains(".S.") { 2e-9 } else { 2e-10 };
            assert!(
                (curve[i] - known).abs() < tolerance,
                "{channel} {} {known}",
                curve[i]
            );
        }
    }
}

const STACK: [&str; 8] = [
    "a.x", "a.y", "b.x", "b.y", "f.S.1", "f.S.2", "h.S.1", "h.S.2",
];

/// The upper block slides first; the lower one sticks and slides by turns.
#[test]
fn stacked_blocks_begin_to_slide_one_after_the_other() {
    let study = stacked([0.2, 0.1], sine(2.2, 4.0, 0.3), sine(2.0, 5.0, 0.0));
    compare(
        study,
        &STACK,
        &[50, 100, 200, 300],
        &[
            &[
                -0.0109641837006,
                -0.0095504576693,
                -0.100097291786,
                -0.0863310437482,
                -4.6970011680188,
                -3.7333872056927,
                -0.7556758623555,
                -0.6549457924541,
            ],
            &[
                -0.013367320581,
                -0.0113035880468,
                -0.2929943522638,
                -0.2006429067255,
                3.9665155519259,
                4.5018612124687,
                0.2376098441373,
                0.9713606755315,
            ],
            &[
                -0.0101028436796,
                -0.0090986450428,
                -0.1245282936244,
                -0.2547450357003,
                -4.8806432245769,
                1.7638706712473,
                -0.9110871560492,
                -0.4122137723102,
            ],
            &[
                -0.0068807500057,
                -0.0123417857633,
                -0.1962177597253,
                -0.1758169218157,
                1.9083240241354,
                -3.2624710835807,
                0.7501041421259,
                -0.6613197229522,
            ],
        ],
    );
}

/// The lower block slides and takes the upper one with it.
#[test]
fn a_block_that_sticks_goes_with_the_one_below() {
    let study = stacked([0.1, 0.2], sine(3.0, 4.0, 0.0), sine(2.0, 5.0, 0.0));
    compare(
        study,
        &STACK,
        &[50, 100, 300],
        &[
            &[
                -0.1186057188905,
                -0.0841428956915,
                -0.1186057188905,
                -0.0841428956915,
                -2.5322094553527,
                -1.6086998707722,
                -0.8440698184509,
                -0.5362332902574,
            ],
            &[
                -0.5066602362946,
                -0.2174353570668,
                -0.5066602362946,
                -0.2174353570668,
                -2.8437632181983,
                0.9555159647135,
                -0.9479210727328,
                0.3185053215712,
            ],
            &[
                -0.5285463850997,
                -0.1994873061,
                -0.5285463850997,
                -0.1994873061,
                2.5550459806878,
                -1.5721768464683,
                0.8516819935626,
                -0.5240589488228,
            ],
        ],
    );
}

/// A normal force that is the force of an impact contact, on which another mass vibrates.
#[test]
fn a_contact_that_presses_has_its_force_at_every_instant() {
    for (law, known) in [
        (
            json!({"law": "coulomb"}),
            [
                [
                    0.18188566447,
                    0.1031919420394,
                    1.2130227685045,
                    0.2935456734422,
                ],
                [
                    -0.1068617048985,
                    0.0666720521234,
                    1.2135005531723,
                    0.6318869882445,
                ],
                [
                    -0.1323318879079,
                    -0.0499197053448,
                    -1.1122107031961,
                    0.6660745558616,
                ],
            ],
        ),
        (
            json!({"law": "displacement-control", "k": 100}),
            [
                [
                    0.1877931706863,
                    0.0993327683235,
                    1.1873732352873,
                    0.3843671414551,
                ],
                [
                    -0.0809445104785,
                    0.0561704744412,
                    1.2077989031472,
                    0.6427181092974,
                ],
                [
                    -0.1068140537001,
                    -0.0564148100883,
                    -1.1384888329006,
                    0.620089622257,
                ],
            ],
        ),
    ] {
        let mut study = json!({
            "problem": "structure", "parameters": {"dt": 0.01, "duration": 3},
            "structure": {
                "masses": {"a": {"mass": 1, "direction": ["x", "y"]}, "z": {"mass": 1, "direction": "z"}},
                "springs": [{"between": ["ground", "a"], "directions": ["x", "y"], "k": [30, 50], "c": 0.2}],
                "contacts": {
                    "f": {"between": ["ground", "a"], "directions": ["x", "y"], "nu": 0.1, "N": {"contact": "floor"}},
                    "floor": {"law": "impact", "between": ["ground", "z"], "k": 4000}
                },
                "static": {"z": -10},
                "ground": {"x": sine(3.0, 4.0, 1.5), "y": sine(2.5, 5.0, 0.3), "z": sine(4.0, 7.0, 0.0)},
                "contacts_reference": "softened"
            }
        });
        for (key, value) in law.as_object().unwrap() {
            study["structure"]["contacts"]["f"][key] = value.clone();
        }
        let rows: Vec<&[f64]> = known.iter().map(|row| &row[..]).collect();
        let channels = ["f.r.1", "f.r.2", "f.S.1", "f.S.2"];
        compare(study, &channels, &[100, 200, 300], &rows);
    }
}
