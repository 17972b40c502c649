//! The width of a figure and the limits of its axes: how they are written, and whether the figure can have them.

use super::taken::Values;
use crate::problem::parameter::{Range, shortest};
use crate::study::report::{Faults, join};
use crate::study::tree::{Node, Tree};
use crate::study::value::number;
use crate::study::{Figure, FigureKind, Scale};

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

/// Reports limits and widths that the kind of figure cannot have.
pub(super) fn check(figure: &Figure, values: &Values, faults: &mut Faults) {
    let (scales, quantities) = match &figure.kind {
        FigureKind::Metric {
            x_scale,
            y_scale,
            y,
            ..
        } => ([*x_scale, *y_scale], y.len()),
        FigureKind::Convergence { y, .. } | FigureKind::Budget { y, .. } => {
            ([Scale::Log; 2], y.len())
        }
        FigureKind::Scatter { scales, .. } => ([scales[0], scales[1]], 1),
        FigureKind::History { y, .. } | FigureKind::Profile { y, .. } => {
            ([Scale::Linear; 2], y.len())
        }
        FigureKind::Samples { parameters, .. } => {
            matrix(parameters.len(), figure, values, faults);
            return;
        }
        FigureKind::Map { .. }
        | FigureKind::Wave { .. }
        | FigureKind::Sobol { .. }
        | FigureKind::Law => return,
    };
    for ((key, range), scale) in RANGES.into_iter().zip(figure.ranges).zip(scales) {
        let Some([first, _]) = range else { continue };
        if scale == Scale::Log && first <= 0.0 {
            let (at, path) = values.item(key, 0);
            let first = shortest(first);
            faults.add(
                at,
                &path,
                format!("must be > 0 on a log scale, got {first}"),
            );
        }
    }
    if figure.ranges[1].is_some() && quantities > 1 {
        let message = format!("takes one quantity in \"y\", and the figure has {quantities}");
        faults.add(values.at(RANGES[1]), &join(values.path, RANGES[1]), message);
    }
}

/// Reports a width that is too small for the columns of a matrix of samples.
fn matrix(columns: usize, figure: &Figure, values: &Values, faults: &mut Faults) {
    let least = MATRIX[0] + MATRIX[1] * columns as f64;
    if let Some(width) = figure.width.map(|points| points / POINTS)
        && width < least
    {
        let width = shortest((1e9 * width).round() / 1e9);
        let message =
            format!("must be at least {least} for {columns} sampled parameters, got {width}");
        faults.add(values.at("width"), &join(values.path, "width"), message);
    }
}
