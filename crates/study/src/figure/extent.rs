//! The width of a figure and the limits of its axes, as a study gives them.

use crate::faults::Faults;
use crate::tree::Node;
use crate::value::number;
use slipgap_problem::problem::numbers::parameter::{Range, shortest};

/// Widths of a figure in mm, from less than a narrow column to more than a page across.
pub(crate) const WIDTHS: [f64; 2] = [70.0, 400.0];

/// Points in a mm.
pub(super) const POINTS: f64 = 72.0 / 25.4;

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
    let Some([first, last]) = node.list() else {
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
