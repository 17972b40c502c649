//! Friction that another part presses: a mass on a belt, whose friction couples both directions, against an independent integration.

use serde_json::{Value as Json, json};

const MU: f64 = 0.2;
const SPRINGS: [f64; 3] = [1.0, 0.6, 0.8];
const SPEED: f64 = 0.1;

/// The springs k1 and k2 at 150 and 30 degrees, k3 below the mass, which presses it on the belt.
fn study(dt: f64, duration: f64, method: &str, metrics: &[&str]) -> Json {
    let (c, s) = (f64::sqrt(0.75), 0.5);
    json!({
        "problem": "structure",
        "parameters": {"dt": dt, "duration": duration, "method": method},
        "structure": {
            "masses": {"m": {"mass": 1, "direction": ["x", "y"]}, "belt": {"mass": 1e15}},
            "springs": [
                {"along": {"m.x": -c, "m.y": s}, "k": SPRINGS[0]},
                {"along": {"m.x": c, "m.y": s}, "k": SPRINGS[1]},
                {"name": "normal", "between": ["ground", "m.y"], "k": SPRINGS[2]}
            ],
            "contacts": {"pad": {"law": "coulomb", "between": ["belt", "m.x"], "nu": MU, "N": {"contact": "normal"}}},
            "static": {"m.y": -10},
            "start": {"m.x": {"v": SPEED}, "belt": {"v": 100}}
        },
        "metrics": metrics
    })
}

fn metrics(study: &Json) -> Vec<f64> {
    let study = slipgap::study::parse("study.json", &study.to_string()).unwrap();
    let solution = study.problem.solve(&study.case(0).unwrap(), &[]).unwrap();
    solution.metrics.into_iter().map(Option::unwrap).collect()
}

/// K of the springs: kxx, kxy and kyy.
fn stiffness() -> [f64; 3] {
    let [k1, k2, k3] = SPRINGS;
    let cs = f64::sqrt(0.75) * 0.5;
    [0.75 * (k1 + k2), cs * (k2 - k1), 0.25 * (k1 + k2) + k3]
}

/// x and x' of the mass at a time by the rule of Runge and Kutta with steps of 1e-3: while it slides, x'' = -(K u)_x - mu k3 y.
fn integrated(end: f64) -> [f64; 2] {
    let [xx, xy, yy] = stiffness();
    let rate = |[x, y, vx, vy]: [f64; 4]| {
        let friction = -MU * SPRINGS[2] * y;
        [vx, vy, friction - xx * x - xy * y, -10.0 - xy * x - yy * y]
    };
    let det = xx * yy - xy * xy;
    let mut z = [10.0 * xy / det, -10.0 * xx / det, SPEED, 0.0];
    let h = 1e-3;
    let moved = |z: [f64; 4], k: [f64; 4], h: f64| std::array::from_fn(|i| z[i] + h * k[i]);
    for _ in 0..(end / h).round() as usize {
        let a = rate(z);
        let b = rate(moved(z, a, 0.5 * h));
        let c = rate(moved(z, b, 0.5 * h));
        let d = rate(moved(z, c, h));
        z = std::array::from_fn(|i| z[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]));
    }
    [z[0], z[2]]
}

#[test]
fn friction_by_a_spring_is_of_second_order() {
    let right = integrated(20.0);
    for method in ["average-acceleration", "moreau-jean", "bathe", "hht"] {
        let error = |dt: f64| {
            let end = metrics(&study(dt, 20.0, method, &["last(m.x)", "last(m.x.v)"]));
            f64::hypot(end[0] - right[0], end[1] - right[1])
        };
        let [coarse, fine] = [0.04, 0.02].map(error);
        assert!(
            (3.7..4.3).contains(&(coarse / fine)) && fine < 2e-3,
            "{method}: {coarse} {fine}"
        );
    }
}

#[test]
fn a_neutral_system_does_not_grow() {
    // K of the sliding mass has the real eigenvalues 1.03 and 1.37: no motion of it grows. Two frequencies beat.
    let [xx, xy, yy] = stiffness();
    let (trace, det) = (xx + yy, xx * yy - xy * (xy + MU * SPRINGS[2]));
    assert!(trace * trace > 4.0 * det);
    for method in [
        "average-acceleration",
        "moreau-jean",
        "bathe",
        "contact-stabilized-newmark",
    ] {
        for dt in [0.3, 0.1] {
            let peak = |duration: f64| metrics(&study(dt, duration, method, &["peak(m.x.v)"]))[0];
            let [short, long] = [100.0, 1000.0].map(peak);
            assert!(long / short < 1.01, "{method} {dt}: {short} {long}");
        }
    }
}

/// The belt is slow, so that the mass sticks to it at times: with 0.2 it does so for good.
#[test]
fn steps_tend_to_the_exact_motion_of_coulomb_friction_by_a_spring() {
    for mu in [0.2, 0.4] {
        let errors = |dt: f64| {
            let asked = ["step_error(m.x)", "step_error(m.x.v)"];
            let mut study = study(dt, 30.0, "average-acceleration", &asked);
            study["structure"]["contacts"]["pad"]["nu"] = json!(mu);
            study["structure"]["start"]["belt"]["v"] = json!(0.5);
            metrics(&study)
        };
        let [coarse, fine] = [0.08, 0.01].map(errors);
        for (coarse, fine) in coarse.iter().zip(&fine) {
            // 8^2 of the second order; a stop and the begin of a slide are anywhere within a step.
            let ratio = coarse / fine;
            assert!((40.0..100.0).contains(&ratio), "{mu}: {coarse} {fine}");
        }
    }
}

/// A pad on a node without mass: friction in one direction presses it more, so that N = p + mu N, in the other N = p - mu N.
fn pad(mu: f64, speed: f64, method: &str) -> Json {
    json!({
        "problem": "structure",
        "parameters": {"dt": 0.01, "duration": 2, "method": method},
        "structure": {
            "masses": {"x": 1e15, "y": 0},
            "springs": [{"name": "normal", "between": ["ground", "y"], "k": 1}],
            "contacts": {"pad": {"law": "displacement-control", "along": {"x": 1, "y": 1}, "k": 1e3, "nu": mu,
                "N": {"contact": "normal"}}},
            "static": {"y": -0.01},
            "start": {"x": {"v": speed}}
        },
        "metrics": ["last(pad.S)"]
    })
}

#[test]
fn friction_that_raises_its_own_limit_has_the_closed_form() {
    for method in ["average-acceleration", "hht"] {
        for (mu, speed) in [
            (0.5, 1.0),
            (0.9, 1.0),
            (0.99, 1.0),
            (0.9, -1.0),
            (5.0, -1.0),
        ] {
            let force = metrics(&pad(mu, speed, method))[0];
            let right = speed * mu * 0.01 / (1.0 - speed * mu);
            // A limit stays to 1e-13 of itself from round to round.
            assert!(
                (force / right - 1.0).abs() < 1e-10,
                "{method} {mu} {speed}: {force} {right}"
            );
        }
    }
}

/// With mu > 1 a pad that is pulled off while it slides may stick, slide or lift off.
#[test]
fn limits_that_do_not_settle_are_an_error() {
    let mut study = pad(1.1, 1.0, "average-acceleration");
    study["parameters"]["dt"] = json!(0.001);
    let structure = &mut study["structure"];
    structure["masses"]["x"] = json!(1);
    structure["springs"] = json!([
        {"between": ["ground", "x"], "k": 50},
        {"name": "normal", "between": ["ground", "y"], "k": 1e4}
    ]);
    structure["contacts"]["pad"]["k"] = json!(2e6);
    structure["static"] = json!({"y": 0});
    structure["loads"] = json!([{"at": "y", "sine": {"amplitude": 5, "omega": 9}}]);
    let study = slipgap::study::parse("study.json", &study.to_string()).unwrap();
    let fault = study.problem.solve(&study.case(0).unwrap(), &[]);
    let Err(fault) = fault.map(|_| ()) else {
        panic!("a step without an answer was taken");
    };
    let fault = fault.to_string();
    assert!(
        fault.contains("raises the force that presses it"),
        "{fault}"
    );
}
