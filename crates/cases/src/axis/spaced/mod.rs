//! Numbers that a rule gives between two ends. The ends are the given numbers to the bit; numbers between them that are decimals of at
//! most 15 digits are those decimals.

mod exact;
mod powers;

use exact::{Even, Ratios};
use powers::Powers;
use rayon::prelude::*;
use slipgap_problem::metrics::SLACK;

/// A rule of three numbers a, b, c.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rule {
    /// c numbers from a to b, evenly spaced.
    Linspace,
    /// c numbers from a to b, with the same ratio between neighbours; a and b have the same sign.
    Geomspace,
    /// a, a + c, ... up to b.
    Range,
}

/// Fewest numbers that are worth several threads.
const FEW: usize = 10_000;

/// The first `count` >= 2 numbers of a rule.
pub fn numbers(rule: Rule, [a, b, c]: [f64; 3], count: usize) -> Vec<f64> {
    let (steps, powers) = ((count - 1) as f64, Powers::of(b / a));
    let near = |i: f64| match rule {
        Rule::Linspace if i == steps => b,
        Rule::Linspace => a + (b - a) * (i / steps),
        Rule::Geomspace if i == steps => b,
        Rule::Geomspace if i == 0.0 => a,
        Rule::Geomspace => a * powers.at(i / steps),
        Rule::Range if (a + i * c - b).abs() <= SLACK * (b - a).abs() => b,
        Rule::Range => a + i * c,
    };
    let even = match rule {
        Rule::Linspace => Even::to(a, b, steps as u64),
        Rule::Range => Even::by(a, c),
        Rule::Geomspace => None,
    };
    let ratios = Ratios::new(a, b, steps as u64).filter(|_| rule == Rule::Geomspace);
    let number = |i: usize| {
        let x = near(i as f64);
        // The ends are given.
        let inside = i > 0 && x != b && x.is_finite();
        let even = even.and_then(|even| even.at(i as u64));
        let exact = even.or_else(|| ratios?.at(i as u64, x));
        exact.filter(|_| inside).unwrap_or(x)
    };
    // Powers of a million numbers are a noticeable part of a run.
    match count {
        FEW.. => (0..count).into_par_iter().map(number).collect(),
        _ => (0..count).map(number).collect(),
    }
}
