//! What became of cases: a part as columns, or case by case.

use crate::problem::cases::Cases;
use crate::problem::{Case, Solution};
use crate::solve::{MetricTable, Unsolvable};
use crate::study::Study;
use std::collections::BTreeMap;

/// What became of one case.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// The case.
    pub case: Case,
    /// In the order of the study's measures; `None` where one is undefined, was not asked for, or the case could not be
    /// solved.
    pub metrics: Vec<Option<f64>>,
    /// The histories, where they were asked for.
    pub solution: Option<Box<Solution>>,
    /// Why the case could not be solved, if so.
    pub failure: Option<String>,
}

/// Histories of some of a part's cases.
pub(super) type Solutions = BTreeMap<usize, Box<Solution>>;

/// The outcomes of a part and where they came from.
#[derive(Debug)]
pub struct Done {
    /// Number of the first case; the others follow.
    pub first: u64,
    /// The cases.
    pub cases: Cases,
    /// What was found of each.
    pub found: MetricTable,
    pub(super) solutions: Solutions,
    /// Whether they were kept from a former run; if not, and something was there, why it could not serve.
    pub kept: Result<(), Option<String>>,
    /// Number of cases that were kept from a former run, in this part or in others.
    pub from_store: u64,
}

impl Done {
    /// Number of cases.
    pub fn len(&self) -> usize {
        self.cases.len()
    }

    /// Whether there are none, which no run hands over.
    pub fn is_empty(&self) -> bool {
        self.cases.is_empty()
    }

    /// The outcomes one by one, with the numbers of their cases.
    pub fn outcomes(mut self, study: &Study) -> Vec<(u64, Outcome)> {
        let width = study.measures.len();
        let mut shown = self.cases.shown();
        let outcome = |place: usize| {
            let mut metrics = self.found.row(place).collect::<Vec<_>>();
            metrics.resize(width, None);
            let outcome = Outcome {
                case: shown.at(place).clone(),
                metrics,
                solution: self.solutions.remove(&place),
                failure: self.found.failure(place).map(Unsolvable::to_string),
            };
            (self.first + place as u64, outcome)
        };
        (0..self.cases.len()).map(outcome).collect()
    }
}
