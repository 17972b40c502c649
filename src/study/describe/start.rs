//! Studies to begin with.

use crate::problem::Problem;

/// A small commented study of a problem, with `NAME` for its name and `SCHEMA` for the way to the schema.
pub fn start(problem: &dyn Problem) -> &'static str {
    match problem.name() {
        "friction-oscillator" => include_str!("start/friction-oscillator.json"),
        _ => include_str!("start/bar-impact.json"),
    }
}
