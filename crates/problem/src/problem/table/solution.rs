//! The solution of a case: histories, metrics and snapshots.

use crate::history::History;
use crate::metrics::measured::at_steps;
use crate::problem::table::schema::Channel;
use crate::solve::Warnings;
use std::ops::Range;

/// The state along the structure at one time.
#[derive(Debug, Clone, PartialEq)]
pub struct Snapshot {
    /// Time of the step, in the problem's unit.
    pub time: f64,
    /// In the order of `problem.schema().profiles`.
    pub profiles: Vec<Lines>,
    /// Displacement along the structure since t = 0, in the problem's unit of length.
    pub displacement: Lines,
    /// Positions of the fronts of the exact solution, including those at an end of a part.
    pub fronts: Vec<f64>,
}

/// One quantity along the structure, a line for each of its parts, as points (place, value).
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Lines {
    /// Computed, at nodes or in elements.
    pub computed: Vec<Vec<[f64; 2]>>,
    /// Exact, with both sides of every jump.
    pub exact: Vec<Vec<[f64; 2]>>,
}

/// A column of a history.
#[derive(Debug, Clone)]
pub struct HistoryColumn {
    /// The channel of the histories in a [`Solution`].
    pub index: usize,
    /// Its name, and whether the exact motion has the column too.
    pub column: Channel,
}

/// A measured channel in a case.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredChannel {
    /// The channel, such as `deck.u`.
    pub name: String,
    /// The channel of the histories in a [`Solution`].
    pub column: usize,
    /// Times of all measured points in the time of the motion, in the study's unit; some may be before 0 or after its end.
    pub time: Vec<f64>,
    /// Values at these times, in the study's units.
    pub values: Vec<f64>,
    /// The points that metrics compare.
    pub compared: Range<usize>,
}

impl MeasuredChannel {
    /// The name of its column in a history, `NAME_measured`.
    pub fn history_name(&self) -> String {
        format!("{}_measured", self.name)
    }

    /// The values at these times, which rise, straight between the measured points; NaN before the first and after the last one.
    pub fn at(&self, times: &[f64]) -> Vec<f64> {
        at_steps(&self.time, &self.values, times)
    }
}

/// The solution of a case: the computed motion, and the exact one at the same times.
#[derive(Debug, Clone)]
pub struct Solution {
    /// The computed motion.
    pub computed: History,
    /// The exact motion.
    pub exact: History,
    /// In the order of the problem's table; `None` if undefined for the case.
    pub metrics: Vec<Option<f64>>,
    /// What it warns of.
    pub warnings: Warnings,
}
