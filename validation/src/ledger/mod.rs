//! A ledger of claims: statements of a paper or of the literature, each with the studies that test it.

mod decode;
mod expect;
mod over;

pub use decode::read;

use slipgap_study::{Filter, Reference, Study};
use std::path::PathBuf;

/// The claims of one paper, or of the literature on one subject.
#[derive(Debug)]
pub struct Ledger {
    /// The paper or the literature, for the page.
    pub paper: String,
    /// The claims in order.
    pub claims: Vec<Claim>,
    /// The studies that the readings name.
    pub studies: Vec<LedgerStudy>,
}

/// A study that tests claims.
#[derive(Debug)]
pub struct LedgerStudy {
    /// Its folder under the output folder, as in `claims/impact-once`.
    pub name: String,
    /// Its file.
    pub file: PathBuf,
    /// The study.
    pub study: Study,
}

/// One statement.
#[derive(Debug)]
pub struct Claim {
    /// Short name, as in `F4`.
    pub id: String,
    /// Its place in the paper, or its source in the literature.
    pub place: String,
    /// The statement in our words.
    pub statement: String,
    /// What is computed to test it.
    pub quantity: String,
    /// The readings tested.
    pub readings: Vec<Reading>,
    /// Why it fails or holds only in some readings, or another remark.
    pub because: Option<String>,
}

/// One way to understand a statement.
#[derive(Debug)]
pub struct Reading {
    /// What is assumed.
    pub name: String,
    /// Which of the ledger's studies.
    pub study: usize,
    /// A figure of that study that shows it.
    pub figure: Option<String>,
    /// The expectations. All must be met.
    pub expect: Vec<Expect>,
    /// The recorded verdict.
    pub holds: bool,
    /// Why a limit stays that the values are near.
    pub near: Option<String>,
}

/// One condition for a reading to hold.
#[derive(Debug)]
pub struct Expect {
    /// The cases that it applies to.
    pub filter: Filter,
    /// What the metric is divided by, if it is.
    pub over: Option<Reference>,
    /// What must be true of these cases.
    pub demand: Demand,
}

/// What must be true of the cases. Metrics are rows of the study's measures; `along` is a row of `problem.parameters()`.
#[derive(Debug, Clone, PartialEq)]
pub enum Demand {
    /// A metric is within limits in every case, or in a share of them.
    Within {
        /// The metric.
        metric: usize,
        /// Smallest value allowed.
        min: Option<f64>,
        /// Largest value allowed.
        max: Option<f64>,
        /// Smallest share of the cases with a value that is within; `None` if all cases must be.
        share: Option<f64>,
    },
    /// A metric rises or falls from case to case along a parameter.
    Trend {
        /// The metric.
        metric: usize,
        /// The parameter.
        along: usize,
        /// Whether the metric rises.
        rising: bool,
    },
    /// A metric is smallest at a value of a parameter within limits.
    LeastAt {
        /// The metric.
        metric: usize,
        /// The parameter.
        along: usize,
        /// Limits of the parameter.
        range: [f64; 2],
    },
    /// The root mean square of a profile's error away from the fronts is at most `max`.
    AwayFromFronts {
        /// Row of `problem.schema().profiles`.
        profile: usize,
        /// Times in the problem's unit.
        times: Vec<f64>,
        /// Smallest distance from every front, in the problem's unit of length.
        away: f64,
        /// Largest value allowed.
        max: f64,
    },
    /// The root mean square of the error of a later event, over times of free motion, is within limits.
    LaterEvent {
        /// Row of `problem.schema().later`.
        later: usize,
        /// Times of free motion in the problem's unit.
        flights: Vec<f64>,
        /// Smallest value allowed.
        min: Option<f64>,
        /// Largest value allowed.
        max: Option<f64>,
    },
}
