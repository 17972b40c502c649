//! Numbers as a person writes them.

use slipgap_problem::problem::Case;
use slipgap_problem::problem::numbers::parameter::shortest;

/// Four digits.
pub fn digits(x: f64) -> String {
    let rounded: f64 = format!("{x:.3e}").parse().unwrap_or(x);
    shortest(rounded)
}

/// Whether a number is a positive integer, apart from rounding.
pub(super) fn is_positive_integer(x: f64) -> bool {
    (x - x.round()).abs() < 1e-9 && x.round() > 0.0
}

/// The value of a parameter; `-` if it does not apply.
pub(super) fn plain(case: &Case, name: &str) -> String {
    case.get(name).map_or("-".into(), |value| value.to_string())
}
