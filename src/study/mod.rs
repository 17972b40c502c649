//! A study file, read: problem, blocks of axes, columns, figures and checks.
//!
//! The way of the data: text -> `tree` (every key and value with its place) -> `decode`, which goes by the tables of the
//! problem and of `figure::kinds` and collects every fault -> [`Study`] -> `block` and `cases`, made one at a time.

mod applies;
mod block;
mod blocks;
mod cases;
mod checks;
mod decode;
mod derived;
mod describe;
mod design;
pub mod expression;
mod figure;
mod finish;
mod hint;
mod input;
mod interval;
mod kept;
pub mod ledger;
mod measure;
mod object;
mod parameters;
mod place;
mod plain;
mod report;
mod rules;
mod scope;
mod setting;
mod spread;
#[cfg(test)]
mod tests;
mod tree;
pub mod units;
mod value;
mod zip;

pub use block::{Axis, Block, Group};
pub use decode::{parse, read};
pub use describe::{reference, schema, start};
pub use design::{Design, Sampling};
pub use figure::kinds::{self, FigureKind};
pub use input::{Input, STDIN};
pub use measure::Measure;
#[cfg(test)]
pub(crate) use measure::measures;
pub use plain::{printable, unprintable};
pub use rules::MOST_CASES;
pub use setting::Setting;
pub use units::Units;

use crate::problem::Problem;
use crate::problem::parameter::Value;
use std::sync::Arc;

/// A validated study.
#[derive(Debug)]
pub struct Study {
    /// What the study shows, in one line; empty if the study does not say.
    pub title: String,
    /// The problem whose cases it runs.
    pub problem: Arc<dyn Problem>,
    /// Whether each step is solved once, by the papers' matrices, in place of its root.
    pub once: bool,
    /// Blocks of cases, one after the other.
    pub blocks: Vec<Block>,
    /// Names of the units of its parameters, if results are wanted in them.
    pub units: Option<Units>,
    /// What is known of a case: the rows of `problem.metrics()`, then those in the units of the study.
    pub measures: Vec<Measure>,
    /// Rows of `problem.metrics()` that are solved for and stored, in the table's order.
    pub metrics: Vec<usize>,
    /// Rows of `measures` that results.csv has: each of the metrics, then the same in units.
    pub columns: Vec<usize>,
    /// Figures to draw.
    pub figures: Vec<Figure>,
    /// Tolerances to hold.
    pub checks: Vec<Check>,
    /// Parameters that the command line set.
    pub settings: Vec<Setting>,
    /// SHA-256 of the file's bytes, and of the settings where there are any, in hexadecimal digits.
    pub sha256: String,
}

/// Which cases are chosen: those that have, of each parameter named by its row, one of the values.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Filter(pub Vec<(usize, Vec<Value>)>);

/// A tolerance: every case of the filter has the metric within the limits.
#[derive(Debug)]
pub struct Check {
    /// Row of the study's measures.
    pub metric: usize,
    /// Which cases.
    pub filter: Filter,
    /// Smallest value allowed.
    pub min: Option<f64>,
    /// Largest value allowed.
    pub max: Option<f64>,
}

/// A figure: its file name, which cases it shows, and how.
#[derive(Debug)]
pub struct Figure {
    /// File name without ending.
    pub name: String,
    /// Heading, if the study gives one.
    pub title: Option<String>,
    /// What stands small under the panels, if the study says anything.
    pub note: Option<String>,
    /// Width in points, if the study gives one.
    pub width: Option<f64>,
    /// First and last value along the horizontal and the vertical axis, where the study gives them.
    pub ranges: [Option<[f64; 2]>; 2],
    /// Which cases.
    pub filter: Filter,
    /// What is drawn.
    pub kind: FigureKind,
}

/// A column of numbers in the results.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Column {
    /// Row of `problem.parameters()`.
    Parameter(usize),
    /// Row of the study's measures.
    Metric(usize),
}

/// Places that a map marks.
#[derive(Debug, Clone, PartialEq)]
pub struct Marks {
    /// What the legend calls them, in markup.
    pub label: String,
    /// Their values of the two axes' parameters.
    pub at: Vec<[f64; 2]>,
}

/// The value that a line along a map follows from column to column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ridge {
    /// The smallest.
    Least,
    /// The largest.
    Greatest,
    /// The one nearest to 1.
    NearestToOne,
}

/// How numbers are laid along an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// Evenly.
    Linear,
    /// By their logarithm; only positive numbers.
    Log,
}
