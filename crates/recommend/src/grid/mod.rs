//! The search of grids of laws, methods, widths, meshes and steps: candidates by their costs, with their neighbours and finer steps.

mod answer;
mod level;
mod refine;
mod robustness;
mod search;
mod space;
mod survey;

pub use answer::{Answer, Candidate, Request, Stop, Target};
pub use refine::{
    LEAST_HALVINGS, MOST_HALVINGS, Outcome, Refined, SETTLED, refine, with_finer_step,
};
pub use robustness::{Robustness, robustness};
pub use search::search;
pub use space::{CostLevel, EnergyChange, Further, Grid, Range, SearchSpace, Variants};
pub use survey::{MOST, MOST_OWN_STEP, Recommendation, Survey, Surveyed, recommend};

/// Numbers in equal ratios from `from` to `to`, `count` per decade, rounded to three digits.
pub fn decades(from: f64, to: f64, count: f64) -> Vec<f64> {
    let steps = (libm::log10(to / from) * count).round() as i32;
    let number = |i| from * libm::pow(10.0, f64::from(i) / count);
    let mut all: Vec<f64> = (0..=steps)
        .filter_map(|i| format!("{:.2e}", number(i)).parse().ok())
        .collect();
    all.dedup();
    all
}

/// Integers from `from` to `to`, each at least `ratio` times the one before.
pub fn integers(from: u32, to: u32, ratio: f64) -> Vec<u32> {
    let next = |n: &u32| Some((f64::from(*n) * ratio).ceil().max(f64::from(*n) + 1.0) as u32);
    std::iter::successors(Some(from), next)
        .take_while(|n| *n <= to)
        .collect()
}
