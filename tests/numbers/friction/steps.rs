//! The friction oscillator: order of convergence, and identities of every step for any parameters.

use crate::common;
use common::case;
use proptest::prelude::*;
use serde_json::{Value as Json, json};
use slipgap::history::History;
use slipgap::problem::find;
use std::f64::consts::PI;

/// The computed history of a case of plain values.
fn computed(given: &Json) -> History {
    let problem = find("friction-oscillator").unwrap();
    problem
        .solve(&case(&*problem, given), &[])
        .unwrap()
        .computed
}

/// X at T = i pi/20, i = 0..=160, by the classical Runge-Kutta method with 2000 steps between; no part of slipgap.
fn fine(given: &Json) -> Vec<f64> {
    let number = |name: &str| given[name].as_f64();
    let (x0, h) = (number("x0").unwrap(), PI / 40_000.0);
    let (alpha, beta) = (number("alpha"), number("beta"));
    let elastic = |x: f64, slip: f64, alpha: f64| ((x - slip) / alpha).clamp(-1.0, 1.0);
    let force = |x: f64, v: f64, slip: f64| match (alpha, beta) {
        (Some(alpha), _) => elastic(x, slip, alpha),
        (_, Some(beta)) => (v / beta).clamp(-1.0, 1.0),
        _ => unreachable!(),
    };
    let mut slip = x0;
    if let (Some(alpha), Some(release)) = (alpha, given["initial_slip"].as_str()) {
        slip += x0.signum() * if release == "pulled" { -alpha } else { alpha };
    }
    let (mut x, mut v, mut out) = (x0, 0.0, vec![x0]);
    for step in 1..=160 * 2000 {
        let rate = |x: f64, v: f64| (v, -x - force(x, v, slip));
        let (x1, v1) = rate(x, v);
        let (x2, v2) = rate(x + 0.5 * h * x1, v + 0.5 * h * v1);
        let (x3, v3) = rate(x + 0.5 * h * x2, v + 0.5 * h * v2);
        let (x4, v4) = rate(x + h * x3, v + h * v3);
        x += h / 6.0 * (x1 + 2.0 * x2 + 2.0 * x3 + x4);
        v += h / 6.0 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
        if let Some(alpha) = alpha {
            // In sliding the slip follows at the distance alpha.
            slip = x - alpha * elastic(x, slip, alpha);
        }
        if step % 2000 == 0 {
            out.push(x);
        }
    }
    out
}

#[test]
fn converges_with_second_order() {
    // The method is of second order. Both laws are continuous, so S only kinks where a branch changes: the trapezoid
    // over the step that holds a kink is off by its jump of slope times at most dT^2/8, once for each of the few kinks,
    // which leaves the order 2 but makes the factor depend on where in its step each kink falls. Hence a slope over the
    // ladder pi/40 .. pi/2560 instead of ratios of neighbours; measured 1.96 to 2.01. The coarsest step must see a swing
    // of S (laws narrower than 0.3 fall out of the ladder). The reference itself is off by its own kinks, some 1e-8.
    for given in [
        json!({"law": "displacement-control", "alpha": 1.0, "x0": 12.0}),
        json!({"law": "displacement-control", "alpha": 5.0, "x0": -12.5}),
        json!({"law": "displacement-control", "alpha": 0.3, "x0": 11.2, "initial_slip": "pulled"}),
        json!({"law": "displacement-control", "alpha": 1.0, "x0": 7.7, "initial_slip": "sliding"}),
        json!({"law": "velocity-control", "beta": 1.0, "x0": 12.0}),
        json!({"law": "velocity-control", "beta": 5.0, "x0": -12.5}),
        json!({"law": "velocity-control", "beta": 0.3, "x0": 11.2}),
    ] {
        let reference = fine(&given);
        let (mut points, mut errors) = (Vec::new(), Vec::new());
        for halvings in 1..=7 {
            let per: i32 = 1 << halvings;
            let mut coarse = given.clone();
            coarse["dT"] = json!(PI / f64::from(20 * per));
            coarse["duration"] = json!(8.0 * PI);
            let history = computed(&coarse);
            let error = reference
                .iter()
                .zip(history.displacement().iter().step_by(per as usize))
                .map(|(a, b)| (a - b).abs())
                .fold(0.0, f64::max);
            points.push((f64::from(-halvings), error.log2()));
            errors.push(error);
        }
        let slope = slope(&points);
        assert!((slope - 2.0).abs() < 0.08, "{given}: order {slope}");
        // With another limit the errors would converge to the difference; the last ones are 4e-6 to 2.3e-5.
        assert!(errors[6] < 5e-5, "{given}: {errors:?}");
    }
}

/// Slope of the straight line through `points` by least squares.
fn slope(points: &[(f64, f64)]) -> f64 {
    let mean =
        |f: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / points.len() as f64;
    let (x, y) = (mean(&|p| p.0), mean(&|p| p.1));
    mean(&|p| (p.0 - x) * (p.1 - y)) / mean(&|p| (p.0 - x) * (p.0 - x))
}

/// Any case of both laws: width and x0 over decades, steps up to a third of a period, every release.
fn any_case() -> impl Strategy<Value = Json> {
    let release = prop::sample::select(vec!["unloaded", "pulled", "sliding"]);
    let parts = (
        any::<bool>(),
        -3.0..1.0_f64,
        -2.0..0.3_f64,
        -1.0..2.0_f64,
        any::<bool>(),
        release,
    );
    parts.prop_map(|(displacement, width, step, x0, left, release)| {
        let power = |x: f64| libm::pow(10.0, x);
        let step = power(step);
        let x0 = if left { -power(x0) } else { power(x0) };
        let mut given = json!({"dT": step, "duration": 300.0 * step, "x0": x0});
        if displacement {
            given["law"] = json!("displacement-control");
            given["alpha"] = json!(power(width));
            given["initial_slip"] = json!(release);
        } else {
            given["law"] = json!("velocity-control");
            given["beta"] = json!(power(width));
        }
        given
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn mirrored_release_gives_the_mirrored_motion(given in any_case()) {
        let mut mirrored = given.clone();
        mirrored["x0"] = json!(-given["x0"].as_f64().unwrap());
        let (a, b) = (computed(&given), computed(&mirrored));
        // Exactly, because rounding is symmetric about zero. 0 and -0 are the same number.
        for (x, y) in [
            (a.displacement(), b.displacement()),
            (a.velocity(), b.velocity()),
            (a.force(), b.force()),
        ] {
            prop_assert!(x.iter().zip(y).all(|(x, y)| *x == -y));
        }
    }

    #[test]
    fn every_step_keeps_the_books(given in any_case()) {
        let history = computed(&given);
        let (x, v, s) = (&history.displacement(), &history.velocity(), &history.force());
        let alpha = given["alpha"].as_f64();
        let x0 = given["x0"].as_f64().unwrap().abs();
        // X is rounded to eps x0 (and to eps alpha where alpha S is taken off it). It is a sum of increments, so beside the
        // mode it walks by up to eps x0/2 a step: some sqrt(i)/2 of them after i steps.
        let length = |i: usize| {
            (4.0 + (i as f64).sqrt()) * f64::EPSILON * (x0 + alpha.unwrap_or(0.0) + 1.0)
        };
        prop_assert!(s.iter().all(|s| s.abs() <= 1.0));
        for i in 0..x.len() - 1 {
            let force = 0.5 * (s[i] + s[i + 1]);
            let work = force * (x[i + 1] - x[i]);
            // r = r^S + alpha S, stuck or sliding: the slip from the history alone.
            let dissipated = match alpha {
                Some(alpha) => force * ((x[i + 1] - alpha * s[i + 1]) - (x[i] - alpha * s[i])),
                None => work,
            };
            prop_assert!(dissipated >= -length(i + 1), "step {}: {:e}", i + 1, dissipated);
            let energy = |i: usize| 0.5 * (x[i] * x[i] + v[i] * v[i]);
            let balance = energy(i + 1) - energy(i) + work;
            // X and V have errors of a few eps x0, and are squared.
            let tolerance = length(i + 1) * (x0 + 1.0);
            prop_assert!(balance.abs() <= tolerance, "step {}: {:e} of {:e}", i + 1, balance, tolerance);
        }
    }
}

#[test]
fn steps_solved_once_start_from_the_given_slip() {
    // The first step by hand: at rest, A0 = -X0 - S0, and within the zone S1 = S0 + u/alpha, u = X1 - X0 = dT^2/4 (A0 + A1),
    // A1 = -X1 - S1. So u (1 + dT^2/4 (1 + 1/alpha)) = dT^2/2 A0. It sticks: |u| < alpha.
    let problem = find("friction-oscillator").unwrap();
    let (alpha, step, x0) = (5.0, 0.1, -12.0);
    for (slip, s0) in [("unloaded", 0.0), ("pulled", -1.0), ("sliding", 1.0)] {
        let given = json!({"law": "displacement-control", "alpha": alpha, "dT": step, "duration": 0.2, "x0": x0,
                           "initial_slip": slip});
        let solution = problem
            .as_textbook()
            .unwrap()
            .solve_once(&case(&*problem, &given), &[])
            .unwrap();
        let quarter = 0.25 * step * step;
        let u = 2.0 * quarter * (-x0 - s0) / (1.0 + quarter * (1.0 + 1.0 / alpha));
        let c = &solution.computed;
        // In the direction of motion the force remains at its limit if it started there.
        let s1 = f64::clamp(s0 + u / alpha, -1.0, 1.0);
        assert_eq!((c.displacement()[0], c.force()[0]), (x0, s0), "{slip}");
        assert!(
            (c.displacement()[1] - (x0 + u)).abs() < 1e-14,
            "{slip}: {:?}",
            c.displacement()
        );
        assert!((c.force()[1] - s1).abs() < 1e-14, "{slip}: {:?}", c.force());
    }
}
