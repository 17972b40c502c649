//! Whether a figure can have its width and the limits of its axes.

use super::checker::Checker;
use super::extent::POINTS;
use crate::Scale;
use slipgap_problem::problem::numbers::parameter::shortest;

/// Width in mm of a matrix of samples without its columns, and what each column adds.
const MATRIX: [f64; 2] = [36.0, 18.0];

/// The keys of the limits along both axes.
const RANGES: [&str; 2] = ["x_range", "y_range"];

/// Reports limits of axes that the kind of figure cannot have.
pub(super) fn check(checker: &mut Checker) {
    let figure = checker.figure;
    let Some((scales, quantities)) = figure.kind.decoded().limited_axes() else {
        return;
    };
    for ((key, range), scale) in RANGES.into_iter().zip(figure.ranges).zip(scales) {
        suits_scale(checker, key, range, scale);
    }
    if figure.ranges[1].is_some() && quantities > 1 {
        let message = format!("takes one quantity in \"y\", and the figure has {quantities}");
        checker.fault(RANGES[1], message);
    }
}

/// Reports limits without a logarithm on a logarithmic scale.
pub(super) fn suits_scale(checker: &mut Checker, key: &str, range: Option<[f64; 2]>, scale: Scale) {
    if let Some([first, _]) = range
        && scale == Scale::Log
        && first <= 0.0
    {
        let first = shortest(first);
        let message = format!("must be > 0 on a log scale, got {first}");
        checker.fault_of_item(key, 0, message);
    }
}

/// Reports a width that is too small for the columns of a matrix of samples.
pub(super) fn check_matrix(columns: usize, checker: &mut Checker) {
    let least = MATRIX[0] + MATRIX[1] * columns as f64;
    if let Some(width) = checker.figure.width.map(|points| points / POINTS)
        && width < least
    {
        let width = shortest((1e9 * width).round() / 1e9);
        let message =
            format!("must be at least {least} for {columns} sampled parameters, got {width}");
        checker.fault("width", message);
    }
}
