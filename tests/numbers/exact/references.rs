//! `reference_error` of integrated motions: small where they are right, whatever law, start, gap and support.

use serde_json::{Value as Json, json};
use slipgap::study;

/// Laws of all forms that integrated motions know.
fn laws() -> Vec<Json> {
    vec![
        json!({"law": "bouc-wen", "limit": 2, "k": 2000, "exponent": 2}),
        json!({"law": "bouc-wen", "limit": 2, "k": 2000, "exponent": 1, "beta": 0.9}),
        json!({"law": "bouc-wen", "limit": 2, "k": 2000, "exponent": 3, "beta": 0.3}),
        json!({"law": "dahl", "limit": 2, "k": 2000}),
        json!({"law": "lugre", "limit": 2, "sigma0": 2000, "sigma1": 20}),
        json!({"law": "tanh", "limit": 2, "rdotE": 0.02}),
        json!({"law": "stribeck", "limit": 2, "rdotE": 0.05, "static_ratio": 1.2, "stribeck_velocity": 0.3}),
        json!({"law": "stribeck-hyperbolic", "limit": 2, "rdotE": 0.05, "static_ratio": 1.2, "stribeck_velocity": 0.3}),
        json!({"law": "viscous", "c": 5, "a": 0.5}),
        json!({"law": "viscous", "c": 5, "a": 2}),
        json!({"law": "pendulum", "k": 2000, "nu": 0.1, "N": 20, "R": 1}),
        json!({"law": "bilinear", "k1": 2000, "Fy": 2, "k2": 100}),
        json!({"law": "displacement-control", "k": 2000, "limit": 2}),
        json!({"law": "velocity-control", "c": 30, "limit": 2}),
        json!({"law": "hertz", "k_h": 3e4}),
        json!({"law": "hunt-crossley", "k_h": 3e4, "restitution": 0.7}),
        json!({"law": "ye", "k_h": 3e4, "restitution": 0.7}),
        json!({"law": "jankowski", "k_h": 3e4, "restitution": 0.7, "colliding_mass": 1}),
        json!({"law": "kelvin-voigt", "k": 3000, "restitution": 0.7, "colliding_mass": 1}),
        json!({"law": "hyperbolic-gap", "k": 3000, "Fult": 6}),
        json!({"law": "impact-yield", "k1": 3000, "k2": 500, "delta_y": 0.001}),
    ]
}

#[test]
fn right_motions_have_small_errors() {
    let starts = [
        json!({"start": {"m": {"u": -0.01}}}),
        json!({"start": {"m": {"u": 0.008, "v": 0.3}}}),
        json!({"start": {"m": {"v": -0.3}}, "static": {"m": 1.2}}),
        json!({"static": {"m": 1.2}, "supports": {"s": {"sine": {"amplitude": 4, "omega": 20, "phase": 1}}}}),
    ];
    let mut refused = 0;
    for law in laws() {
        for gap in [0.0, 0.003] {
            for more in &starts {
                let mut contact = law.clone();
                let moves = more.get("supports").is_some();
                contact["between"] = json!([if moves { "s" } else { "ground" }, "m"]);
                contact["gap"] = json!(gap);
                // An open contact makes every motion an integrated one.
                let idle =
                    json!({"law": "hertz", "between": ["ground", "m"], "k_h": 1e4, "gap": 5});
                let mut study = json!({
                    "problem": "structure", "parameters": {"dt": [0.004, 0.001], "duration": 0.2},
                    "structure": {
                        "masses": {"m": 1}, "springs": [{"between": ["ground", "m"], "k": 100, "c": 0.2}],
                        "contacts": {"c": contact, "idle": idle}
                    },
                    "metrics": ["reference_error(m)", "reference_error(m.v)", "reference_error(c.S)"]
                });
                for (key, value) in more.as_object().unwrap() {
                    study["structure"][key] = value.clone();
                }
                let study = study::parse("study.json", &study.to_string()).unwrap();
                for case in 0..2 {
                    let solved = study
                        .problem
                        .solve(&study.case(case).unwrap(), &study.metrics);
                    // Impacts with damping that rest on a support that shakes take too many steps.
                    let Ok(solved) = solved else {
                        refused += 1;
                        continue;
                    };
                    let errors = solved.metrics;
                    // Displacements of 0.01, velocities of 0.3 and forces of 5. Two tolerances differ by 1e-10 a step, which a corner
                    // of the law or a short touch magnifies.
                    for (error, size) in errors.iter().zip([0.01, 0.3, 5.0]) {
                        let error = error.unwrap() / size;
                        assert!(error < 1e-7, "{contact} {more} {case}: {error:e}");
                    }
                }
            }
        }
    }
    // Both with two gaps and two steps.
    assert!(refused <= 8, "{refused}");
}
