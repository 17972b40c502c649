//! Sobol' indices: how much of a metric's variance each parameter of a saltelli design explains.
//!
//! First order after Saltelli et al. (2010), V_i = mean(f_B (f_ABi - f_A)), total after Jansen (1999),
//! V_Ti = mean((f_A - f_ABi)^2)/2, each over the variance of f_A and f_B together, from which the mean is taken first.
//! Intervals are the middle 95 % of bootstrap samples over the base points, which are treated as random points.

use super::bootstrap;
use std::fmt;

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
            Lack::Empty(count, cases) => write!(f, "empty in {count} of {cases} cases"),
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
    let every_row: Vec<usize> = (0..rows.len()).collect();
    let estimates = estimate(&rows, &every_row, count);
    if !estimates.iter().flatten().all(|x| x.is_finite()) {
        return Err(Lack::Unbounded);
    }
    let picks = bootstrap::samples(rows.len(), seed);
    let samples: Vec<Vec<[f64; 2]>> = picks
        .map(|picked| estimate(&rows, &picked, count))
        .collect();
    let index = |parameter: usize, which: usize| {
        let sampled = samples.iter().map(|s| s[parameter][which]).collect();
        let value = estimates[parameter][which];
        Index {
            value,
            interval: bootstrap::interval(sampled).unwrap_or([value; 2]),
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
