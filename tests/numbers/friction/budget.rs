//! The parts of the error of the friction oscillator: their sum, their signs, and the order of the step error.

use slipgap::exact::regularised::Regularised;
use slipgap::metrics::budget::{Norm, parts};
use slipgap::problem::numbers::parameter::Value;
use slipgap::problem::{Case, Jumps, Solution, find};
use std::f64::consts::PI;

const BUDGET: [usize; 4] = [9, 10, 11, 12];

fn solve(law: &'static str, width: f64, x0: f64, step: f64, duration: f64) -> Solution {
    let problem = find("friction-oscillator").unwrap();
    let width = match law {
        "velocity-control" => ("beta", Value::Number(width)),
        _ => ("alpha", Value::Number(width)),
    };
    let (case, broken) = Case::given(
        &*problem,
        &[
            ("law", Value::Name(law)),
            width,
            ("x0", Value::Number(x0)),
            ("dT", Value::Number(step)),
            ("duration", Value::Number(duration)),
        ],
    );
    assert_eq!(broken, []);
    problem.solve(&case, &BUDGET).unwrap()
}

#[test]
fn the_rows_are_the_budget() {
    let problem = find("friction-oscillator").unwrap();
    let metrics = problem.metrics();
    let names = [
        "regularisation_error",
        "step_error",
        "regularisation_share",
        "step_share",
    ];
    for (row, name) in BUDGET.into_iter().zip(names) {
        assert_eq!((&*metrics[row].name, metrics[row].default), (name, false));
    }
    let (case, _) = Case::given(
        &*problem,
        &[
            ("law", Value::Name("velocity-control")),
            ("beta", Value::Number(0.1)),
            ("dT", Value::Number(0.1)),
            ("duration", Value::Number(20.0)),
        ],
    );
    let unasked = problem.solve(&case, &[0, 8]).unwrap().metrics;
    assert_eq!(unasked[9..13], [None; 4]);
    assert!(
        problem.solve(&case, &[11]).unwrap().metrics[9..13]
            .iter()
            .all(Option::is_some)
    );
    // A run without error has norms of zero, and its shares are undefined.
    let exact = problem
        .exact(&case, &[0.0, 1.0, 2.0], Jumps::RightLimit)
        .unwrap();
    let steps = exact.displacement().iter().enumerate();
    let norm = Norm {
        channels: 1,
        size: 12.0,
        sum: &|_, value| steps.clone().map(|(i, e)| value(i, *e)).sum(),
        count: 3.0,
    };
    assert_eq!(
        parts(std::slice::from_ref(&exact), &exact, &norm),
        [Some(0.0), Some(0.0), None, None]
    );
}

#[test]
fn parts_add_up_to_the_error() {
    for law in ["displacement-control", "velocity-control"] {
        for (width, x0, step) in [
            (0.1, 12.0, PI / 10.0),
            (1.0, 12.5, PI / 3.0),
            (5.0, -11.2, 0.07),
            (1e-6, 100.0, 0.1),
            (0.3, 1e-200, 0.1),
        ] {
            let solution = solve(law, width, x0, step, 8.0 * PI);
            let m: Vec<f64> = solution
                .metrics
                .iter()
                .map(|m| m.unwrap_or(f64::NAN))
                .collect();
            let (rms, model, step_part) = (m[0], m[9], m[10]);
            let tiny = 1e-11 * (model / rms + step_part / rms).max(1.0);
            assert!(
                (m[11] + m[12] - 1.0).abs() < tiny,
                "{law} {width} {x0}: {m:?}"
            );
            // Shares are projections of the parts on the error: with the norms they give the angle between the parts.
            let both = (rms * rms - model * model - step_part * step_part) / 2.0;
            let from_share = m[11] * rms * rms - model * model;
            assert!(
                (both - from_share).abs() < tiny * rms * rms,
                "{law} {width} {x0}"
            );
        }
    }
}

#[test]
fn model_and_step_cancel_at_the_papers_step() {
    // alpha = 0.1, x0 = 12: the error is smallest near pi/10, and smaller than the error of the law alone.
    let row = |n: f64| {
        let m = solve("displacement-control", 0.1, 12.0, PI / n, 8.0 * PI).metrics;
        [0, 9, 10, 11, 12].map(|i| m[i].unwrap())
    };
    let totals = [
        (3.0, 0.1697),
        (5.0, 0.0473),
        (10.0, 0.0245),
        (20.0, 0.0300),
        (40.0, 0.0313),
        (80.0, 0.0315),
    ];
    for (n, total) in totals {
        assert!((row(n)[0] - total).abs() < 5e-5, "pi/{n}");
    }
    let [total, model, step, model_share, step_share] = row(10.0);
    assert!(total < model && model_share > 1.0 && step_share < 0.0);
    let cosine = (total * total - model * model - step * step) / (2.0 * model * step);
    assert!(cosine < -0.6, "{cosine}");
}

/// The largest difference from the motion in continuous time up to `duration`, for steps that are halved.
fn halvings(law: &'static str, width: f64, x0: f64, duration: f64) -> Vec<f64> {
    (6..15)
        .map(|k| {
            let computed = solve(law, width, x0, duration / f64::from(1 << k), duration).computed;
            let mut motion = match law {
                "velocity-control" => Regularised::velocity(x0, width),
                _ => Regularised::displacement(x0, width, 0.0),
            };
            let difference = |(&t, &x): (&f64, &f64)| (x - motion.at(t).displacement).abs();
            computed
                .time
                .iter()
                .zip(computed.displacement())
                .map(difference)
                .fold(0.0, f64::max)
        })
        .collect()
}

/// The ratios of neighbours.
fn ratios(errors: &[f64]) -> Vec<f64> {
    errors.windows(2).map(|pair| pair[0] / pair[1]).collect()
}

#[test]
fn step_error_is_of_second_order_and_kinks_make_it_uneven() {
    for law in ["displacement-control", "velocity-control"] {
        for width in [5.0, 1.0, 0.1] {
            let mut motion = match law {
                "velocity-control" => Regularised::velocity(12.0, width),
                _ => Regularised::displacement(12.0, width, 0.0),
            };
            let first = motion.next_event();
            assert!(motion.at(0.9 * first).force.abs() < 1.0);
            // Before the first kink each halving divides the error by 4, as long as round-off is small: eps times x0 = 12 is less
            // than 1e-4 of the error, and there are few steps.
            let errors = halvings(law, width, 12.0, 0.999 * first);
            let clear = errors
                .iter()
                .filter(|e| **e > 1e4 * 12.0 * f64::EPSILON)
                .count();
            assert!(clear >= 3, "{law} {width}: {errors:?}");
            for ratio in ratios(&errors[..clear.min(5)]) {
                assert!((ratio - 4.0).abs() < 0.002, "{law} {width}: {ratio}");
            }
            // After kinks the ratio depends on their positions within steps; its mean is 4.
            let ratios = ratios(&halvings(law, width, 12.0, 8.0 * PI));
            let average = mean(&ratios);
            assert!((3.2..4.4).contains(&average), "{law} {width}: {average}");
            let furthest = |far: f64, ratio: &f64| far.max((ratio - 4.0).abs());
            let uneven = ratios.iter().fold(0.0, furthest);
            assert!(uneven > 0.02, "{law} {width}: {ratios:?}");
        }
    }
}

/// Geometric mean.
fn mean(ratios: &[f64]) -> f64 {
    ratios
        .iter()
        .product::<f64>()
        .powf(1.0 / ratios.len() as f64)
}

#[test]
fn a_kink_sharper_than_the_step_is_of_first_order() {
    // For the method a width much smaller than the motion in a step is a jump of the force: each halving divides the error by 2.
    for (law, width) in [("displacement-control", 1e-9), ("velocity-control", 1e-6)] {
        let ratios = ratios(&halvings(law, width, 12.0, 8.0 * PI));
        assert!((1.7..2.5).contains(&mean(&ratios)), "{law}: {ratios:?}");
    }
}

#[test]
fn beyond_the_range_of_the_continuous_motion_parts_are_empty() {
    let parts = |law, width, x0, step, duration| {
        let metrics = solve(law, width, x0, step, duration).metrics;
        assert!(metrics[0].is_some());
        let defined = metrics[9..13].iter().filter(|m| m.is_some()).count();
        assert!(defined == 0 || defined == 4, "{metrics:?}");
        (defined == 4).then(|| metrics[9].unwrap())
    };
    // Runs of up to 1e7, for any number of steps.
    assert!(parts("velocity-control", 0.1, 12.0, 1e5, 1e7).is_some());
    assert_eq!(parts("velocity-control", 0.1, 12.0, 1e5, 1.1e7), None);
    assert_eq!(parts("displacement-control", 0.1, 12.0, 1e5, 1.1e7), None);
    // An earlier version had 1.06 instead of 0 at beta = 1e-200.
    for law in ["velocity-control", "displacement-control"] {
        assert_eq!(parts(law, 1e-200, 12.0, 0.1, 25.0), None);
        assert_eq!(parts(law, 1e200, 12.0, 0.1, 25.0), None);
        let least = parts(law, 1e-99, 12.0, 0.1, 25.0).unwrap();
        assert!(least < 1e-15, "{law}: {least:e}");
    }
}
