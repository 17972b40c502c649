//! The errors of a case: its metrics compared with those of a reference.

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

/// Where the value comes from that a metric is compared with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum From {
    /// The metric is an error: 0.
    Zero,
    /// The exact motion of the finest candidate.
    Exact,
    /// The motion of the finest candidate with half its step.
    Finest,
}

/// The error of each metric of a case: itself, or its relative difference from the reference.
pub(super) fn errors(
    from: &[From],
    values: &[Option<f64>],
    references: &[Option<f64>],
) -> Vec<f64> {
    let pairs = from.iter().zip(values).zip(references);
    let error = |((from, value), reference): ((&From, &Option<f64>), &Option<f64>)| match from {
        From::Zero => value.map_or(f64::INFINITY, f64::abs),
        From::Exact | From::Finest => difference(*value, *reference),
    };
    pairs.map(error).collect()
}

/// The relative difference of a value from its reference; 0 if both are undefined.
pub(super) fn difference(value: Option<f64>, reference: Option<f64>) -> f64 {
    match (value, reference) {
        (None, None) => 0.0,
        (Some(value), Some(reference)) if value == reference => 0.0,
        (Some(value), Some(reference)) => ((value - reference) / reference).abs(),
        _ => f64::INFINITY,
    }
}
