//! The results of a part: as columns, or case by case.

use crate::store::Miss;
use slipgap_motion::solve::{MetricTable, Unsolvable};
use slipgap_problem::problem::table::cases::Cases;
use slipgap_problem::problem::{Case, Solution};
use slipgap_study::Study;
use std::collections::BTreeMap;

/// The result of one case.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// The case.
    pub case: Case,
    /// In the order of the study's measures; `None` if a metric is undefined or not computed, or if the case could not be
    /// solved.
    pub metrics: Vec<Option<f64>>,
    /// The histories, if they were kept.
    pub solution: Option<Box<Solution>>,
    /// Why the case could not be solved, if so.
    pub failure: Option<Unsolvable>,
}

/// The histories of some cases of a part, by row.
pub type Solutions = BTreeMap<usize, Box<Solution>>;

/// The results of a part.
#[derive(Debug)]
pub struct PartResult {
    /// Number of the first case.
    pub first: u64,
    /// The cases.
    pub cases: Cases,
    /// Their metrics.
    pub metrics: MetricTable,
    /// The histories that were kept.
    pub solutions: Solutions,
    /// Whether the store had the part; if not, why.
    pub stored: Result<(), Miss>,
    /// Number of cases whose metrics come from the store: from this part, or from others.
    pub from_store: u64,
}

impl PartResult {
    /// Number of cases.
    pub fn len(&self) -> usize {
        self.cases.len()
    }

    /// Whether there are no cases; no run makes such a part.
    pub fn is_empty(&self) -> bool {
        self.cases.is_empty()
    }

    /// The number of the case in a row.
    pub fn number(&self, row: usize) -> u64 {
        self.first + self.cases.offset(row)
    }

    /// The outcomes one by one, with the numbers of their cases.
    pub fn outcomes(mut self, study: &Study) -> Vec<(u64, Outcome)> {
        let width = study.measures.len();
        let (mut shown, first) = (self.cases.shown(), self.first);
        let outcome = |row: usize| {
            let mut metrics = self.metrics.row(row).collect::<Vec<_>>();
            metrics.resize(width, None);
            let outcome = Outcome {
                case: shown.at(row).clone(),
                metrics,
                solution: self.solutions.remove(&row),
                failure: self.metrics.failure(row).cloned(),
            };
            (first + self.cases.offset(row), outcome)
        };
        (0..self.cases.len()).map(outcome).collect()
    }
}
