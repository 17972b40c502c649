//! Stiffness below 0, as of weights that fall, beside closed forms: rocking blocks, an inverted pendulum on a hinge that yields.

use serde_json::{Value as Json, json};
use slipgap::problem::Solution;
use slipgap::study::{self, Study};

fn read(study: &Json) -> Study {
    study::parse("study.json", &study.to_string()).unwrap_or_else(|why| panic!("{why}"))
}

fn solve(study: &Study, case: u64) -> Result<Solution, String> {
    let case = study.case(case).unwrap();
    let solution = study.problem.solve(&case, &study.metrics);
    solution.map_err(|why| why.to_string())
}

/// Why a study or its first case is refused.
fn refused(study: &Json) -> String {
    match study::parse("study.json", &study.to_string()) {
        Err(why) => why.to_string(),
        Ok(study) => solve(&study, 0).map(|_| ()).unwrap_err(),
    }
}

/// The exact motion of a channel at the steps of the first case.
fn exact(study: &Study, name: &str) -> Vec<f64> {
    let case = study.case(0).unwrap();
    let solution = study.problem.solve(&case, &study.metrics).unwrap();
    let columns = study.problem.history_columns(&case);
    let column = columns
        .iter()
        .find(|channel| channel.column.name == name)
        .unwrap();
    solution.exact.channels[column.index].clone()
}

const B: f64 = 1.0;
const H: f64 = 4.0;
const G: f64 = 9.81;

/// A block of width 2 b and height 2 h that starts at rest at the angle `start`. M and K are those of the middle of its base, u and theta.
fn block(start: f64, more: Json) -> Json {
    let inertia = (B * B + H * H) / 3.0 + H * H;
    let mass =
        format!("%%MatrixMarket matrix coordinate real symmetric\n2 2 2\n1 1 1\n2 2 {inertia}\n");
    let stiffness = format!(
        "%%MatrixMarket matrix coordinate real symmetric\n2 2 1\n2 2 {}\n",
        -G * H
    );
    let mut study = json!({
        "problem": "structure",
        "parameters": {"method": "moreau-jean", "theta": 0.5, "dt": 0.01, "duration": 20},
        "structure": {
            "matrices": {"B": {"M": mass, "K": stiffness, "dofs": [["c", "y"], ["t", "z"]]}},
            "contacts": {
                "left": {"law": "rigid", "along": {"B.c.y": 1, "B.t.z": -B}, "e": 0},
                "right": {"law": "rigid", "along": {"B.c.y": 1, "B.t.z": B}, "e": 0}
            },
            "loads": [{"at": "B.c.y", "table": {"t": [0, 1], "f": [-G, -G]}}],
            "start": {"B.c.y": {"u": B * start}, "B.t.z": {"u": start}},
            "contacts_reference": "rigid"
        },
        "metrics": ["last(B.t.z)", "last_error(B.t.z)"]
    });
    for (key, value) in more.as_object().unwrap() {
        study["structure"][key] = value.clone();
    }
    study
}

/// Housner (1963), with the inclination alpha = b/h of small angles, p^2 = m g h/I, I = 4/3 m (b^2 + h^2): from rest at theta0 the
/// block returns in acosh(1/(1 - theta0/alpha))/p, and loses the part 1 - 1.5 sin^2 alpha of its velocity at each impact.
#[test]
fn a_block_rocks_as_housner_says() {
    let (alpha, inertia) = (B / H, 4.0 / 3.0 * (B * B + H * H));
    let p = (G * H / inertia).sqrt();
    let left = 1.0 - 1.5 * B * B / (B * B + H * H);
    for start in [0.02, 0.05, 0.2] {
        let study = read(&block(start, json!({})));
        let motion = exact(&study, "B.t.z.u");
        // Quarters of the motion: from an amplitude to 0, and from 0 with the velocity after the impact to the next amplitude.
        let (mut amplitude, mut sign, mut begin) = (start, 1.0, 0.0);
        let quarter = |amplitude: f64| libm::acosh(1.0 / (1.0 - amplitude / alpha)) / p;
        let mut until = quarter(amplitude);
        let mut impacts = 0;
        for (i, u) in motion.iter().enumerate() {
            let t = 0.01 * i as f64;
            while t > until {
                let before = p * (alpha * alpha - (alpha - amplitude).powi(2)).sqrt();
                let after = left * before / p;
                amplitude = alpha - (alpha * alpha - after * after).sqrt();
                sign = -sign;
                begin = until + quarter(amplitude);
                until += 2.0 * quarter(amplitude);
                impacts += 1;
            }
            if impacts > 12 {
                break;
            }
            let expected = sign * (alpha - (alpha - amplitude) * libm::cosh(p * (t - begin)));
            // The motion between impacts grows as exp(p t), and round-off of 1e-12 of an event with it.
            assert!((u - expected).abs() < 1e-9, "{start} {t} {u} {expected}");
        }
        assert!(impacts > 5, "{start} {impacts}");
    }
}

/// Beyond alpha the block falls over: theta = alpha + (theta0 - alpha) cosh(p t).
#[test]
fn a_block_overturns() {
    let (alpha, inertia) = (B / H, 4.0 / 3.0 * (B * B + H * H));
    let p = (G * H / inertia).sqrt();
    let study = read(&block(0.26, json!({})));
    for (i, u) in exact(&study, "B.t.z.u").iter().enumerate().take(600) {
        let expected = alpha + 0.01 * libm::cosh(p * 0.01 * i as f64);
        assert!((u / expected - 1.0).abs() < 1e-9, "{i} {u} {expected}");
    }
    // By steps, too.
    let solution = solve(&study, 0).unwrap();
    assert!(solution.metrics[0].unwrap() > 1e6);
}

/// The steps of the rocking block tend to the exact motion.
#[test]
fn steps_of_a_rocking_block_tend_to_the_exact_motion() {
    let error = |dt: f64| {
        let mut study = block(0.05, json!({}));
        study["parameters"]["dt"] = json!(dt);
        study["parameters"]["duration"] = json!(1.0);
        study["metrics"] = json!(["last_error(B.t.z)"]);
        solve(&read(&study), 0).unwrap().metrics[0].unwrap().abs()
    };
    let errors = [1e-2, 1e-3, 1e-4].map(error);
    // Of order 1 at impacts.
    assert!(
        errors[1] < 0.3 * errors[0] && errors[2] < 0.3 * errors[1],
        "{errors:?}"
    );
}

/// A mass on a rod that its weight pulls away with 5, on a hinge of 20 that yields at 1: omega^2 = 15 up to the limit, then
/// u'' = 5 u - 1.
fn pendulum(law: &str, velocity: f64, more: Json) -> Json {
    let mut study = json!({
        "problem": "structure", "parameters": {"dt": 0.002, "duration": 2},
        "structure": {
            "masses": {"m": 1}, "springs": [{"between": ["ground", "m"], "k": -5}],
            "contacts": {"h": {"law": law, "between": ["ground", "m"], "k": 20, "limit": 1}},
            "start": {"m": {"v": velocity}}, "contacts_reference": "softened"
        },
        "metrics": ["rms_error(m)", "energy_error"]
    });
    for (key, value) in more.as_object().unwrap() {
        study["structure"][key] = value.clone();
    }
    study
}

#[test]
fn a_pendulum_on_a_hinge_that_yields_moves_as_the_closed_form() {
    let (w, q) = (15f64.sqrt(), 5f64.sqrt());
    for velocity in [0.1, 0.35] {
        let study = read(&pendulum("displacement-control", velocity, json!({})));
        let motion = exact(&study, "m.u");
        // Yields at r = 0.05.
        let reached = 0.05 * w / velocity;
        let yields = if reached < 1.0 {
            libm::asin(reached) / w
        } else {
            f64::INFINITY
        };
        let v_in_yielding = velocity * libm::cos(w * yields.min(0.0)).max(0.0);
        let v = if reached < 1.0 {
            velocity * (1.0 - reached * reached).sqrt()
        } else {
            v_in_yielding
        };
        let mut compared = 0;
        for (i, u) in motion.iter().enumerate() {
            let t = 0.002 * i as f64;
            let expected = match t < yields {
                true => velocity / w * libm::sin(w * t),
                false => {
                    0.2 - 0.15 * libm::cosh(q * (t - yields)) + v / q * libm::sinh(q * (t - yields))
                }
            };
            let before = if t < yields {
                1.0
            } else {
                v * libm::cosh(q * (t - yields)) - 0.15 * q * libm::sinh(q * (t - yields))
            };
            if before < 0.0 {
                break;
            }
            compared += 1;
            assert!(
                (u - expected).abs() < 1e-11,
                "{velocity} {t} {u} {expected}"
            );
        }
        assert!(compared > 100, "{compared}");
        let metrics = solve(&study, 0).unwrap().metrics;
        assert!(
            metrics[0].unwrap() < 1e-3 * 0.1 && metrics[1].unwrap() < 1e-10,
            "{metrics:?}"
        );
    }
}

/// u = F/(k - 5) of the hinge below its limit, and the steps stay there.
#[test]
fn a_static_load_is_held_by_the_hinge() {
    for law in ["displacement-control", "bouc-wen"] {
        let more = json!({"static": {"m": 0.3}, "start": {}});
        let mut study = pendulum(law, 0.0, more);
        study["metrics"] = json!(["min(m)", "max(m)"]);
        for u in solve(&read(&study), 0).unwrap().metrics {
            let u = u.unwrap();
            match law {
                "bouc-wen" => assert!(u > 0.02 && u < 0.04, "{u}"),
                _ => assert!((u - 0.02).abs() < 1e-11, "{u}"),
            }
        }
    }
}

#[test]
fn what_nothing_holds_is_refused() {
    let mut study = pendulum("displacement-control", 0.1, json!({}));
    study["structure"]
        .as_object_mut()
        .unwrap()
        .remove("contacts");
    let why = refused(&study);
    assert!(
        why.contains("the stiffness pulls m away, and no contact holds it"),
        "{why}"
    );
    // A hinge that is too weak, and a dashpot.
    let mut study = pendulum("displacement-control", 0.1, json!({}));
    study["structure"]["contacts"]["h"]["k"] = json!(4.9);
    assert!(refused(&study).contains("pulls m away"));
    let dashpot =
        json!({"contacts": {"h": {"law": "viscous", "between": ["ground", "m"], "c": 20, "a": 1}}});
    assert!(refused(&pendulum("x", 0.1, dashpot)).contains("pulls m away"));
    // Damping in proportion to K.
    let rayleigh = json!({"rayleigh": {"mass": 0, "stiffness": 0.01}});
    let why = refused(&pendulum("displacement-control", 0.1, rayleigh));
    assert!(why.contains("feed the motion"), "{why}");
    let held = json!({"rayleigh": {"mass": 0, "stiffness": 0.01}, "damping_stiffness": "initial"});
    solve(&read(&pendulum("displacement-control", 0.1, held)), 0).unwrap();
    // Of matrices, with the name of the dof.
    let mut study = block(0.05, json!({}));
    study["structure"]["contacts"] = json!({});
    let why = refused(&study);
    assert!(why.contains("pulls B.t.z away"), "{why}");
}

/// K^ = K + 4 M/dt^2 needs dt < 2/sqrt(5).
#[test]
fn a_step_that_is_too_long_is_refused_with_the_longest() {
    let mut study = pendulum("displacement-control", 0.1, json!({}));
    study["parameters"]["dt"] = json!(1.0);
    study["structure"]
        .as_object_mut()
        .unwrap()
        .remove("contacts_reference");
    study["metrics"] = json!(["last(m)"]);
    let why = refused(&study);
    assert!(
        why.contains("not positive definite at node m") && why.contains("dt up to about 0.894"),
        "{why}"
    );
}

/// Modal damping leaves the mode that is pulled away undamped.
#[test]
fn modal_damping_works() {
    let study = read(&pendulum(
        "displacement-control",
        0.1,
        json!({"modal_damping": 0.05}),
    ));
    let undamped = read(&pendulum("displacement-control", 0.1, json!({})));
    assert_eq!(exact(&study, "m.u"), exact(&undamped, "m.u"));
}
