//! The work of friction: 72 nu N Delta for the paper's release, by Coulomb's law and by what tends to it [F section 4].

use slipgap::exact::coulomb::Coulomb;
use slipgap::exact::regularised::Regularised;
use slipgap::metrics::steps;
use slipgap::problem::parameter::Value;
use slipgap::problem::{Case, Problem, friction::FrictionOscillator};
use std::f64::consts::PI;

const X0: f64 = 12.0;
const END: f64 = 8.0 * PI;

/// What the motion has lost by `time`, by the balance of energy: (x0^2 - X^2 - V^2)/2, from release at rest.
fn lost(mut motion: Regularised, time: f64) -> f64 {
    let state = motion.at(time);
    0.5 * (X0 * X0 - state.displacement.powi(2) - state.velocity.powi(2))
}

/// The work of the computed motion by trapezoids, which is what the method itself takes from the energy.
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
    // 12, 10, ... 2, 0 either side: 22 + 18 + 14 + 10 + 6 + 2.
    assert_eq!(Coulomb::new(X0).work(), 72.0);
}

#[test]
fn the_models_tend_to_it_as_they_narrow() {
    // Velocity-control loses by 8 pi what Coulomb does but for a term of the order beta: a turn costs O(beta^2), the
    // last creep home from X of order beta O(beta^2) more.
    for beta in [1e-2, 1e-3, 1e-4] {
        let short = 72.0 - lost(Regularised::velocity(X0, beta), END);
        assert!(short.abs() < beta, "beta = {beta}: {short}");
    }
    // Displacement-control comes to rest on its spring, which holds back up to alpha/2.
    for alpha in [1e-2, 1e-3, 1e-4] {
        let short = 72.0 - lost(Regularised::displacement(X0, alpha, 0.0), END);
        assert!(short.abs() < alpha, "alpha = {alpha}: {short}");
    }
}

#[test]
fn wide_models_lose_less() {
    // At the paper's step, as tests/reference has it with 50 digits; in continuous time it is
    // 71.98, 71.39 and 52.96.
    for (alpha, work) in [(0.1, 71.94), (1.0, 71.49), (5.0, 52.45)] {
        let found = worked("displacement-control", alpha, PI / 10.0);
        assert!((found - work).abs() < 0.005, "alpha = {alpha}: {found}");
    }
}

#[test]
fn the_computed_work_tends_to_the_models() {
    // The second order of the method, with room for kinks: 72 (pi dT^2/12) at most.
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
