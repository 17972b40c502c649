//! The errors of a case: its metrics compared with those of a reference.

use slipgap_problem::problem::Case;
use slipgap_study::{Recommend, Study};

/// Metrics that are 0 for the exact motion, besides those with the word error in their names.
const ZERO: [&str; 4] = [
    "numerical_dissipation",
    "max_overlap",
    "residual_motion",
    "rdot_oscillation",
];

/// Whether a metric is an error itself, which is 0 for the exact motion: its tolerance is its largest value.
pub fn is_error(name: &str) -> bool {
    let base = name.split('(').next().unwrap_or_default().trim();
    let starts = ["energy_drift", "sprague_geers"];
    let ends = base.ends_with("_error") || base.contains("_error_");
    ends || ZERO.contains(&base) || starts.iter().any(|start| base.starts_with(start))
}

/// The error of each metric of a case: itself, or its relative difference from the reference.
pub(super) fn errors(
    (study, recommend): (&Study, &Recommend),
    case: &Case,
    metrics: &[Option<f64>],
    references: &[Option<f64>],
) -> Vec<f64> {
    let within = recommend.within.iter().zip(references);
    let error = |((row, _), reference): (&(usize, f64), &Option<f64>)| {
        let own = study.measure_value(*row, case, &|at| metrics[at]);
        match is_error(&study.measures[*row].name) {
            true => own.map_or(f64::INFINITY, f64::abs),
            false => difference(own, *reference),
        }
    };
    within.map(error).collect()
}

/// The relative difference of a value from its reference; 0 if both are undefined.
pub(super) fn difference(own: Option<f64>, reference: Option<f64>) -> f64 {
    match (own, reference) {
        (None, None) => 0.0,
        (Some(own), Some(reference)) if own == reference => 0.0,
        (Some(own), Some(reference)) => ((own - reference) / reference).abs(),
        _ => f64::INFINITY,
    }
}
