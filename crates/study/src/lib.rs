//! Studies: a file is read and validated, and gives the cases, figures and checks of a run.
//!
//! The text becomes a tree with the place of every key and value (`source`). `decode` makes a [`Study`] of it by the tables of
//! the problem and of `figure::kinds`, with the axes of its blocks (`axes`) and its figures (`figure`), and reports every
//! fault. Each case is then made from its number (`cases`).

mod axes;
mod calibrate;
mod cases;
mod computed;
mod decode;
mod describe;
pub mod error;
mod figure;
mod measure;
mod reduction;
mod source;
mod structure;
pub mod units;
pub mod value;

// For the ledger of claims, which has the same syntax.
pub use cases::scope;
pub use computed::reference_case;
pub use figure::reduced;
pub use slipgap_cases::alike;
pub use source::{faults, field, input, object, place, search, tree};

pub use calibrate::Calibrate;
pub use calibrate::Free;
pub use calibrate::FreeRange;
pub use calibrate::PointCases;
pub use calibrate::Recommend;
pub use calibrate::decode::FIGURES as CALIBRATION_FIGURES;
pub use calibrate::{Alternative, Candidates};
pub use computed::{Computed, Reference, Rule};
pub use decode::validate::MOST_CASES;
pub use decode::{parse, read};
pub use describe::{problem_pages, problem_reference, reference, schema, start};
pub use figure::kinds::{self, FigureKind, Marks, Ridge};
pub use measure::{Measure, measures};
pub use reduction::{CaseMetrics, Groups, Operator, Reduced, Reduction, reduced_cases};
pub use slipgap_cases::{
    Axis, AxisGroup, Block, Design, Filter, Found, Partners, Sampling, Values,
};
pub use slipgap_problem::problem::expression::{printable, unprintable};
pub use source::folder::ReadFile;
pub use source::input::{Input, STDIN};
pub use source::setting::{Setting, SettingFault};
pub use structure::programs::described::request;
pub use structure::recorded::selected::choosing;
pub use units::Units;

pub use slipgap_problem::problem::numbers::parameter::Scale;

/// Hash of the code that makes numbers of a structure: the keys of stores have no numbers of structures. Comments, documentation and
/// tests do not change it.
pub const READER_KEY: &str = env!("SLIPGAP_READER");

use slipgap_problem::problem::{Problem, capital};
use std::sync::Arc;

/// A validated study.
#[derive(Debug)]
pub struct Study {
    /// The title; empty if the study has none.
    pub title: String,
    /// The problem.
    pub problem: Arc<dyn Problem>,
    /// Whether each step is solved once with the matrices of the papers, instead of to convergence.
    pub once: bool,
    /// The blocks of cases in order.
    pub blocks: Vec<Block>,
    /// Names of the units of its parameters, if the study has results in units.
    pub units: Option<Units>,
    /// The rows of `problem.metrics()`, then those in the units of the study, then what is computed from these, then the reductions.
    pub measures: Vec<Measure>,
    /// Rows of `problem.metrics()` that are computed and stored, in the order of the table.
    pub metrics: Vec<usize>,
    /// Rows of `measures` that are columns of results.csv: each metric, then the same in units; then what is computed from others.
    pub columns: Vec<usize>,
    /// Rows of `problem.parameters()` over which the cases are an ensemble; empty if the study has none.
    pub ensemble: Vec<usize>,
    /// Free parameters and the metric that their best values minimise, if the study has them.
    pub calibrate: Option<Calibrate>,
    /// Parameters to choose and metrics to keep, if the study has them.
    pub recommend: Option<Recommend>,
    /// Figures to draw.
    pub figures: Vec<Figure>,
    /// Limits to test.
    pub checks: Vec<Check>,
    /// Parameters that the command line set.
    pub settings: Vec<Setting>,
    /// SHA-256 of the bytes of the file and of the settings, in hexadecimal digits.
    pub sha256: String,
    /// Records, matrices and other files that were read with it, by name.
    pub read: Vec<ReadFile>,
}

impl Study {
    /// The title of an axis of a measure, in markup.
    pub fn title(&self, measure: usize) -> String {
        let symbol = &self.measures[measure].symbol;
        match self.problem.schema().described {
            true => capital(symbol),
            // The papers' symbols keep their look.
            false => symbol.clone(),
        }
    }
}

/// A check: every case of the filter must have the metric within the limits.
#[derive(Debug)]
pub struct Check {
    /// Row of the study's measures.
    pub metric: usize,
    /// The cases that it applies to.
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
    /// Text in small print under the panels, if the study has one.
    pub note: Option<String>,
    /// Width in points, if the study gives one.
    pub width: Option<f64>,
    /// First and last value along the horizontal and the vertical axis, where the study gives them.
    pub ranges: [Option<[f64; 2]>; 2],
    /// Whether curves have colours instead of dashes.
    pub colour: bool,
    /// Whether curves in colour have markers.
    pub markers: bool,
    /// Which cases.
    pub filter: Filter,
    /// What is drawn.
    pub kind: FigureKind,
}

/// A column of numbers in the results.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ColumnRef {
    /// Row of `problem.parameters()`.
    Parameter(usize),
    /// Row of the study's measures.
    Metric(usize),
}
