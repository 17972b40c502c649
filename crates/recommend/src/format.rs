//! Numbers as a person writes them.

use slipgap_problem::problem::numbers::parameter::shortest;

/// Four digits.
pub fn digits(x: f64) -> String {
    let rounded: f64 = format!("{x:.3e}").parse().unwrap_or(x);
    shortest(rounded)
}
