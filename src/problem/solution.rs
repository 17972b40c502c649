//! A case solved: its histories and metrics, and its snapshots.

use crate::history::History;

/// What stands along the structure at one time.
#[derive(Debug, Clone, PartialEq)]
pub struct Snapshot {
    /// Time of the step, in the problem's unit.
    pub time: f64,
    /// In the order of `problem.schema().profiles`.
    pub profiles: Vec<Lines>,
    /// Where the exact solution's fronts stand, those at an end of a part included.
    pub fronts: Vec<f64>,
}

/// One quantity along the structure, a line for each of its parts, as points (place, value).
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Lines {
    /// By the stepper, at nodes or in elements.
    pub computed: Vec<Vec<[f64; 2]>>,
    /// By the exact solution, with both sides of every jump.
    pub exact: Vec<Vec<[f64; 2]>>,
}

/// A case solved: what was computed, and the exact solution at the same times.
#[derive(Debug, Clone)]
pub struct Solution {
    /// By the stepper.
    pub computed: History,
    /// By the exact solution.
    pub exact: History,
    /// In the order of the problem's table; `None` where one is undefined for the case.
    pub metrics: Vec<Option<f64>>,
}
