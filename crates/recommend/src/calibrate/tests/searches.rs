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
        "{name}: search {} in {} calls, starts {:?} spent {} misfit {:.3e}; determine {} in {} quadratic {} widened {} moved {:.3e}",
        best.solved,
        calls,
        best.starts,
        best.spent,
        best.misfit,
        d.solved,
        f.calls - calls,
        d.quadratic,
        d.widened,
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

#[test]
fn explore2() {
    let mut total = [0.0; 4];
    for (name, width) in [("freq1-6", 5.0), ("freq1-12", 11.0), ("freq1-30", 29.0)] {
        let (mut ok, mut said, mut n, mut sp) = (0, 0, 0, 0);
        for seed in 1..=20 {
            let r = |x: &[f64]| {
                let mut v = of_ranges(x);
                v[2] = 1.0 + width * x[2];
                v
            };
            let truth = [1.2, 0.2, 3.1, 0.4];
            let measured: Vec<f64> = sine(truth)
                .iter()
                .enumerate()
                .map(|(i, x)| x + 0.01 * noise(seed, i as u64))
                .collect();
            let mut f = function(|x: &[f64]| rms(&sine(r(x)), &measured));
            let b = search(
                4,
                &mut f,
                &Options {
                    seed,
                    cases: 20_000,
                },
            )
            .unwrap();
            let good = b.misfit < 0.012;
            ok += usize::from(good);
            said += usize::from(b.starts[0] >= 3 && !good);
            n += b.solved;
            sp += usize::from(b.spent);
        }
        println!(
            "{name}: {ok} of 20 found, wrongly sure {said}, cases {} spent {sp}",
            n / 20
        );
        total[0] += ok as f64;
    }
    for (name, dims, scale) in [
        ("rastrigin 2x10", 2, 10.0),
        ("rastrigin 4x5", 4, 5.0),
        ("rastrigin 4x10", 4, 10.0),
    ] {
        let (mut ok, mut said, mut n, mut sp) = (0, 0, 0, 0);
        for seed in 1..=20 {
            let mut f = function(|x: &[f64]| {
                x.iter()
                    .map(|a| {
                        let y = scale * (a - 0.43);
                        y * y + 10.0 * (1.0 - libm::cos(6.283185307179586 * y))
                    })
                    .sum::<f64>()
                    .sqrt()
            });
            let b = search(
                dims,
                &mut f,
                &Options {
                    seed,
                    cases: 20_000,
                },
            )
            .unwrap();
            let good = b.misfit < 1e-3;
            ok += usize::from(good);
            said += usize::from(b.starts[0] >= 3 && !good);
            n += b.solved;
            sp += usize::from(b.spent);
        }
        println!(
            "{name}: {ok} of 20 found, wrongly sure {said}, cases {} spent {sp}",
            n / 20
        );
    }
}

fn pounding(x: &[f64], time: f64) -> Vec<f64> {
    let k = 1e3 * libm::pow(1e3, x[0]);
    let e = 0.2 + 0.75 * x[1];
    let gap = 0.05 * x[2];
    let zeta = 0.01 + 0.09 * x[3];
    let l = libm::log(e);
    let c = -2.0 * l * (k * 0.5 / (l * l + 9.8696)).sqrt();
    let (w1, w2) = (6.0, 9.0);
    let (mut u1, mut v1, mut u2, mut v2) = (0.0f64, 0.0f64, 0.0f64, 0.0f64);
    let dt = time / 10000.0;
    let mut out = Vec::new();
    for i in 0..10000 {
        let t = i as f64 * dt;
        let a = 2.0 * libm::sin(5.0 * t);
        let d = u1 - u2 - gap;
        let f = if d > 0.0 {
            (k * d + c * (v1 - v2)).max(0.0)
        } else {
            0.0
        };
        v1 += dt * (-a - w1 * w1 * u1 - 2.0 * zeta * w1 * v1 - f);
        v2 += dt * (-a - w2 * w2 * u2 - 2.0 * zeta * w2 * v2 + f);
        u1 += dt * v1;
        u2 += dt * v2;
        if i % 20 == 19 {
            out.push(u1);
        }
    }
    out
}

#[test]
fn explore3() {
    for (truth, time, level) in [
        ([0.35, 0.6, 0.4, 0.45], 4.0, 0.01),
        ([0.35, 0.6, 0.4, 0.45], 4.0, 0.0),
        ([0.6, 0.6, 0.4, 0.45], 4.0, 0.01),
        ([0.6, 0.5, 0.4, 0.6], 8.0, 0.01),
    ] {
        let exact = pounding(&truth, time);
        let scale = rms(&exact, &vec![0.0; exact.len()]);
        let measured: Vec<f64> = exact
            .iter()
            .enumerate()
            .map(|(i, x)| x + level * scale * noise(1, i as u64))
            .collect();
        println!(
            "scale {scale} truth {truth:?} at {}",
            rms(&exact, &measured)
        );
        report(
            &format!("pounding {time} {level}"),
            4,
            |x| rms(&pounding(x, time), &measured),
            Some(500.0),
        );
    }
}
