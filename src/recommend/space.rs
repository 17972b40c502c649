//! Search spaces: the candidates of a problem.

use crate::history::History;
use crate::problem::{Case, Problem};

/// Candidates of the same cost, with their neighbours.
#[derive(Debug, Default)]
pub struct CostLevel {
    /// The cases of candidates and neighbours.
    pub cases: Vec<Case>,
    /// For each candidate its index in `cases`, then those of its neighbours.
    pub candidates: Vec<Vec<usize>>,
}

/// The candidates of a search.
pub trait SearchSpace: Sync {
    /// The problem.
    fn problem(&self) -> &'static dyn Problem;
    /// Names of the parameters in the table of an answer.
    fn table_parameters(&self) -> Vec<&'static str>;
    /// Names of the parameters of an answer in a study.
    fn study_parameters(&self) -> Vec<&str>;
    /// The value of a parameter in the table.
    fn table_cell(&self, case: &Case, name: &str) -> String {
        self.study_value(case, name)
    }
    /// The value of a parameter in a study, as an expression if that is rounder; `-` if the parameter does not apply.
    fn study_value(&self, case: &Case, name: &str) -> String;
    /// Sentences about the candidates, the neighbours, and the cases that are not searched.
    fn notes(&self) -> Vec<String>;
    /// The unit of the cost.
    fn cost_title(&self) -> &'static str;
    /// The cost of every level.
    fn costs(&self) -> Vec<u64>;
    /// A level by its index in `costs`.
    fn level(&self, index: usize) -> CostLevel;
    /// Rows of the metrics that are the largest change of energy, with its sign, and the change at the end; `None` if
    /// energy has no limit.
    fn energy_drifts(&self) -> Option<[usize; 2]>;
    /// The largest gain of energy at any step, relative to the energy at the start; `None` if energy has no limit.
    fn energy_gain(&self, case: &Case, computed: &History) -> Option<f64>;
}
