//! The parts of the error with laws that have no closed form: their sum, and the order of the step error.

use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_problem::problem::{Case, find};
use std::f64::consts::PI;

/// The metrics of these names.
fn metrics<const N: usize>(
    problem: &'static str,
    given: &[(&'static str, Value)],
    names: [&str; N],
) -> [Option<f64>; N] {
    let problem = find(problem).unwrap();
    let (case, broken) = Case::given(&*problem, given);
    assert_eq!(broken, []);
    let rows = names.map(|name| {
        let mut metrics = problem.metrics().iter();
        metrics.position(|metric| metric.name == name).unwrap()
    });
    let solution = problem.solve(&case, &rows).unwrap();
    rows.map(|row| solution.metrics[row])
}

fn numbers(of: &[(&'static str, f64)]) -> Vec<(&'static str, Value)> {
    of.iter()
        .map(|(name, x)| (*name, Value::Number(*x)))
        .collect()
}

/// Friction laws without a closed form, with their numbers.
fn friction_laws() -> Vec<(&'static str, Vec<(&'static str, f64)>)> {
    let falling = [("static_ratio", 1.2), ("stribeck_velocity", 1.0)];
    let lugre = [("sigma0", 10.0), ("sigma1", 0.5), ("sigma2", 0.1)];
    let bearing = [("beta", 0.5), ("nu_ratio", 0.5), ("nu_rate", 1.0)];
    vec![
        ("bouc-wen", vec![("alpha", 0.5), ("exponent", 1.0)]),
        ("bouc-wen", vec![("alpha", 0.5), ("exponent", 2.0)]),
        ("bouc-wen", vec![("alpha", 0.5), ("exponent", 3.0)]),
        ("dahl", vec![("alpha", 0.5), ("exponent", 1.0)]),
        ("dahl", vec![("alpha", 0.5), ("exponent", 2.0)]),
        ("lugre", [&lugre[..], &falling].concat()),
        ("tanh", vec![("beta", 0.5)]),
        ("stribeck", [&[("beta", 0.5)][..], &falling].concat()),
        ("velocity-control", bearing.to_vec()),
    ]
}

#[test]
fn parts_of_every_friction_law_add_up_and_the_step_error_has_order_two() {
    const NAMES: [&str; 6] = [
        "rms_error",
        "regularisation_error",
        "step_error",
        "regularisation_share",
        "step_share",
        "reference_error",
    ];
    for (law, pairs) in friction_laws() {
        let rows = [40.0, 80.0, 160.0, 320.0, 640.0].map(|n| {
            let mut given = numbers(&pairs);
            given.push(("law", Value::Name(law)));
            given.extend(numbers(&[("dT", PI / n), ("duration", 8.0 * PI)]));
            let values = metrics("friction-oscillator", &given, NAMES);
            let [rms, of_law, of_step, a, b, error] = values.map(Option::unwrap);
            // Round-off of shares that are much larger than 1.
            let tiny = 1e-11 * (of_law / rms + of_step / rms).max(1.0);
            assert!((a + b - 1.0).abs() < tiny, "{law} {pairs:?}: {values:?}");
            // Steps of the coarser integration err by 1e-10 of the largest value, or less; there are some hundred.
            assert!(error < 1e-8, "{law} {pairs:?}: {error}");
            [of_law, of_step]
        });
        // The part of the law depends on the step only by where its mean is taken.
        let [first, last] = [rows[1][0], rows[4][0]];
        assert!(
            (first / last - 1.0).abs() < 0.02,
            "{law} {pairs:?}: {first} {last}"
        );
        // Corners fall at other places in other steps, which makes single ratios uneven.
        let slope = (rows[0][1] / rows[4][1]).log2() / 4.0;
        assert!(
            (slope - 2.0).abs() < 0.25,
            "{law} {pairs:?}: {slope} {rows:?}"
        );
    }
}

/// Impact laws without a closed form, with their numbers.
fn impact_laws() -> Vec<(&'static str, Vec<(&'static str, f64)>)> {
    let damped = |law| (law, vec![("restitution", 0.5)]);
    vec![
        ("hertz", vec![]),
        damped("kelvin-voigt"),
        damped("hertz-damp"),
        damped("hunt-crossley"),
        damped("ye"),
        damped("jankowski"),
    ]
}

#[test]
fn parts_of_every_impact_law_add_up_and_the_step_error_falls() {
    const NAMES: [&str; 8] = [
        "regularisation_error_r",
        "mesh_error_r",
        "step_error_r",
        "regularisation_share_r",
        "mesh_share_r",
        "step_share_r",
        "reference_error_r",
        "step_error_rdot",
    ];
    for (law, pairs) in impact_laws() {
        let rows = [0.02, 0.01, 0.005, 0.0025].map(|dt| {
            let mut given = numbers(&pairs);
            given.push(("law", Value::Name(law)));
            given.extend(numbers(&[
                ("gamma", 0.5),
                ("n", 10.0),
                ("dt", dt),
                ("duration", 2.0),
            ]));
            let values = metrics("bar-impact", &given, NAMES);
            let [of_law, of_mesh, of_step, a, b, c, error, rate] = values.map(Option::unwrap);
            assert!((a + b + c - 1.0).abs() < 1e-9, "{law}: {values:?}");
            assert!(error < 1e-8, "{law}: {error}");
            [of_law, of_mesh, of_step, rate]
        });
        let slope = (rows[0][2] / rows[3][2]).log2() / 3.0;
        // The force of kelvin-voigt jumps at the first touch, that of jankowski rises there like the fourth root of the overlap.
        let order = match law {
            "kelvin-voigt" => 1.0,
            "jankowski" => 1.25,
            _ => 2.0,
        };
        assert!((slope - order).abs() < 0.4, "{law}: {slope} {rows:?}");
    }
}

#[test]
fn the_mesh_tends_to_the_continuous_bars() {
    // With gamma n kept, the law is the same. Its front is as wide as an element at least.
    let error = |(law, pairs): &(&'static str, Vec<(&'static str, f64)>), n: f64| {
        let mut given = numbers(&[
            ("gamma", 4.0 / n),
            ("n", n),
            ("dt", 0.02),
            ("duration", 1.8),
        ]);
        given.push(("law", Value::Name(law)));
        given.extend(numbers(pairs));
        let [error] = metrics("bar-impact", &given, ["mesh_error_r"]);
        error.unwrap()
    };
    for law in &impact_laws()[..3] {
        let [coarse, fine] = [10.0, 40.0].map(|n| error(law, n));
        assert!(fine < 0.5 * coarse, "{law:?} {coarse} {fine}");
    }
}
