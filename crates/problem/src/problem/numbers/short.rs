//! Numbers for people.

use crate::problem::numbers::parameter::shortest;

/// Six significant digits.
pub fn short(x: f64) -> String {
    let rounded: f64 = format!("{x:.5e}").parse().unwrap_or(x);
    shortest(rounded)
}
