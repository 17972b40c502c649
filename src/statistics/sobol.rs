//! Sobol' indices: how much of a metric's variance each parameter of a saltelli design explains.
//!
//! First order after Saltelli et al. (2010), V_i = mean(f_B (f_ABi - f_A)), total after Jansen (1999),
//! V_Ti = mean((f_A - f_ABi)^2)/2, each over the variance of f_A and f_B together, from which the mean is taken first.
//! Intervals are the middle 95 % of bootstrap samples over the base points, which are treated as random points.

use std::fmt;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// Bootstrap samples: the ends of an interval then scatter by a fiftieth of its width.
const SAMPLES: usize = 1000;

/// Part of the samples below an interval, and above it.
const TAIL: f64 = 0.025;

/// An index with its interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Index {
    /// The estimate.
    pub value: f64,
    /// Ends of its bootstrap interval. For random points it contains the true index 95 times in 100; the points of a Sobol'
    /// sequence have smaller errors, so that it contains the index more often.
    pub interval: [f64; 2],
}

/// The indices of one parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Indices {
    /// The share of the parameter alone.
    pub first: Index,
    /// The share of the parameter alone and together with others.
    pub total: Index,
}

/// Why a metric has no indices.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Lack {
    /// It is empty in some cases: that many of all.
    Empty(usize, usize),
    /// It has the same value in all cases.
    Constant,
    /// Its variance is beyond the largest number.
    Unbounded,
}

impl Lack {
    /// Number of cases without a value.
    pub fn empty_cases(self) -> usize {
        match self {
            Lack::Empty(count, _) => count,
            Lack::Constant | Lack::Unbounded => 0,
        }
    }
}

impl fmt::Display for Lack {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Lack::Empty(count, all) => write!(f, "empty in {count} of {all} cases"),
            Lack::Constant => write!(f, "the same in all cases"),
            Lack::Unbounded => write!(f, "too large for a variance"),
        }
    }
}

/// The indices of each of `count` parameters from a metric's values in the order of the design, A, AB_1 ... AB_k, B for
/// each base point.
///
/// # Errors
/// Why the metric has no indices.
pub fn indices(values: &[Option<f64>], count: usize, seed: u64) -> Result<Vec<Indices>, Lack> {
    let empty = values.iter().filter(|value| value.is_none()).count();
    if empty > 0 {
        return Err(Lack::Empty(empty, values.len()));
    }
    let mut values: Vec<f64> = values.iter().copied().flatten().collect();
    if values.windows(2).all(|pair| pair[0] == pair[1]) {
        return Err(Lack::Constant);
    }
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    values.iter_mut().for_each(|x| *x -= mean);
    let rows: Vec<&[f64]> = values.chunks_exact(count + 2).collect();
    let all: Vec<usize> = (0..rows.len()).collect();
    let estimates = estimate(&rows, &all, count);
    if !estimates.iter().flatten().all(|x| x.is_finite()) {
        return Err(Lack::Unbounded);
    }
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut samples: Vec<Vec<[f64; 2]>> = Vec::with_capacity(SAMPLES);
    for _ in 0..SAMPLES {
        let pick = |_| ((u128::from(random.next_u64()) * rows.len() as u128) >> 64) as usize;
        let picked: Vec<usize> = (0..rows.len()).map(pick).collect();
        samples.push(estimate(&rows, &picked, count));
    }
    let index = |parameter: usize, which: usize| {
        let mut sampled: Vec<f64> = samples.iter().map(|s| s[parameter][which]).collect();
        sampled.sort_by(f64::total_cmp);
        let end = |part: f64| sampled[(part * (SAMPLES - 1) as f64).round() as usize];
        Index {
            value: estimates[parameter][which],
            interval: [end(TAIL), end(1.0 - TAIL)],
        }
    };
    let both = |parameter| Indices {
        first: index(parameter, 0),
        total: index(parameter, 1),
    };
    Ok((0..count).map(both).collect())
}

/// First-order and total index of each parameter over some of the rows.
fn estimate(rows: &[&[f64]], picked: &[usize], count: usize) -> Vec<[f64; 2]> {
    let n = picked.len() as f64;
    let (mut sum, mut squares) = (0.0, 0.0);
    let mut parts = vec![[0.0, 0.0]; count];
    for row in picked.iter().map(|i| rows[*i]) {
        let (a, b) = (row[0], row[count + 1]);
        sum += a + b;
        squares += a * a + b * b;
        for (part, mixed) in parts.iter_mut().zip(&row[1..]) {
            part[0] += b * (mixed - a);
            part[1] += (a - mixed) * (a - mixed);
        }
    }
    let mean = sum / (2.0 * n);
    let variance = squares / (2.0 * n) - mean * mean;
    let over = |[first, total]: [f64; 2]| [first / n / variance, total / (2.0 * n) / variance];
    parts.into_iter().map(over).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::{Design, Sampling};
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
}
