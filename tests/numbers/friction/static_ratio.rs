//! Friction with a static limit above the kinetic one, in studies.

use serde_json::{Value as Json, json};
use slipgap::study::{self, Study};

fn read(study: &Json) -> Study {
    study::parse("study.json", &study.to_string()).unwrap_or_else(|why| panic!("{why}"))
}

fn metrics(study: &Json, case: u64) -> Vec<f64> {
    let study = read(study);
    let solution = study
        .problem
        .solve(&study.case(case).unwrap(), &study.metrics);
    let metrics = solution.unwrap_or_else(|why| panic!("{why}")).metrics;
    metrics.into_iter().map(Option::unwrap).collect()
}

/// The last values of the exact motion of these channels.
fn exact(study: &Json, case: u64, names: [&str; 2]) -> [f64; 2] {
    let study = read(study);
    let case = study.case(case).unwrap();
    let solution = study.problem.solve(&case, &study.metrics).unwrap();
    let columns = study.problem.history_columns(&case);
    names.map(|name| {
        let column = columns
            .iter()
            .find(|channel| channel.column.name == name)
            .unwrap();
        *solution.exact.channels[column.index].last().unwrap()
    })
}

fn refused(study: &Json) -> String {
    let study = match study::parse("study.json", &study.to_string()) {
        Err(why) => return why.to_string(),
        Ok(study) => study,
    };
    let case = study.case(0).unwrap();
    study
        .problem
        .solve(&case, &study.metrics)
        .map(|_| ())
        .unwrap_err()
        .to_string()
}

/// Code_Aster's V5.01.106 (SDND106) by steps.
fn two_masses(method: &str, dt: f64) -> Json {
    json!({
        "problem": "structure", "parameters": {"method": method, "dt": dt, "duration": [0.15, 0.34]},
        "structure": {
            "masses": {"m1": 5, "m2": 5}, "springs": [{"between": ["m1", "m2"], "k": 1e4}],
            "contacts": {"f": {"law": "coulomb", "between": ["ground", "m1"], "limit": 2000, "static_ratio": 1.5}},
            "loads": [{"at": "m2", "table": {"t": [0, 0.2, 0.2, 1], "f": [3000, 3000, 0, 0]}}],
            "contacts_reference": "softened"
        },
        "metrics": ["last(m1)", "last(m2)", "last_error(m1)", "last_error(m2)", "energy_error"]
    })
}

#[test]
fn the_published_numbers_of_two_masses_are_met() {
    let published = [[1.35332, 1.80751], [f64::NAN, 3.96813]];
    for method in ["average-acceleration", "moreau-jean"] {
        for (case, published) in published.iter().enumerate() {
            let study = two_masses(method, 1e-5);
            let of_case = metrics(&study, case as u64);
            let exact = exact(&study, case as u64, ["m1.u", "m2.u"]);
            for k in 0..2 {
                if published[k].is_finite() {
                    // Five digits; the sixth one of two of them is 2 too small.
                    assert!(
                        (exact[k] - published[k]).abs() < 2.3e-5,
                        "{exact:?} {published:?}"
                    );
                }
                // The contact breaks loose at the end of a step: up to (Ls - L) dt/(2 m) of velocity, 1 mm/s, for 0.3 s.
                assert!(of_case[2 + k].abs() < 1e-3, "{method} {of_case:?}");
            }
            assert!(of_case[4] < 1e-10, "{method} {of_case:?}");
        }
    }
}

#[test]
fn what_is_not_known_is_refused_with_a_reason() {
    for method in [
        "newmark",
        "hht",
        "generalized-alpha",
        "bathe",
        "linear-acceleration",
        "contact-stabilized-newmark",
        "central-difference",
    ] {
        let why = refused(&two_masses(method, 1e-5));
        assert!(
            why.contains("static_ratio above 1: the force of a contact that sticks alternates"),
            "{method}: {why}"
        );
        // A ratio of 1 is the law with one limit.
        let mut one = two_masses(method, 1e-5);
        one["structure"]["contacts"]["f"]["static_ratio"] = json!(1);
        one["metrics"] = json!(["last(m1)"]);
        metrics(&one, 0);
    }
    let mut series = two_masses("average-acceleration", 1e-5);
    series["structure"]["contacts"]["f"] = json!({"between": ["ground", "m1"], "series": [
        {"law": "coulomb", "limit": 2000, "static_ratio": 1.5},
        {"law": "displacement-control", "k": 1e6, "limit": 5000}
    ]});
    let why = refused(&series);
    assert!(
        why.contains("static_ratio above 1 is not known in series"),
        "{why}"
    );
    let mut below = two_masses("average-acceleration", 1e-5);
    below["structure"]["contacts"]["f"]["static_ratio"] = json!(0.9);
    assert!(refused(&below).contains("static_ratio"));
}

/// At a node without mass the steps tend to the exact motion, and keep their energy at each slip.
#[test]
fn steps_slip_at_nodes_without_mass() {
    let errors = [1e-3, 5e-4, 2.5e-4].map(|dt| {
        let mut study = two_masses("average-acceleration", dt);
        study["structure"]["masses"]["m1"] = json!(0);
        let [_, _, slips, error, energy] = metrics(&study, 0)[..] else {
            panic!("five metrics");
        };
        assert!(energy < 1e-13, "{energy}");
        [slips, error]
    });
    for [coarse, fine] in [[0, 1], [1, 2]] {
        for k in 0..2 {
            assert!(errors[fine][k] < 0.6 * errors[coarse][k], "{errors:?}");
        }
    }
}

/// A mass of 1 with friction that slides at 1 and holds 2, under a static load.
fn held(load: f64) -> Json {
    json!({
        "problem": "structure", "parameters": {"dt": 0.01, "duration": 1},
        "structure": {
            "masses": {"m": 1}, "static": {"m": load}, "contacts_reference": "softened",
            "contacts": {"f": {"law": "coulomb", "between": ["ground", "m"], "limit": 1, "static_ratio": 2}}
        },
        "metrics": ["peak(m)", "peak(f.S)", "peak_error(m)"]
    })
}

#[test]
fn a_static_load_is_held_up_to_the_static_limit() {
    let at_limit = metrics(&held(1.9), 0);
    // Round-off.
    assert!(
        at_limit[0] < 1e-14 && (at_limit[1] - 1.9).abs() < 1e-12 && at_limit[2] < 1e-14,
        "{at_limit:?}"
    );
    // Nothing stops it, or a spring does, but where depends on the motion.
    let mut study = held(2.1);
    assert!(refused(&study).contains("no equilibrium: nothing holds node m"));
    study["structure"]["springs"] = json!([{"between": ["ground", "m"], "k": 1}]);
    let why = refused(&study);
    assert!(
        why.contains("the static loads break contact 'f' loose"),
        "{why}"
    );
}

/// A block that a weight presses and another contact's force: limits that vary, beside the exact motion.
#[test]
fn limits_that_vary_have_both_parts() {
    let study = |dt: f64| {
        json!({
            "problem": "structure", "parameters": {"dt": dt, "duration": 6},
            "structure": {
                "masses": {"m": 1}, "springs": [{"between": ["ground", "m"], "k": 8}],
                "loads": [{"at": "m", "sine": {"amplitude": 3, "omega": 1.7}}],
                "contacts": {"f": {"law": "coulomb", "between": ["ground", "m"], "nu": 0.1, "static_ratio": 1.6,
                    "N": {"t": [0, 2, 4, 6], "N": [5, 12, 8, 15]}}},
                "contacts_reference": "softened"
            },
            "metrics": ["rms_error(m)", "energy_error"]
        })
    };
    let by_step = [0.01, 0.001, 0.0001].map(|dt| metrics(&study(dt), 0));
    // Order 1, of displacements of 0.3.
    assert!(by_step[0][0] < 1e-2 && by_step[2][0] < 1e-4, "{by_step:?}");
    assert!(
        by_step.iter().all(|values| values[1] < 1e-12),
        "{by_step:?}"
    );
}

/// A block on a floor: N is the force of another contact, which is the weight.
#[test]
fn the_force_of_another_contact_presses_with_both_limits() {
    let study = |pressed: bool| {
        let normal = match pressed {
            true => json!({"contact": "floor"}),
            false => json!(10),
        };
        json!({
            "problem": "structure", "parameters": {"dt": 0.001, "duration": 6},
            "structure": {
                "masses": {"x": 1, "y": {"mass": 1, "direction": "y"}},
                "springs": [{"between": ["ground", "x"], "k": 8}],
                "loads": [{"at": "x", "sine": {"amplitude": 3, "omega": 1.7}}],
                "static": {"y": -10},
                "contacts": {
                    "floor": {"law": "impact", "between": ["ground", "y"], "k": 1e4},
                    "f": {"law": "coulomb", "between": ["ground", "x"], "nu": 0.1, "static_ratio": 1.6, "N": normal}
                }
            },
            "metrics": ["last(x)", "peak(x)", "peak(f.S)", "energy_error"]
        })
    };
    let [of_pressure, number] = [true, false].map(|pressed| metrics(&study(pressed), 0));
    for (metric, number) in of_pressure.iter().zip(&number) {
        // Round-off of the equilibrium on the floor.
        assert!((metric - number).abs() < 1e-9, "{metric} {number}");
    }
    assert!(
        of_pressure[2] > 1.5 && of_pressure[1] > 0.1,
        "{of_pressure:?}"
    );
}
