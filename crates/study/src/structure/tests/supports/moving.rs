//! Supports that have a velocity, move in straight lines or as a sine without drift.

use crate::{Study, parse};

fn study(parameters: &str, structure: &str, metrics: &str) -> Study {
    let text = format!(
        r#"{{"problem": "structure", "parameters": {{{parameters}}}, "structure": {{{structure}}}, "metrics": [{metrics}]}}"#
    );
    parse("s", &text).unwrap_or_else(|why| panic!("{why}"))
}

fn metrics(study: &Study, number: u64) -> Vec<f64> {
    let solution = study.solve(&study.case(number).unwrap()).unwrap();
    solution.metrics.iter().map(|x| x.unwrap()).collect()
}

/// The orders of an error from dt, dt/2, dt/4.
fn orders(errors: [f64; 3]) -> [f64; 2] {
    [errors[0] / errors[1], errors[1] / errors[2]].map(f64::log2)
}

#[test]
fn a_block_on_a_belt_sticks_and_slides_as_the_closed_form() {
    // m = k = 1, static limit 1.5, kinetic limit 1, belt V. It slides around u = 1 with the radius sqrt(0.5^2 + V^2), and sticks.
    let study = study(
        r#""V": [0.1, 0.5], "dt": 0.001, "duration": 60"#,
        r#""masses": {"m": 1}, "springs": [{"between": ["ground", "m"], "k": 1}], "supports": {"belt": {"velocity": "V"}},
           "contacts": {"skid": {"law": "coulomb", "between": ["belt", "m"], "limit": 1, "static_ratio": 1.5}},
           "contacts_reference": "rigid""#,
        r#""max(m)", "peak_error(m)", "max(belt.v)", "min(belt.v)", "last(belt)", "peak(belt.a)""#,
    );
    for (number, v) in [(0, 0.1), (1, 0.5)] {
        let found = metrics(&study, number);
        let most = 1.0 + f64::hypot(0.5, v);
        // An event is found to a step of 1e-3 at a speed of up to 0.7, and its effect on the peak is of second order.
        assert!((found[0] - most).abs() < 2e-4, "{found:?} {most}");
        assert!(found[1] < 2e-4, "{found:?}");
        assert_eq!(found[2..], [v, v, 60.0 * v, 0.0]);
    }
}

#[test]
fn a_belt_is_the_motion_seen_from_it() {
    // A moving frame: the same bodies with start velocities less V on the ground that does not move.
    let bodies =
        r#""masses": {"a": 1, "b": 2}, "springs": [{"between": ["a", "b"], "k": 30, "c": 0.2}]"#;
    let contact = |ground: &str| {
        format!(
            r#""contacts": {{"skid": {{"law": "elastic-friction", "between": ["{ground}", "a"], "k": 200, "limit": 1.2}},
               "damper": {{"law": "viscous", "between": ["{ground}", "b"], "c": 0.7, "a": 0.6}},
               "stop": {{"law": "impact", "between": ["b", "{ground}"], "gap": 0.05, "k": 300}}}}"#
        )
        .replace("elastic-friction", "displacement-control")
    };
    let both = [
        (
            format!(
                r#"{bodies}, {}, "supports": {{"belt": {{"velocity": 0.4}}}}"#,
                contact("belt")
            ),
            r#""last(a - belt)", "last(b - belt)", "work(skid)", "work(stop)", "work(damper)""#,
        ),
        (
            format!(
                r#"{bodies}, {}, "start": {{"a": {{"v": -0.4}}, "b": {{"v": -0.4}}}}"#,
                contact("ground")
            ),
            r#""last(a)", "last(b)", "work(skid)", "work(stop)", "work(damper)""#,
        ),
    ];
    for method in ["average-acceleration", "generalized-alpha", "bathe"] {
        let parameters = format!(r#""dt": 0.002, "duration": 5, "method": "{method}""#);
        let [belt, ground] = [0, 1].map(|i| metrics(&study(&parameters, &both[i].0, both[i].1), 0));
        for (a, b) in belt.iter().zip(&ground) {
            // Round-off of 2500 steps at displacements of 2.
            assert!((a - b).abs() < 1e-10, "{method}: {belt:?} {ground:?}");
        }
    }
}

#[test]
fn a_sine_of_any_phase_and_straight_lines_are_of_second_order() {
    let oscillator =
        r#""masses": {"m": 1}, "springs": [{"between": ["base", "m"], "k": 9, "c": 0.3}]"#;
    // The closed form of a sine: the particular motion and the free one, by complex amplitudes.
    let sine = |phase: f64, t: f64| {
        let (w, k, c, amplitude) = (2.0f64, 9.0f64, 0.3f64, 0.1f64);
        // (k - w^2 + i c w) X = (k + i c w) amplitude e^(i phase), u = Im X e^(i w t) + constant + free.
        let (a, b, p, q) = (k - w * w, c * w, k, c * w);
        let scale = amplitude / (a * a + b * b);
        let (re, im) = ((p * a + q * b) * scale, (q * a - p * b) * scale);
        let (sin, cos) = phase.sin_cos();
        let (re, im) = (re * cos - im * sin, re * sin + im * cos);
        let steady = |t: f64| re * (w * t).sin() + im * (w * t).cos();
        let rate = |t: f64| w * (re * (w * t).cos() - im * (w * t).sin());
        let constant = -amplitude * sin;
        let damped = (k - 0.25 * c * c).sqrt();
        let u0 = -steady(0.0) - constant;
        let v0 = -rate(0.0);
        let free = (-0.5 * c * t).exp()
            * (u0 * (damped * t).cos() + (v0 + 0.5 * c * u0) / damped * (damped * t).sin());
        steady(t) + constant + free
    };
    for phase in [0.0, 0.7, 2.0] {
        let structure = format!(
            r#"{oscillator}, "supports": {{"base": {{"displacement": {{"sine": {{"amplitude": 0.1, "omega": 2, "phase": {phase}}}}}}}}}"#
        );
        let study = study(
            r#""dt": [0.02, 0.01, 0.005], "duration": 20"#,
            &structure,
            r#""last(m)", "last(base)", "last(base.v)", "energy_error""#,
        );
        let exact = sine(phase, 20.0);
        let errors = [0, 1, 2].map(|number| {
            let found = metrics(&study, number);
            let base = 0.1 * ((40.0 + phase).sin() - phase.sin());
            assert!(
                (found[1] - base).abs() < 1e-15 && found[3] < 1e-13,
                "{found:?}"
            );
            assert!((found[2] - 0.2 * (40.0 + phase).cos()).abs() < 1e-15);
            (found[0] - exact).abs()
        });
        assert!(
            orders(errors)
                .iter()
                .all(|order| (order - 2.0).abs() < 0.35),
            "{phase}: {errors:?}"
        );
    }
    // Straight lines, by the closed form of each: the rest moves with the line, and its velocity jumps at the points.
    let (t, u) = ([0.0, 1.0, 2.5, 4.0, 6.0], [0.0, 0.1, -0.05, 0.2, 0.2]);
    let (mut x, mut v) = (0.0, 0.0);
    let (damped, decay) = ((9.0f64 - 0.15 * 0.15).sqrt(), 0.15);
    for i in 0..4 {
        let (length, slope) = (t[i + 1] - t[i], (u[i + 1] - u[i]) / (t[i + 1] - t[i]));
        let (x0, v0) = (x - u[i], v - slope);
        let (sin, cos) = (damped * length).sin_cos();
        let e = (-decay * length).exp();
        let b = (v0 + decay * x0) / damped;
        x = e * (x0 * cos + b * sin) + u[i + 1];
        v = e * ((b * damped - decay * x0) * cos - (x0 * damped + decay * b) * sin) + slope;
    }
    let structure = format!(
        r#"{oscillator}, "supports": {{"base": {{"displacement": {{"t": [0, 1, 2.5, 4], "u": [0, 0.1, -0.05, 0.2], "between": "straight"}}}}}}"#
    );
    let study = study(
        r#""dt": [0.02, 0.01, 0.005], "duration": 6"#,
        &structure,
        r#""last(m)", "max(base.v)", "energy_error""#,
    );
    let errors = [0, 1, 2].map(|number| {
        let found = metrics(&study, number);
        assert!(
            (found[1] - 1.0 / 6.0).abs() < 1e-15 && found[2] < 1e-13,
            "{found:?}"
        );
        (found[0] - x).abs()
    });
    assert!(
        orders(errors).iter().all(|order| (order - 2.0).abs() < 0.2),
        "{errors:?}"
    );
}

#[test]
fn what_moves_twice_is_refused() {
    let fault = |support: &str| {
        let text = format!(
            r#"{{"problem": "structure", "parameters": {{"dt": 0.1, "duration": 1}}, "metrics": ["peak(m)"],
              "structure": {{"masses": {{"m": 1}}, "springs": [{{"between": ["base", "m"], "k": 9}}], "supports": {{"base": {support}}}}}}}"#
        );
        parse("s", &text).unwrap_err().to_string()
    };
    for (support, message) in [
        (
            r#"{"velocity": 1, "delay": 2}"#,
            "supports.base.delay: a support that has a velocity at t = 0 has no delay",
        ),
        (
            r#"{"x": {"velocity": 1}, "delay": 2}"#,
            "supports.base.delay: a support that has a velocity at t = 0 has no delay",
        ),
        (
            r#"{"velocity": 1, "displacement": {"t": [0, 1], "u": [0, 1]}}"#,
            "supports.base.velocity: a support with displacements has the velocity of these",
        ),
        (
            r#"{"velocity": 1, "x": {"velocity": 1}}"#,
            "supports.base.velocity: give a function of time, which is the motion in x, or x, y and z, not both",
        ),
        (
            r#"{"displacement": {"t": [0, 1], "u": [0, 1], "between": "linear"}}"#,
            "supports.base.displacement.between: unknown line \"linear\"; allowed: cubic, straight",
        ),
        (
            r#"{"displacement": {"sine": {"amplitude": 1}}}"#,
            "supports.base.displacement.sine.omega: missing",
        ),
        (
            r#"{}"#,
            "supports.base: must have exactly one of sine, table, record, pulse, synthetic",
        ),
    ] {
        let found = fault(support);
        assert!(found.contains(message), "{support}: {found}");
    }
}

#[test]
fn gravity_from_the_start_on_lets_bodies_fall() {
    // Free fall, two bodies on one spring, a bar and a mass in another direction: -9.81 t^2/2, whatever holds them together.
    let structure = r#""masses": {"a|b": {"mass": 3, "direction": "y"}, "c": 1}, "springs": [{"between": ["a", "b"], "k": 50}],
        "bars": {"bar": {"L": 1, "EA": 100, "mass": 2, "n": 3, "direction": "y"}}, "gravity": "-g""#;
    let falling = study(
        r#""g": 9.81, "dt": 0.01, "duration": 2"#,
        structure,
        r#""last(a)", "last(b.v)", "last(bar.2)", "last(c)", "energy_error""#,
    );
    let found = metrics(&falling, 0);
    for (value, exact) in found.iter().zip([-19.62, -19.62, -19.62, 0.0, 0.0]) {
        // Constant accelerations are exact in this method: round-off of 200 steps.
        assert!((value - exact).abs() < 1e-11, "{found:?}");
    }
    // A ball that bounces: the same as with the ground that accelerates upwards.
    let ball = |load: &str| {
        let structure = format!(
            r#""masses": {{"ball": {{"mass": 2, "direction": "y"}}}}, {load},
               "contacts": {{"floor": {{"law": "rigid", "between": ["ground", "ball"], "gap": 1, "e": 0.7}}}}"#
        );
        let parameters = r#""dt": 0.001, "duration": 1.5, "method": "moreau-jean""#;
        metrics(
            &study(
                parameters,
                &structure,
                r#""last(ball)", "impacts(floor)", "impulse(floor)""#,
            ),
            0,
        )
    };
    let by_ground = ball(r#""ground": {"y": {"table": {"t": [0, 1], "f": [9.81, 9.81]}}}"#);
    assert_eq!(ball(r#""gravity": -9.81"#), by_ground);
    let both = r#"{"problem": "structure", "parameters": {"dt": 0.1, "duration": 1}, "metrics": ["peak(m)"],
        "structure": {"masses": {"m": {"mass": 1, "direction": "y"}}, "static": {"gravity": -9.81}, "gravity": {"y": -9.81}}}"#;
    let fault = parse("s", both).unwrap_err().to_string();
    assert!(
        fault.contains("structure.static.gravity: give it here or under"),
        "{fault}"
    );
}

#[test]
fn the_force_of_a_spring_to_a_support_is_that_of_its_extension() {
    // A spring that is named has a force, also where the support moves within a step that is long for the structure.
    let study = study(
        r#""dt": 0.05, "duration": 2"#,
        r#""masses": {"a": 1}, "supports": {"base": {"displacement": {"sine": {"amplitude": 0.02, "omega": 9}}}},
           "springs": [{"name": "pier", "between": ["base", "a"], "k": 400}]"#,
        r#""peak(pier.S)", "peak(a - base)""#,
    );
    let found = metrics(&study, 0);
    assert!(
        (found[0] - 400.0 * found[1]).abs() < 1e-13 * found[0],
        "{found:?}"
    );
}
