//! Starts of the exact motions: the motion by events against the integrated one, closed forms, and forces in equilibrium at t = 0.

use serde_json::{Value as Json, json};
use slipgap::problem::Solution;
use slipgap::study::{self, Study};

fn read(study: &Json) -> Study {
    study::parse("study.json", &study.to_string()).unwrap_or_else(|why| panic!("{why}"))
}

fn solve(study: &Study) -> Solution {
    let case = study.case(0).unwrap();
    let solution = study.problem.solve(&case, &study.metrics);
    solution.unwrap_or_else(|why| panic!("{why}"))
}

/// A mass on a spring with a contact to the ground or a support, with `more` beside it; its parameters have dt.
fn oscillator(contact: &Json, more: &Json, dt: f64, metrics: &[&str]) -> Json {
    let mut study = json!({
        "problem": "structure", "parameters": {"dt": dt, "duration": 0.4},
        "structure": {
            "masses": {"m": 1}, "springs": [{"between": ["ground", "m"], "k": 100}], "contacts": {"c": contact},
            "contacts_reference": "softened"
        },
        "metrics": metrics,
        "figures": [{"name": "h", "kind": "history", "y": ["m", "c.S"]}]
    });
    for (key, value) in more.as_object().unwrap() {
        study["structure"][key] = value.clone();
    }
    study
}

/// The laws whose motion is known by events, between straight lines.
fn laws() -> Vec<Json> {
    vec![
        json!({"law": "displacement-control", "k": 2000, "limit": 2}),
        json!({"law": "velocity-control", "c": 30, "limit": 2}),
        json!({"law": "pendulum", "k": 2000, "nu": 0.1, "N": 20, "R": 1}),
        json!({"law": "bilinear", "k1": 2000, "Fy": 2, "k2": 100}),
        json!({"law": "multilinear", "table": {"r": [0.001, 0.004, 0.01], "S": [2, 4, 5]}}),
        json!({"law": "impact", "k": 3000}),
        json!({"law": "gap-yield", "k": 3000, "Fy": 3, "hardening": 0.1}),
        json!({"law": "impact-yield", "k1": 3000, "k2": 500, "delta_y": 0.001}),
        json!({"law": "restrainer", "slack": 0.005, "k": 3000, "Fy": 3}),
    ]
}

#[test]
fn an_idle_contact_changes_no_exact_motion() {
    // A contact of Hertz's law makes the exact motion an integrated one; it stays open.
    let idle = json!({"law": "hertz", "between": ["ground", "m"], "k_h": 1e4, "gap": 5});
    let starts = [
        json!({"start": {"m": {"u": -0.01}}}),
        json!({"start": {"m": {"u": 0.008, "v": 0.3}}}),
        json!({"start": {"m": {"v": 0.3}}, "static": {"m": 3}}),
        json!({"static": {"m": 3}, "supports": {"s": {"sine": {"amplitude": 4, "omega": 20, "phase": 1}}}}),
    ];
    for law in laws() {
        for gap in [0.0, 0.004] {
            for more in &starts {
                let mut contact = law.clone();
                let moves = more.get("supports").is_some();
                contact["between"] = json!([if moves { "s" } else { "ground" }, "m"]);
                contact["gap"] = json!(gap);
                let study = |with_idle: bool| {
                    let mut study = oscillator(&contact, more, 0.002, &["rms_error(m)"]);
                    if with_idle {
                        study["structure"]["contacts"]["idle"] = idle.clone();
                    }
                    solve(&read(&study)).exact
                };
                let [events, integrated] = [study(false), study(true)];
                assert_eq!((events.len(), integrated.len()), (201, 201));
                for (channel, scale) in [(0, 0.02), (1, 5.0)] {
                    let pairs = events
                        .channel(channel)
                        .iter()
                        .zip(integrated.channel(channel));
                    let error = pairs.fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
                    // The integration has 1e-12 a step, and a static equilibrium 1e-11 of u. A stiffness of 3000 magnifies the error of r
                    // in S.
                    let most = if channel == 0 { 1e-9 } else { 1e-7 };
                    assert!(error <= most * scale, "{contact} {more} {channel}: {error}");
                }
            }
        }
    }
}

#[test]
fn a_lugre_contact_that_leaves_its_equilibrium_has_bent_bristles() {
    // Integrated by the method of Runge and Kutta in the form of the authors: z, not S, is the state, and z(0) is that of the equilibrium
    // k u + sigma0 z = p with z = u, since the load has bent it from rest, where S = sigma0 z < limit.
    let [k, c, p, sigma0, sigma1, limit, v0] = [150.0, 0.4, 0.6, 800.0, 40.0, 1.0, -0.5];
    let contact = json!({"law": "lugre", "between": ["ground", "m"], "sigma0": sigma0, "sigma1": sigma1, "limit": limit});
    let more = json!({
        "springs": [{"between": ["ground", "m"], "k": k, "c": c}], "static": {"m": p}, "start": {"m": {"v": v0}}
    });
    let metrics = ["rms_error(m)", "rms_error(c.S)"];
    let dt = 0.4 / 3200.0;
    let solution = solve(&read(&oscillator(&contact, &more, dt, &metrics)));
    let u = solution.exact.channel(0);
    let z0 = (p - k * u[0]) / sigma0;
    let bristle = |v: f64, z: f64| v - sigma0 * v.abs() * z / limit;
    let rates = |[u, v, z]: [f64; 3]| {
        let force = sigma0 * z + sigma1 * bristle(v, z);
        [v, p - k * u - c * v - force, bristle(v, z)]
    };
    let mut state = [u[0], v0, z0];
    let (inner, mut most) = (8, 0.0_f64);
    let h = dt / f64::from(inner);
    for expected in &u[1..] {
        for _ in 0..inner {
            let at = |by: f64, rate: [f64; 3]| [0, 1, 2].map(|i| state[i] + by * rate[i]);
            let first = rates(state);
            let second = rates(at(0.5 * h, first));
            let third = rates(at(0.5 * h, second));
            let fourth = rates(at(h, third));
            state = [0, 1, 2].map(|i| {
                state[i] + h / 6.0 * (first[i] + 2.0 * (second[i] + third[i]) + fourth[i])
            });
        }
        most = most.max((state[0] - expected).abs());
    }
    // Displacements up to 0.02; at a reversal the method of fourth order has a corner of the rates inside of a step of 1.6e-5.
    assert!(most < 1e-9, "{most}");
    // S(0) has the damping of the bristles, in both motions.
    let force = sigma0 * z0 + sigma1 * bristle(v0, z0);
    let found = [&solution.computed, &solution.exact].map(|motion| motion.channel(1)[0]);
    for found in found {
        assert!((found / force - 1.0).abs() < 1e-12, "{found} {force}");
    }
    // Of second order, so that half the step has a quarter of the error.
    let errors = [dt, 0.5 * dt].map(|dt| {
        let solution = solve(&read(&oscillator(&contact, &more, dt, &metrics)));
        solution.metrics[0].unwrap()
    });
    assert!((errors[0] / errors[1] - 4.0).abs() < 0.5, "{errors:?}");
}

#[test]
fn contacts_in_series_have_one_force_from_the_start() {
    // Friction that slides at its limit and a spring, pressed at t = 0: the spring has no more than the limit.
    let series = |laws: Json| json!({"between": ["ground", "m"], "series": laws});
    let more = json!({"start": {"m": {"u": -0.02, "v": -0.5}}});
    let both = [
        json!([{"law": "dahl", "k": 1182, "limit": 0.6, "exponent": 1.5}, {"law": "impact-spring", "k": 6738}]),
        json!([{"law": "displacement-control", "k": 900, "limit": 0.6}, {"law": "bilinear", "k1": 2e4, "Fy": 3, "k2": 400}]),
        json!([{"law": "viscous", "c": 3, "a": 1}, {"law": "impact-spring", "k": 6738}]),
    ];
    for laws in both {
        let mut study = oscillator(&series(laws.clone()), &more, 0.0005, &["energy_error"]);
        study["figures"][0]["y"] = json!(["c.1.S", "c.2.S"]);
        // No exact motion of these laws is known at nodes without mass.
        study["structure"]
            .as_object_mut()
            .unwrap()
            .remove("contacts_reference");
        let solution = solve(&read(&study));
        let [first, second] = [0, 1].map(|channel| solution.computed.channel(channel));
        assert!(first.iter().any(|s| *s != 0.0));
        assert_eq!(first, second, "{laws}");
        // The books begin with the energy of these forces.
        let energy_error = solution.metrics[0].unwrap();
        assert!(energy_error < 1e-12, "{laws}: {energy_error}");
    }
}

#[test]
fn a_spring_on_a_contact_without_mass_shares_its_compression() {
    // k1 k2/(k1 + k2) u = 500 * 0.01 at t = 0, and errors of second order from there on.
    let contact = json!({"law": "impact-spring", "k": 1000, "between": ["ground", "z"]});
    let study = |dt: f64| {
        let more = json!({
            "masses": {"m": 1, "z": 0}, "start": {"m": {"u": -0.01}},
            "springs": [{"between": ["ground", "m"], "k": 100}, {"between": ["m", "z"], "k": 1000}]
        });
        oscillator(
            &contact,
            &more,
            dt,
            &["rms_error(m)", "peak(c.S)", "energy_error"],
        )
    };
    let errors = [0.002, 0.001, 0.0005].map(|dt| {
        let metrics = solve(&read(&study(dt))).metrics;
        // Round-off.
        assert!((metrics[1].unwrap() - 5.0).abs() < 1e-12, "{metrics:?}");
        assert!(metrics[2].unwrap() < 1e-12, "{metrics:?}");
        metrics[0].unwrap()
    });
    assert!(
        errors[2] < 0.3 * errors[1] && errors[1] < 0.4 * errors[0],
        "{errors:?}"
    );
}

#[test]
fn friction_takes_a_body_with_its_support_from_the_start() {
    // The support has the acceleration 4 at t = 0, the body the mass 2: friction gives it 8, or its limit.
    for (limit, force) in [(100.0, -8.0), (5.0, -5.0)] {
        let contact = json!({"law": "coulomb", "limit": limit, "between": ["s", "m"]});
        let more = json!({
            "masses": {"m": 2},
            "supports": {"s": {"sine": {"amplitude": 4, "omega": 3, "phase": std::f64::consts::FRAC_PI_2}}}
        });
        let solution = solve(&read(&oscillator(&contact, &more, 0.01, &["peak(m)"])));
        let first = solution.computed.channel(1)[0];
        // The sine of pi/2 as a number.
        assert!((first - force).abs() < 1e-12, "{first} {force}");
    }
}

#[test]
fn a_spring_that_yields_at_a_constant_force_has_an_integrated_motion() {
    // Its force stays at the bound but for round-off. The motion by events, without the contact that is never closed.
    let idle = json!({"law": "hertz", "between": ["ground", "m"], "k_h": 1e4, "gap": 5});
    let laws = [
        json!({"law": "restrainer", "k": 402.3754129207024, "Fy": 0.7344961635690357}),
        json!({"law": "restrainer", "slack": 0.003, "k": 3850, "Fy": 1.6}),
        json!({"law": "gap-yield", "k": 1759.8, "Fy": 1.15, "damage": 0}),
        json!({"law": "gap-yield", "k": 20203.9, "Fy": 0.7}),
        json!({"law": "bilinear", "k1": 900, "Fy": 0.7, "k2": 0}),
    ];
    for law in laws {
        let mut contact = law;
        contact["between"] = json!(["n", "m"]);
        let more = json!({
            "masses": {"m": 1, "n": 2.5824382129935706},
            "springs": [
                {"between": ["ground", "m"], "k": 100, "c": 0.3},
                {"between": ["ground", "n"], "k": 219.59007761901367, "c": 0.5}
            ],
            "start": {"m": {"u": 0.011218262244395708, "v": 0.04424675780288012}},
            "loads": [{"at": "m", "sine": {"amplitude": 3.551404613950479, "omega": 24.38444864000378, "phase": 1}}]
        });
        let exact = |with_idle: bool| {
            let mut study = oscillator(&contact, &more, 0.002, &["rms_error(m)"]);
            if with_idle {
                study["structure"]["contacts"]["idle"] = idle.clone();
            }
            solve(&read(&study)).exact
        };
        let [events, integrated] = [false, true].map(exact);
        let pairs = events.channel(0).iter().zip(integrated.channel(0));
        let error = pairs.fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
        // 1e-12 a step, of displacements up to 0.03.
        assert!(error < 1e-11, "{contact}: {error:e}");
    }
}

#[test]
fn a_damper_with_a_root_of_the_velocity_leaves_rest_under_a_load_that_grows() {
    // m v' = p t - c v^(1/2) has v = s^2 t^2 with 2 m s^2 + c s = p: the same shape at all times, however short.
    let [p, c]: [f64; 2] = [12.0, 1.7];
    let s = (c * c + 8.0 * p).sqrt() / 4.0 - c / 4.0;
    let contact = json!({"law": "viscous", "c": c, "a": 0.5, "between": ["ground", "m"]});
    let more = json!({
        "springs": [], "loads": [{"at": "m", "table": {"t": [0, 1], "f": [0, p]}}]
    });
    let solution = solve(&read(&oscillator(
        &contact,
        &more,
        0.004,
        &["rms_error(m)"],
    )));
    for (i, u) in solution.exact.channel(0).iter().enumerate() {
        let t = 0.004 * i as f64;
        let expected = s * s * t * t * t / 3.0;
        // 1e-12 of the largest displacement a step.
        assert!((u - expected).abs() < 1e-12, "{t} {u:e} {expected:e}");
    }
}

#[test]
fn bodies_that_touch_at_rest_close_without_a_closing_speed() {
    // These laws divide their damping by the closing speed. That of bodies which touch at rest is 0, so that the first contact has the
    // motion of Hertz's law; an error of the integration in its place made the damping nearly infinite.
    let study = |law: Json| {
        let mut contact = law;
        contact["between"] = json!(["a", "b"]);
        json!({
            "problem": "structure", "parameters": {"dt": 0.002, "duration": 0.4},
            "structure": {
                "units": "t, kN, m, s",
                "masses": {"a": 1.930280484157205, "b": 2.35807544590185},
                "springs": [
                    {"between": ["ground", "a"], "k": 68.4511536122379, "c": 0.16454912851199277},
                    {"between": ["ground", "b"], "k": 412.57362292401484, "c": 0.3587689711620866}
                ],
                "contacts": {
                    "c0": {"law": "pendulum", "k": 5565.82544616424, "nu": 0.1, "N": 18.25213491397164, "R": 1.181250642318385, "between": ["a", "b"]},
                    "c1": contact
                },
                "ground": {"pulse": {"ricker": {"amplitude": 1.6681465767863308, "frequency": 2.8455294809093887, "at": 0.10124929943131183, "sampled": 0.005}}},
                "contacts_reference": "softened"
            },
            "metrics": ["rms_error(a)", "reference_error(a)"],
            "figures": [{"name": "h", "kind": "history", "y": ["a", "c1.S"]}]
        })
    };
    let k = 34562.84162766597;
    let hertz = solve(&read(&study(json!({"law": "hertz", "k_h": k})))).exact;
    let pushes = |step: usize| hertz.channel(1)[step] < 0.0;
    let begin = (1..200).find(|step| pushes(*step)).unwrap();
    let end = (begin..200).find(|step| !pushes(*step)).unwrap_or(200);
    for law in ["hunt-crossley", "hertz-damp", "ye"] {
        let solution = solve(&read(&study(
            json!({"law": law, "k_h": k, "restitution": 0.4439395921955577}),
        )));
        assert!(
            solution.metrics[1].unwrap() < 1e-12,
            "{law} {:?}",
            solution.metrics
        );
        if begin > 1 {
            continue;
        }
        for step in 0..end {
            let [damped, undamped] = [&solution.exact, &hertz].map(|exact| exact.channel(0)[step]);
            // The tolerance of the integration, 1e-12 a step of displacements up to 0.03.
            assert!(
                (damped - undamped).abs() < 1e-11,
                "{law} {step} {damped:e} {undamped:e}"
            );
        }
    }
}

/// The error of the displacement of d falls as dt^order, from these steps to the half of them.
fn tends_to_the_exact_motion(structure: &Json, dt: f64, order: i32) {
    let errors = [1.0, 0.5, 0.25].map(|part| {
        let study = json!({
            "problem": "structure", "parameters": {"dt": part * dt, "duration": 0.5},
            "structure": structure, "metrics": ["rms_error(d)"]
        });
        solve(&read(&study)).metrics[0].unwrap()
    });
    for pair in errors.windows(2) {
        // Events between the steps scatter the errors.
        assert!(
            pair[1] < 1.5 * 0.5_f64.powi(order) * pair[0],
            "{structure}: {errors:?}"
        );
    }
}

/// A node without mass between a spring and a contact that static loads press: the steps have the same start.
#[test]
fn forces_at_rest_are_kept_at_nodes_without_mass() {
    for contact in [
        json!({"law": "coulomb", "limit": 5}),
        json!({"law": "displacement-control", "limit": 5, "k": 3000}),
        json!({"law": "impact", "k": 3000, "between": ["p", "ground"]}),
    ] {
        let mut structure = json!({
            "masses": {"d": 2, "p": 0},
            "springs": [{"between": ["ground", "d"], "k": 50}, {"between": ["p", "d"], "k": 1000}],
            "contacts": {"c": {"between": ["ground", "p"]}},
            "static": {"d": 4}, "start": {"d": {"v": 0.1}}, "contacts_reference": "softened"
        });
        for (key, value) in contact.as_object().unwrap() {
            structure["contacts"]["c"][key] = value.clone();
        }
        tends_to_the_exact_motion(&structure, 0.004, 2);
    }
}

/// A floor and two springs press the friction of d.
#[test]
fn several_parts_press_as_in_converged_steps() {
    for slide in [
        json!({"law": "displacement-control", "k": 2000}),
        json!({"law": "velocity-control", "c": 100}),
        json!({"law": "coulomb"}),
    ] {
        let mut structure = json!({
            "units": "t, kN, m, s", "masses": {"d": 2, "y": {"mass": 2, "direction": "y"}},
            "springs": [
                {"between": ["ground", "d"], "k": 50}, {"name": "a", "between": ["ground", "y"], "k": 3000},
                {"name": "b", "between": ["ground", "y"], "k": 2000, "c": 5}
            ],
            "contacts": {
                "slide": {"between": ["ground", "d"], "nu": 0.3, "N": {"contact": ["floor", "a", "b"]}},
                "floor": {"law": "impact", "between": ["ground", "y"], "k": 1e4}
            },
            "static": {"gravity": -9.81}, "contacts_reference": "softened",
            "loads": [
                {"at": "d", "sine": {"amplitude": 10, "omega": 7}}, {"at": "y", "sine": {"amplitude": 6, "omega": 11}}
            ]
        });
        for (key, value) in slide.as_object().unwrap() {
            structure["contacts"]["slide"][key] = value.clone();
        }
        // Coulomb friction errs by its corners.
        tends_to_the_exact_motion(&structure, 0.002, 1);
    }
}
