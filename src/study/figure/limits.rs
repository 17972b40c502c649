//! The width of a figure and the limits of its axes: how they are written, and whether the figure can have them.

use super::checker::Checker;
use crate::problem::parameter::{Range, shortest};
use crate::study::Scale;
use crate::study::report::Faults;
use crate::study::tree::{Node, Tree};
use crate::study::value::number;

/// Widths of a figure in mm, from less than a narrow column to more than a page across.
pub(in crate::study) const WIDTHS: [f64; 2] = [70.0, 400.0];

/// Points in a mm.
const POINTS: f64 = 72.0 / 25.4;

/// Width in mm of a matrix of samples without its columns, and what each column adds.
const MATRIX: [f64; 2] = [36.0, 18.0];

/// The keys of the limits along both axes.
const RANGES: [&str; 2] = ["x_range", "y_range"];

/// A width in mm, as points.
pub(super) fn width(node: &Node, path: &str, faults: &mut Faults) -> Option<f64> {
    let width = number(node, path, Range::Positive, faults)?;
    let [least, most] = WIDTHS;
    if (least..=most).contains(&width) {
        return Some(width * POINTS);
    }
    let what = format!("a width in mm from {least} to {most}");
    faults.must_be(node, path, &what);
    None
}

/// The first and last value of an axis.
pub(super) fn range(node: &Node, path: &str, faults: &mut Faults) -> Option<[f64; 2]> {
    let items = match &node.tree {
        Tree::List(items) => items.as_slice(),
        _ => &[],
    };
    let [first, last] = items else {
        faults.must_be(
            node,
            path,
            "a list of two numbers, the first and last value of the axis",
        );
        return None;
    };
    let mut one = |node, i| number(node, &format!("{path}[{i}]"), Range::Any, faults);
    let (first, last) = (one(first, 0), one(last, 1));
    let [first, last] = [first?, last?];
    if first < last {
        return Some([first, last]);
    }
    let (first, last) = (shortest(first), shortest(last));
    let message = format!("the first value must be less than the last, got {first} and {last}");
    faults.add(node.at, path, message);
    None
}

/// Reports limits of axes that the kind of figure cannot have.
pub(super) fn check(checker: &mut Checker) {
    let figure = checker.figure;
    let Some((scales, quantities)) = figure.kind.decoded().limited_axes() else {
        return;
    };
    for ((key, range), scale) in RANGES.into_iter().zip(figure.ranges).zip(scales) {
        let Some([first, _]) = range else { continue };
        if scale == Scale::Log && first <= 0.0 {
            let first = shortest(first);
            let message = format!("must be > 0 on a log scale, got {first}");
            checker.fault_of_item(key, 0, message);
        }
    }
    if figure.ranges[1].is_some() && quantities > 1 {
        let message = format!("takes one quantity in \"y\", and the figure has {quantities}");
        checker.fault(RANGES[1], message);
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
