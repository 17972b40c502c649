//! Sobol' indices: how much of a metric's variance each parameter of a saltelli design explains.
//!
//! First order after Saltelli et al. (2010), V_i = mean(f_B (f_ABi - f_A)), total after Jansen (1999),
//! V_Ti = mean((f_A - f_ABi)^2)/2, each over the variance of f_A and f_B together, from which the mean is taken first.
//! Intervals are the middle 95 % of bootstrap samples over the base points.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// Bootstrap samples: the ends of a 95 % interval then scatter by a tenth of its width.
const SAMPLES: usize = 1000;

/// An index with its interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Index {
    /// The estimate.
    pub value: f64,
    /// Ends of its 95 % interval.
    pub interval: [f64; 2],
}

/// The indices of one parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Indices {
    /// What the parameter explains by itself.
    pub first: Index,
    /// What it explains by itself and with others.
    pub total: Index,
}

/// The indices of each of `count` parameters from a metric's values in the order of the design, A, AB_1 ... AB_k, B for
/// each base point; `None` where a value is missing or nothing varies.
pub fn indices(values: &[Option<f64>], count: usize, seed: u64) -> Option<Vec<Indices>> {
    let mut values: Vec<f64> = values.iter().copied().collect::<Option<_>>()?;
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    values.iter_mut().for_each(|x| *x -= mean);
    let rows: Vec<&[f64]> = values.chunks_exact(count + 2).collect();
    let all: Vec<usize> = (0..rows.len()).collect();
    let whole = estimate(&rows, &all, count);
    if !whole.iter().flatten().all(|x| x.is_finite()) {
        return None;
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
            value: whole[parameter][which],
            interval: [end(0.025), end(0.975)],
        }
    };
    let both = |parameter| Indices {
        first: index(parameter, 0),
        total: index(parameter, 1),
    };
    Some((0..count).map(both).collect())
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
        };
        let x: Vec<Vec<f64>> = (0..3).map(|i| design.coordinates(i)).collect();
        let values: Vec<Option<f64>> = (0..x[0].len())
            .map(|row| {
                let [a, b, c] = [0, 1, 2].map(|i: usize| PI * (2.0 * x[i][row] - 1.0));
                Some(a.sin() + 7.0 * b.sin().powi(2) + 0.1 * c.powi(4) * a.sin())
            })
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
    fn intervals_hold_the_value_and_narrow_with_the_root_of_n() {
        let widths = [256, 4096].map(|n| {
            let found = ishigami(1, n);
            for (index, exact) in found.iter().zip(exact()) {
                for (index, exact) in [(index.first, exact[0]), (index.total, exact[1])] {
                    let [low, high] = index.interval;
                    // Bootstrap takes the points for random ones, which scatter more.
                    assert!(low <= exact && exact <= high, "{index:?} {exact}");
                }
            }
            found[0].total.interval[1] - found[0].total.interval[0]
        });
        let ratio = widths[0] / widths[1];
        assert!((3.0..5.5).contains(&ratio), "{ratio}");
    }

    #[test]
    fn what_is_missing_or_constant_has_no_indices() {
        assert_eq!(indices(&[Some(1.0); 12], 2, 0), None);
        assert_eq!(
            indices(&[Some(1.0), None, Some(2.0), Some(3.0)], 2, 0),
            None
        );
    }
}
