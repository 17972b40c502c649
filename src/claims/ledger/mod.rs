//! A ledger of claims: sentences of a paper, each with the studies and values that decide whether it holds.

mod decode;
mod expect;

pub use decode::read;

use crate::study::{Filter, Study};
use std::path::PathBuf;

/// The claims of one paper.
#[derive(Debug)]
pub struct Ledger {
    /// The paper, for the page.
    pub paper: String,
    /// What is claimed, in the paper's order.
    pub claims: Vec<Claim>,
    /// The studies that the readings name.
    pub studies: Vec<Settling>,
}

/// A study that settles claims.
#[derive(Debug)]
pub struct Settling {
    /// Its folder under the output folder, as in `claims/impact-once`.
    pub name: String,
    /// Its file.
    pub file: PathBuf,
    /// The study.
    pub study: Study,
}

/// One sentence.
#[derive(Debug)]
pub struct Claim {
    /// Short name, as in `F4`.
    pub id: String,
    /// Where it stands in the paper.
    pub place: String,
    /// What it says, in our words.
    pub says: String,
    /// What is computed to judge it.
    pub quantity: String,
    /// The readings tried.
    pub readings: Vec<Reading>,
    /// Why it fails or holds only if, or what else there is to say.
    pub because: Option<String>,
}

/// One way to read a sentence.
#[derive(Debug)]
pub struct Reading {
    /// What is assumed.
    pub name: String,
    /// Which of the ledger's studies.
    pub study: usize,
    /// A figure of that study to look at.
    pub figure: Option<String>,
    /// All of these must be so.
    pub expect: Vec<Expect>,
    /// The recorded verdict.
    pub holds: bool,
}

/// One thing that must be so for a reading to hold.
#[derive(Debug)]
pub struct Expect {
    /// What is looked at.
    pub of: Looked,
    /// In which cases.
    pub filter: Filter,
    /// What must be so.
    pub demand: Demand,
}

/// What an expectation looks at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Looked {
    /// Row of the study's measures.
    Metric(usize),
    /// Row of `problem.schema().profiles`: the root mean square of its error away from fronts.
    Profile(usize),
    /// Row of `problem.schema().later`: the root mean square of its error over flights.
    Later(usize),
}

/// What must be so.
#[derive(Debug, Clone, PartialEq)]
pub enum Demand {
    /// In every case within limits.
    Within {
        /// Smallest value allowed.
        min: Option<f64>,
        /// Largest value allowed.
        max: Option<f64>,
    },
    /// From case to case along a parameter.
    Trend {
        /// Row of `problem.parameters()`.
        along: usize,
        /// Whether it rises, or falls.
        rising: bool,
    },
    /// Least at a value of a parameter within limits.
    LeastAt {
        /// Row of `problem.parameters()`.
        along: usize,
        /// Limits of that value.
        range: [f64; 2],
    },
    /// A profile's error at these times, further than `away` from every front, at most `max`.
    Away {
        /// Times in the problem's unit.
        times: Vec<f64>,
        /// Distance in the profile's unit of place.
        away: f64,
        /// Largest value allowed.
        max: f64,
    },
    /// The error of a later event after these times of free motion, within limits.
    After {
        /// Times in the problem's unit.
        flights: Vec<f64>,
        /// Smallest value allowed.
        min: Option<f64>,
        /// Largest value allowed.
        max: Option<f64>,
    },
}
