use super::super::{Options, determine, search};
use super::examples::*;

fn report(name: &str, n: usize, f: impl FnMut(&[f64]) -> f64, residuals: Option<f64>) {
    let mut f = function(f);
    let best = search(
        n,
        &mut f,
        &Options {
            seed: 1,
            cases: 20_000,
        },
    )
    .unwrap();
    let calls = f.calls;
    let d = determine(&best, &mut f, residuals).unwrap();
    println!(
        "{name}: search {} in {} calls, starts {:?} spent {} misfit {:.3e}; determine {} in {} quadratic {} moved {:.3e}",
        best.solved,
        calls,
        best.starts,
        best.spent,
        best.misfit,
        d.solved,
        f.calls - calls,
        d.quadratic,
        d.best.misfit
    );
    println!("   at {:.5?}", d.best.at);
    for p in &d.profiles {
        println!(
            "   {:?} {:?} {}",
            p.interval,
            p.within_tenth,
            p.points.len()
        );
    }
    println!("   corr {:.3?} und {:.3?}", d.correlation, d.undetermined);
}

#[test]
fn explore() {
    report(
        "sphere",
        4,
        |x| x.iter().map(|a| (a - 0.4) * (a - 0.4)).sum::<f64>().sqrt(),
        Some(100.0),
    );
    report(
        "ellipsoid 1e6",
        4,
        |x| {
            x.iter()
                .enumerate()
                .map(|(i, a)| libm::pow(1e6, i as f64 / 3.0) * (a - 0.37) * (a - 0.37))
                .sum::<f64>()
                .sqrt()
        },
        Some(100.0),
    );
    report(
        "rosenbrock",
        4,
        |x| {
            let y: Vec<f64> = x.iter().map(|a| 4.0 * a - 2.0).collect();
            y.windows(2)
                .map(|w| 100.0 * (w[1] - w[0] * w[0]).powi(2) + (1.0 - w[0]).powi(2))
                .sum::<f64>()
                .sqrt()
        },
        Some(100.0),
    );
    report(
        "rastrigin",
        4,
        |x| {
            x.iter()
                .map(|a| {
                    let y = 10.0 * (a - 0.43);
                    y * y + 10.0 * (1.0 - libm::cos(6.283185307179586 * y))
                })
                .sum::<f64>()
        },
        None,
    );
    let truth = sine([1.2, 0.3, 3.1, 0.4]);
    let measured: Vec<f64> = truth
        .iter()
        .enumerate()
        .map(|(i, x)| x + 0.01 * noise(3, i as u64))
        .collect();
    report(
        "sine noise",
        4,
        |x| rms(&sine(of_ranges(x)), &measured),
        Some(200.0),
    );
    report(
        "sine perfect",
        4,
        |x| rms(&sine(of_ranges(x)), &truth),
        Some(200.0),
    );
    report(
        "product",
        2,
        |x| {
            let (k, c) = (1e4 * libm::pow(1e3, x[0]), 1e2 * libm::pow(1e3, x[1]));
            let p = libm::log(k * c / 1e9);
            (p * p + 0.01).sqrt()
        },
        Some(200.0),
    );
    report(
        "product linear",
        2,
        |x| {
            let p = (0.1 + x[0]) * (0.1 + x[1]) - 0.3;
            (p * p + 1e-4).sqrt()
        },
        Some(200.0),
    );
    report(
        "flat",
        3,
        |x| ((x[0] - 0.3).powi(2) + (x[1] - 0.8).powi(2) + 1e-4).sqrt(),
        Some(200.0),
    );
    report("constant", 2, |_| 1.0, Some(200.0));
    report("zero", 2, |_| 0.0, Some(200.0));
    report("inf", 2, |_| f64::NAN, Some(200.0));
    report(
        "bound",
        3,
        |x| {
            ((x[0] + 0.3).powi(2) + (x[1] - 0.8).powi(2) + (x[2] - x[0] - 0.5).powi(2) + 1e-4)
                .sqrt()
        },
        Some(200.0),
    );
    report(
        "one",
        1,
        |x| ((x[0] - 0.3).powi(2) + 1e-4).sqrt(),
        Some(200.0),
    );
    report(
        "rough",
        4,
        |x| {
            let s: f64 = x
                .iter()
                .enumerate()
                .map(|(i, a)| (a - 0.4).powi(2) * (1.0 + i as f64))
                .sum();
            let h = x
                .iter()
                .map(|a| (a * 300.0).floor() as u64)
                .fold(7u64, |a, b| a.wrapping_mul(1000003).wrapping_add(b));
            (s + 1e-4).sqrt() * (1.0 + 0.02 * noise(1, h))
        },
        Some(5000.0),
    );
    report(
        "half fails",
        4,
        |x| {
            if x[0] + x[1] < 0.8 {
                f64::INFINITY
            } else {
                (x.iter().map(|a| (a - 0.45).powi(2)).sum::<f64>() + 1e-4).sqrt()
            }
        },
        Some(200.0),
    );
    report(
        "ten",
        10,
        |x| {
            (x.iter()
                .enumerate()
                .map(|(i, a)| libm::pow(10.0, i as f64 / 3.0) * (a - 0.37) * (a - 0.37))
                .sum::<f64>()
                + 1e-3)
                .sqrt()
        },
        Some(500.0),
    );
}
