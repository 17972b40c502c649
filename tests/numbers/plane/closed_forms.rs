//! Friction in a plane beside closed forms, scalar friction and other directions.

use serde_json::{Value as Json, json};
use slipgap::study;
use std::f64::consts::PI;

/// The metrics of all cases.
fn solve(study: &Json) -> Vec<Vec<f64>> {
    let study =
        study::parse("study.json", &study.to_string()).unwrap_or_else(|why| panic!("{why}"));
    let cases = (0..study.len()).map(|i| {
        let case = study.case(i).unwrap();
        let solution = study.problem.solve(&case, &study.metrics);
        let metrics = solution.unwrap_or_else(|why| panic!("{why}")).metrics;
        metrics.into_iter().map(Option::unwrap).collect()
    });
    cases.collect()
}

/// A mass of 1 on a contact in a plane.
fn block(contact: Json, more: Json, metrics: &[&str]) -> Json {
    let mut study = json!({
        "problem": "structure", "parameters": {"dt": 0.002, "duration": 4},
        "structure": {
            "masses": {"a": {"mass": 1, "direction": ["x", "y"]}},
            "contacts": {"f": {"between": ["ground", "a"], "directions": ["x", "y"]}}
        },
        "metrics": metrics
    });
    for (key, value) in contact.as_object().unwrap() {
        study["structure"]["contacts"]["f"][key] = value.clone();
    }
    for (key, value) in more.as_object().unwrap() {
        match key.as_str() {
            "parameters" => {
                for (key, value) in value.as_object().unwrap() {
                    study["parameters"][key] = value.clone();
                }
            }
            _ => study["structure"][key] = value.clone(),
        }
    }
    study
}

/// The laws with a limit of 1.
fn laws() -> Vec<Json> {
    vec![
        json!({"law": "coulomb", "limit": 1}),
        json!({"law": "velocity-control", "limit": 1, "rdotE": 0.1}),
        json!({"law": "tanh", "limit": 1, "rdotE": 0.1}),
        json!({"law": "stribeck", "limit": 1, "rdotE": 0.1, "static_ratio": 1.1, "stribeck_velocity": 1}),
        json!({"law": "stribeck-hyperbolic", "limit": 1, "rdotE": 0.1, "static_ratio": 1.1, "stribeck_velocity": 1}),
        json!({"law": "displacement-control", "limit": 1, "rE": 0.01}),
        json!({"law": "bouc-wen", "limit": 1, "rE": 0.01, "exponent": 2}),
        json!({"law": "bouc-wen", "limit": 1, "rE": 0.01, "exponent": 1}),
        json!({"law": "bouc-wen", "limit": 1, "rE": 0.01, "exponent": 2, "beta": 0.9}),
        json!({"law": "lugre", "limit": 1, "sigma0": 100, "sigma1": 0.1, "sigma2": 0.1, "static_ratio": 1.1, "stribeck_velocity": 1}),
        json!({"law": "bilinear", "Fy": 1, "k1": 100, "k2": 10}),
        json!({"law": "pendulum", "nu": 0.1, "N": 10, "R": 3, "rE": 0.01}),
    ]
}

fn sine(amplitude: f64, omega: f64, phase: f64) -> Json {
    json!({"sine": {"amplitude": amplitude, "omega": omega, "phase": phase}})
}

/// Steady slip on a ground that moves on a circle: friction of constant size, sqrt(a0^2 - (mu g)^2)/|g/R - w^2|.
#[test]
fn a_pendulum_under_a_circle_slides_on_a_circle() {
    let amplitudes = [0.7, 0.8, 1.0, 1.5, 3.0];
    let limit: f64 = 0.06 * 9.81;
    let ground = json!({"x": {"sine": {"amplitude": "a0", "omega": "pi", "phase": "pi/2"}}, "y": {"sine": {"amplitude": "a0", "omega": "pi"}}});
    let more = json!({"parameters": {"a0": amplitudes, "dt": 0.004, "duration": 200}, "ground": ground,
        "springs": [{"between": ["ground", "a"], "directions": ["x", "y"], "k": 9.81 / 2.0}]});
    let study = block(
        json!({"law": "coulomb", "limit": limit}),
        more,
        &["last(f.r)"],
    );
    for (a0, metrics) in amplitudes.iter().zip(solve(&study)) {
        let slip = (a0 * a0 - limit * limit).sqrt() / (9.81 / 2.0 - PI * PI).abs();
        // Of second order in the step: (w dt)^2/12 of accelerations, near the resonance a little more; and the transient.
        assert!(
            (metrics[0] / slip - 1.0).abs() < 1e-4,
            "{a0} {} {slip}",
            metrics[0]
        );
    }
}

/// A block on a slope with mu = tan(slope), launched across: its speed tends to half of the first one, down the slope.
#[test]
fn a_block_that_is_launched_across_a_slope_ends_with_half_its_speed() {
    let more = json!({"parameters": {"duration": 20}, "start": {"a.x": {"v": 1}},
        "loads": [{"at": "a.y", "table": {"t": [0, 1], "f": [1, 1]}}], "contacts_reference": "softened"});
    let metrics = ["last(a.x.v)", "last(a.y.v)", "rms_error(f.r)"];
    let found = solve(&block(
        json!({"law": "coulomb", "limit": 1}),
        more,
        &metrics,
    ))
    .pop()
    .unwrap();
    // v = C tan(psi/2)/sin(psi): the velocity across falls as exp(-2 t/v0), the step changes it by its square.
    assert!(
        found[0].abs() < 1e-9 && (found[1] - 0.5).abs() < 1e-6,
        "{found:?}"
    );
    assert!(found[2] < 1e-5, "{found:?}");
}

/// Code_Aster's test SDND100: a block released at 45 degrees from 0.85 mm stops at -0.65, 0.45, -0.25 and rests at 0.05 mm.
#[test]
fn a_block_released_at_an_angle_turns_where_the_closed_form_does() {
    let r0 = 0.85e-3 * 0.5_f64.sqrt();
    let more = json!({"parameters": {"duration": 0.2, "dt": 1e-5},
        "springs": [{"between": ["ground", "a"], "directions": ["x", "y"], "k": 1e4}],
        "start": {"a.x": {"u": r0}, "a.y": {"u": r0}}, "contacts_reference": "softened"});
    let metrics = [
        "min(a.x)",
        "last(a.x)",
        "last(a.y)",
        "rms_error(f.r)",
        "last_error(f.r)",
    ];
    let found = solve(&block(
        json!({"law": "coulomb", "limit": 1}),
        more,
        &metrics,
    ))
    .pop()
    .unwrap();
    let along = [found[0], found[1]].map(|x| x * 2.0_f64.sqrt());
    // The step has (omega dt)^2/12 of the period, and stops within a step.
    assert!((along[0] + 0.65e-3).abs() < 1e-9, "{along:?}");
    assert!((along[1] - 0.05e-3).abs() < 2e-9, "{along:?}");
    assert_eq!(found[1], found[2]);
    assert!(found[3] < 3e-8 && found[4] < 2e-9, "{found:?}");
}

/// A block at rest, whose loads begin at 0, sticks until they are large enough.
#[test]
fn a_block_at_rest_has_an_exact_motion() {
    let more = json!({"ground": {"x": sine(3.0, 4.0, 0.0), "y": sine(1.0, 3.0, 0.0)}, "contacts_reference": "softened"});
    let metrics = ["rms_error(f.r)", "peak(f.r)"];
    let found = solve(&block(
        json!({"law": "coulomb", "limit": 1}),
        more,
        &metrics,
    ))
    .pop()
    .unwrap();
    assert!(found[0] < 1e-4 * found[1] && found[1] > 0.1, "{found:?}");
}

/// The same motion in a plane that is turned by 45 degrees.
#[test]
fn no_direction_is_preferred() {
    let half = 0.5_f64.sqrt();
    for law in laws() {
        let along = json!({"ground": {"x": sine(3.0, 4.0, 0.3)}, "start": {"a.x": {"v": 0.5}}, "contacts_reference": "softened"});
        let turned = json!({"ground": {"x": sine(3.0 * half, 4.0, 0.3), "y": sine(3.0 * half, 4.0, 0.3)},
            "start": {"a.x": {"v": 0.5 * half}, "a.y": {"v": 0.5 * half}}, "contacts_reference": "softened"});
        let metrics = ["peak(f.r)", "last(f.r)", "rms(f.S)", "rms_error(f.r)"];
        let [along, turned] =
            [along, turned].map(|more| solve(&block(law.clone(), more, &metrics)).pop().unwrap());
        for (a, b) in along.iter().zip(&turned).take(3) {
            // Round-off, which the motion does not magnify.
            assert!((a - b).abs() < 1e-11, "{law} {along:?} {turned:?}");
        }
        // The exact motions agree as well as their tolerance of 1e-12 a step allows.
        assert!(
            (along[3] - turned[3]).abs() < 1e-9,
            "{law} {along:?} {turned:?}"
        );
    }
}

/// Where the second direction is held, the contact is the scalar one, to the bit.
#[test]
fn a_held_direction_leaves_the_scalar_contact() {
    let metrics = ["peak(a.x)", "last(a.x)", "energy_error", "rms_error(a.x)"];
    for law in laws() {
        let more = json!({"masses": {"a": {"mass": 1, "direction": ["x", "y"]}}, "ground": {"x": sine(3.0, 4.0, 0.3)},
            "start": {"a.x": {"v": 0.5}}, "contacts_reference": "softened"});
        let mut scalar = block(law.clone(), more.clone(), &metrics);
        let contact = scalar["structure"]["contacts"]["f"]
            .as_object_mut()
            .unwrap();
        contact.remove("directions");
        contact.insert("between".into(), json!(["ground", "a.x"]));
        let mut held = block(law.clone(), more, &metrics);
        let contact = held["structure"]["contacts"]["f"].as_object_mut().unwrap();
        contact.remove("directions");
        contact.remove("between");
        let plane = json!([["ground", "a.x"], ["ground", "ground"]]);
        contact.insert("plane".into(), plane);
        assert_eq!(solve(&scalar), solve(&held), "{law}");
    }
}

/// Steps converge to the exact motion: of second order, also with the radial return, where the path turns.
#[test]
fn steps_converge_to_the_exact_motion() {
    for law in laws() {
        let name = law["law"].as_str().unwrap().to_owned();
        let more = json!({"parameters": {"dt": [0.004, 0.002], "duration": 3},
            "springs": [{"between": ["ground", "a"], "directions": ["x", "y"], "k": [30, 50], "c": 0.2}],
            "ground": {"x": sine(3.0, 4.0, 1.5), "y": sine(2.5, 5.0, 0.0)},
            "start": {"a.x": {"u": 0.1, "v": 1}}, "contacts_reference": "softened"});
        let metrics = ["rms_error(f.r)", "reference_error(f.r)", "energy_error"];
        let of_cases = solve(&block(law, more, &metrics));
        let ratio = of_cases[0][0] / of_cases[1][0];
        assert!((3.0..5.0).contains(&ratio), "{name} {of_cases:?}");
        assert!(
            of_cases
                .iter()
                .all(|metrics| metrics[1] < 1e-9 && metrics[2] < 1e-12),
            "{name} {of_cases:?}"
        );
    }
}

/// A support on a circle: the force lags the velocity by asin(r_E/a), and a turn takes 2 pi a F sqrt(1 - (r_E/a)^2).
#[test]
fn an_imposed_circle_takes_the_work_of_the_closed_form() {
    let (a, turns, points) = (0.1, 6_u32, 720_u32);
    let point = |i: u32| 2.0 * PI * f64::from(i) / f64::from(points);
    let table = |of: fn(f64) -> f64, start: f64| {
        let t: Vec<f64> = (0..=turns * points).map(point).collect();
        let u: Vec<f64> = t.iter().map(|t| a * of(*t) - start).collect();
        json!({"displacement": {"t": t, "u": u}})
    };
    let work = |law: Json, turns: u32| {
        let mut study = json!({
            "problem": "structure",
            "parameters": {"dt": 2.0 * PI / f64::from(points), "duration": 2.0 * PI * f64::from(turns)},
            "structure": {
                "masses": {"m": 1}, "springs": [{"between": ["ground", "m"], "k": 1}],
                "supports": {"s": {"x": table(f64::cos, a), "y": table(f64::sin, 0.0)}},
                "contacts": {"f": {"between": ["ground", "s"], "directions": ["x", "y"]}}
            },
            "metrics": ["work(f)", "last(f.S.1)", "last(f.S.2)"]
        });
        for (key, value) in law.as_object().unwrap() {
            study["structure"]["contacts"]["f"][key] = value.clone();
        }
        solve(&study).pop().unwrap()
    };
    for ratio in [0.1, 0.3] {
        let law = json!({"law": "displacement-control", "limit": 1, "rE": ratio * a});
        let [before, after] = [turns - 1, turns].map(|turns| work(law.clone(), turns));
        let known = 2.0 * PI * a * (1.0 - ratio * ratio).sqrt();
        // Of second order in the angle of a step, 2 pi/720.
        let error = (after[0] - before[0]) / known - 1.0;
        assert!(error.abs() < 1e-4, "{ratio} {error:e}");
        // At the end the velocity is along y.
        let lag = (-after[1]).atan2(after[2]).abs();
        assert!((lag - ratio.asin()).abs() < 1e-3, "{ratio} {lag}");
    }
    // Other laws follow the motion, too.
    for law in laws().into_iter().skip(1) {
        let works = work(law.clone(), 1);
        assert!(
            works.iter().all(|work| work.is_finite()) && works[0] > 0.0,
            "{law} {works:?}"
        );
    }
}

/// A pendulum that rests on a floor which only pushes, as one part and as two contacts: the same motion, bit for bit.
#[test]
fn a_bearing_with_uplift_is_its_two_contacts() {
    let floor = json!({"law": "impact", "between": ["ground", "b"], "k": 1e5});
    let study = |contacts: Json, floor: &str| {
        json!({
            "problem": "structure", "parameters": {"dt": 0.001, "duration": 3},
            "structure": {
                "masses": {"a": {"mass": 2, "direction": ["x", "y"]}, "b": {"mass": 2, "direction": "z"}},
                "contacts": contacts,
                "static": {"gravity": {"z": -9.81}},
                "ground": {"x": sine(3.0, 7.0, 0.0), "y": sine(2.0, 5.0, 1.0), "z": sine(14.0, 11.0, 0.0)}
            },
            "metrics": ["last(a.x)", "last(a.y)", "last(b)", "peak(bearing.S)", "work(bearing)", format!("max({floor}.r)"), format!("min({floor}.S)"), "energy_error"]
        })
    };
    let bearing = json!({"law": "pendulum", "between": ["ground", "a"], "directions": ["x", "y"], "k": 2e4, "nu": 0.1, "R": 2});
    let with = |normal: Json| {
        let mut contact = bearing.clone();
        contact["N"] = normal;
        contact
    };
    let one = &solve(&study(json!({"bearing": with(floor.clone())}), "bearing.N"))[0];
    let by_name = with(json!({"contact": "floor"}));
    for two in [
        json!({"bearing": by_name, "floor": floor}),
        json!({"floor": floor, "bearing": by_name}),
    ] {
        assert_eq!(one, &solve(&study(two, "floor"))[0]);
    }
    // It leaves the floor, and presses with more than its weight.
    assert!(one[5] > 1e-4 && one[6] < -1.5 * 19.62, "{one:?}");
    let in_list = json!({"bearing": {"between": ["ground", "a.x"], "parallel": [
        {"law": "pendulum", "k": 2e4, "nu": 0.1, "R": 2, "N": floor}, {"law": "viscous", "c": 1, "a": 1}]}});
    let why = study::parse("study.json", &study(in_list, "bearing.N").to_string()).unwrap_err();
    assert!(why.to_string().contains("has no contact in its N"), "{why}");
}
