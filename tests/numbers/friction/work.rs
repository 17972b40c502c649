//! The work of friction: 72 nu N Delta for the paper's release, with Coulomb's law and with the models that converge to it
//! [F section 4].

use slipgap::exact::coulomb::Coulomb;
use slipgap::exact::regularised::Regularised;
use slipgap::metrics::steps;
use slipgap::problem::numbers::parameter::Value;
use slipgap::problem::{Case, Problem, friction::FrictionOscillator};
use std::f64::consts::PI;

const X0: f64 = 12.0;
const END: f64 = 8.0 * PI;

/// The loss of energy from release at rest until `time`: (x0^2 - X^2 - V^2)/2.
fn lost(mut motion: Regularised, time: f64) -> f64 {
    let state = motion.at(time);
    0.5 * (X0 * X0 - state.displacement.powi(2) - state.velocity.powi(2))
}

/// The work of the computed motion by trapezoids, which is the loss of energy in the method.
fn worked(law: &'static str, width: f64, step: f64) -> f64 {
    let width_name = match law {
        "displacement-control" => "alpha",
        _ => "beta",
    };
    let (case, broken) = Case::given(
        &FrictionOscillator,
        &[
            ("law", Value::Name(law)),
            (width_name, Value::Number(width)),
            ("dT", Value::Number(step)),
            ("duration", Value::Number(END)),
            ("x0", Value::Number(X0)),
        ],
    );
    assert_eq!(broken, []);
    let c = FrictionOscillator.solve(&case, &[]).unwrap().computed;
    assert_eq!(c.len() as u64, steps(END, step) + 1);
    let pairs = c.force().windows(2).zip(c.displacement().windows(2));
    pairs
        .map(|(s, x)| 0.5 * (s[0] + s[1]) * (x[1] - x[0]))
        .sum()
}

#[test]
fn coulombs_path_is_72_long() {
    // Peaks 12, -10, 8, ... 0: 22 + 18 + 14 + 10 + 6 + 2.
    assert_eq!(Coulomb::new(X0).work(), 72.0);
}

#[test]
fn narrow_models_converge_to_it() {
    // Velocity-control loses the same work until 8 pi within O(beta): a turn changes it by O(beta^2), the final creep from X of
    // order beta by O(beta^2) too.
    for beta in [1e-2, 1e-3, 1e-4] {
        let short = 72.0 - lost(Regularised::velocity(X0, beta), END);
        assert!(short.abs() < beta, "beta = {beta}: {short}");
    }
    // Displacement-control comes to rest on its spring, which stores up to alpha/2.
    for alpha in [1e-2, 1e-3, 1e-4] {
        let short = 72.0 - lost(Regularised::displacement(X0, alpha, 0.0), END);
        assert!(short.abs() < alpha, "alpha = {alpha}: {short}");
    }
}

#[test]
fn wide_models_lose_less() {
    // At the paper's step, computed in tests/reference with 50 digits; in continuous time the values are 71.98, 71.39 and 52.96.
    for (alpha, work) in [(0.1, 71.94), (1.0, 71.49), (5.0, 52.45)] {
        let found = worked("displacement-control", alpha, PI / 10.0);
        assert!((found - work).abs() < 0.005, "alpha = {alpha}: {found}");
    }
}

#[test]
fn the_computed_work_converges_to_that_of_the_models() {
    // The method is of second order; with kinks the difference is at most 72 (pi dT^2/12).
    let step = PI / 320.0;
    for (law, width, model) in [
        (
            "displacement-control",
            0.1,
            Regularised::displacement(X0, 0.1, 0.0),
        ),
        (
            "displacement-control",
            5.0,
            Regularised::displacement(X0, 5.0, 0.0),
        ),
        ("velocity-control", 0.1, Regularised::velocity(X0, 0.1)),
        ("velocity-control", 5.0, Regularised::velocity(X0, 5.0)),
    ] {
        let (computed, exact) = (worked(law, width, step), lost(model, END));
        assert!(
            (computed - exact).abs() < 72.0 * PI * step * step / 12.0,
            "{law} {width}: {computed}, not {exact}"
        );
    }
}

#[test]
fn numerical_dissipation_of_moreau_and_jeans_method_is_that_of_its_theta() {
    // The equations of a step, V' - V = -h (X_theta + S') and X' - X = h V_theta, times the mean velocity and the mean
    // displacement: the energy falls by the work h S' (V + V')/2 and by h (theta - 1/2) ((V + V')/2 (X' - X) - (X + X')/2 (V' - V)).
    for (law, theta) in [
        ("velocity-control", 0.5),
        ("velocity-control", 0.7),
        ("coulomb", 1.0),
    ] {
        let step = PI / 20.0;
        let mut given = vec![
            ("law", Value::Name(law)),
            ("dT", Value::Number(step)),
            ("duration", Value::Number(END)),
            ("x0", Value::Number(X0)),
            ("method", Value::Name("moreau-jean")),
            ("theta", Value::Number(theta)),
        ];
        if law == "velocity-control" {
            given.push(("beta", Value::Number(0.1)));
        }
        let (case, broken) = Case::given(&FrictionOscillator, &given);
        assert_eq!(broken, []);
        let metrics = &FrictionOscillator.schema().metrics;
        let row = metrics
            .iter()
            .position(|m| m.name == "numerical_dissipation")
            .unwrap();
        let solution = FrictionOscillator.solve(&case, &[row]).unwrap();
        let c = solution.computed;
        let pairs = c.velocity().windows(2).zip(c.displacement().windows(2));
        let lost: f64 = pairs
            .map(|(v, x)| 0.5 * ((v[0] + v[1]) * (x[1] - x[0]) - (x[0] + x[1]) * (v[1] - v[0])))
            .sum();
        // The metric is over x0^2/2.
        let expected = step * (theta - 0.5) * lost / (0.5 * X0 * X0);
        let found = solution.metrics[row].unwrap();
        assert!(
            (found - expected).abs() < 1e-13,
            "{law} {theta}: {found} {expected}"
        );
        assert_eq!(theta > 0.5, expected > 0.01);
    }
}
