//! Sobol' indices of a function with known ones, over the points of a design.

use crate::{Design, Sampling};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use slipgap_statistics::sobol::{Index, Indices, Lack, indices};
use std::f64::consts::PI;

/// Ishigami and Homma's function with a = 7, b = 0.1 over (-pi, pi)^3, and its indices from the integrals
/// (Saltelli et al., Sensitivity Analysis in Practice, 2004): V = a^2/8 + b pi^4/5 + b^2 pi^8/18 + 1/2,
/// V_1 = (1 + b pi^4/5)^2/2, V_2 = a^2/8, V_13 = 8 b^2 pi^8/225.
fn ishigami(seed: u64, n: u64) -> Vec<Indices> {
    let design = Design {
        sampling: Sampling::Saltelli,
        n,
        seed,
        parameters: vec![0, 1, 2],
        scales: Vec::new(),
    };
    let x: Vec<Vec<f64>> = (0..3).map(|i| design.coordinates(i)).collect();
    let values: Vec<Option<f64>> = (0..x[0].len())
        .map(|row| Some(value([0, 1, 2].map(|i: usize| x[i][row]))))
        .collect();
    indices(&values, 3, seed).unwrap()
}

fn exact() -> [[f64; 2]; 3] {
    let (a, b) = (7.0_f64, 0.1);
    let v1 = 0.5 * (1.0 + b * PI.powi(4) / 5.0).powi(2);
    let v2 = a * a / 8.0;
    let v13 = 8.0 * b * b * PI.powi(8) / 225.0;
    let v = a * a / 8.0 + b * PI.powi(4) / 5.0 + b * b * PI.powi(8) / 18.0 + 0.5;
    [[v1, v1 + v13], [v2, v2], [0.0, v13]].map(|pair| pair.map(|part| part / v))
}

#[test]
fn the_ishigami_function_has_its_published_indices() {
    // As published to four digits.
    let printed = [[0.3139, 0.5576], [0.4424, 0.4424], [0.0, 0.2437]];
    for (exact, printed) in exact().iter().flatten().zip(printed.iter().flatten()) {
        assert!((exact - printed).abs() < 5e-5, "{exact} {printed}");
    }
    // 4096 points of a Sobol' sequence leave up to 0.0024 over ten seeds.
    for seed in 0..10 {
        for (found, exact) in ishigami(seed, 4096).iter().zip(exact()) {
            assert!(
                (found.first.value - exact[0]).abs() < 0.004,
                "{found:?} {exact:?}"
            );
            assert!(
                (found.total.value - exact[1]).abs() < 0.004,
                "{found:?} {exact:?}"
            );
        }
    }
}

#[test]
fn intervals_contain_the_index_and_narrow_with_the_root_of_n() {
    let widths = [256, 4096].map(|n| {
        let found = ishigami(1, n);
        for (index, exact) in found.iter().zip(exact()) {
            for (index, exact) in [(index.first, exact[0]), (index.total, exact[1])] {
                let [low, high] = index.interval;
                // Bootstrap treats the points as random ones, which scatter more.
                assert!(low <= exact && exact <= high, "{index:?} {exact}");
            }
        }
        found[0].total.interval[1] - found[0].total.interval[0]
    });
    let ratio = widths[0] / widths[1];
    assert!((3.0..5.5).contains(&ratio), "{ratio}");
}

#[test]
fn missing_or_constant_metrics_have_no_indices() {
    assert_eq!(indices(&[Some(1.0); 12], 2, 0), Err(Lack::Constant));
    // The mean differs from the value by round-off, which has a variance.
    assert_eq!(indices(&[Some(0.1); 12], 2, 0), Err(Lack::Constant));
    let gap = [Some(1.0), None, Some(2.0), None, Some(2.0), Some(3.0)];
    let lack = indices(&gap, 1, 0).unwrap_err();
    assert_eq!((lack, lack.empty_cases()), (Lack::Empty(2, 6), 2));
    assert_eq!(lack.to_string(), "empty in 2 of 6 cases");
    let huge = [Some(1e200), Some(-1e200), Some(1e200)];
    assert_eq!(indices(&huge, 1, 0), Err(Lack::Unbounded));
}

#[test]
fn intervals_have_the_width_of_the_influence_functions() {
    // S = P/(Q - M^2) of means over the rows: each row's influence on S, their scatter over the root of n as the
    // standard error, and 1.96 of these to either side for 95 %.
    let (n, k) = (1024, 3);
    let (mut ratios, seeds) = (Vec::new(), 4);
    for seed in 0..seeds {
        let values = rows_by_chance(seed, n);
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let rows: Vec<Vec<f64>> = values
            .chunks(k + 2)
            .map(|row| row.iter().map(|x| x - mean).collect())
            .collect();
        let average =
            |of: &dyn Fn(&[f64]) -> f64| rows.iter().map(|row| of(row)).sum::<f64>() / n as f64;
        let (m, q) = (
            |row: &[f64]| (row[0] + row[k + 1]) / 2.0,
            |row: &[f64]| (row[0] * row[0] + row[k + 1] * row[k + 1]) / 2.0,
        );
        let (mean_m, mean_q) = (average(&m), average(&q));
        let variance = mean_q - mean_m * mean_m;
        let some: Vec<Option<f64>> = values.iter().copied().map(Some).collect();
        let found = indices(&some, k, seed).unwrap();
        for (i, found) in found.iter().enumerate() {
            let first = |row: &[f64]| row[k + 1] * (row[1 + i] - row[0]);
            let total = |row: &[f64]| (row[0] - row[1 + i]).powi(2) / 2.0;
            type Part<'a> = &'a dyn Fn(&[f64]) -> f64;
            let parts: [(Part, Index); 2] = [(&first, found.first), (&total, found.total)];
            for (part, index) in parts {
                let share = average(part) / variance;
                let influence = |row: &[f64]| {
                    let by_variance = q(row) - mean_q - 2.0 * mean_m * (m(row) - mean_m);
                    (part(row) - average(part) - share * by_variance) / variance
                };
                let error = (average(&|row| influence(row).powi(2)) / n as f64).sqrt();
                let [low, high] = index.interval;
                ratios.push((high - low) / (2.0 * 1.959964 * error));
            }
        }
    }
    // Either end of 1000 samples scatters by 0.084 standard errors, so that a width scatters by 3 % and the mean of
    // four seeds by 1.5 %, were the six indices of a seed one. A level of 93 or 97 % has 8 % less or 11 % more.
    let mean = ratios.iter().sum::<f64>() / ratios.len() as f64;
    assert!((mean - 1.0).abs() < 0.045, "{mean} {ratios:?}");
}

#[test]
fn intervals_contain_the_index_for_95_of_100_random_designs_and_more_sobol_designs() {
    let held = |points: &dyn Fn(u64) -> Vec<Indices>| {
        let mut held = [0; 6];
        for seed in 0..100 {
            let found = points(seed);
            let both = found
                .iter()
                .zip(exact())
                .flat_map(|(found, exact)| [(found.first, exact[0]), (found.total, exact[1])]);
            for (held, (index, exact)) in held.iter_mut().zip(both) {
                *held += u32::from(index.interval[0] <= exact && exact <= index.interval[1]);
            }
        }
        held
    };
    // Of 100 studies 95 are expected; 4 standard deviations of the binomial distribution are 8.7.
    let random = held(&|seed| by_chance(seed, 128));
    assert!(random.iter().all(|held| *held >= 86), "{random:?}");
    // With half of the error, intervals contain the index up to 3.9 standard errors: 1 of 10^4 is missed. At 64 points 3 of
    // 1200 were missed.
    let sobol = held(&|seed| ishigami(seed, 128));
    assert!(sobol.iter().all(|held| *held >= 98), "{sobol:?}");
    assert!(random.iter().sum::<u32>() < 590, "{random:?}");
}

/// The same with random points.
fn by_chance(seed: u64, n: u64) -> Vec<Indices> {
    let values: Vec<Option<f64>> = rows_by_chance(seed, n).into_iter().map(Some).collect();
    indices(&values, 3, seed).unwrap()
}

/// Its values at random points, in the order of a design.
fn rows_by_chance(seed: u64, n: u64) -> Vec<f64> {
    let mut random = ChaCha8Rng::seed_from_u64(1000 + seed);
    let mut uniform = || (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64;
    let mut values = Vec::new();
    for _ in 0..n {
        let a = [uniform(), uniform(), uniform()];
        let b = [uniform(), uniform(), uniform()];
        values.push(value(a));
        for i in 0..3 {
            let mut mixed = a;
            mixed[i] = b[i];
            values.push(value(mixed));
        }
        values.push(value(b));
    }
    values
}

fn value(u: [f64; 3]) -> f64 {
    let [a, b, c] = u.map(|u| PI * (2.0 * u - 1.0));
    a.sin() + 7.0 * b.sin().powi(2) + 0.1 * c.powi(4) * a.sin()
}
