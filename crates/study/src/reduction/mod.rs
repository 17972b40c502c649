//! Reductions: one value of a metric for all cases that differ only in some parameters, as in `least rms_error over alpha`.

mod cases;
pub(super) mod decode;
mod groups;
mod operator;
#[cfg(test)]
mod tests;

pub use cases::{CaseMetrics, reduced_cases};
pub use groups::{Groups, Reduced};
pub(super) use operator::OPERATORS;
pub use operator::Operator;

use super::{Measure, Study};
use slipgap_problem::problem::numbers::parameter::Default;

/// A metric reduced over parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Reduction {
    /// What the value is among those of the cases.
    pub operator: Operator,
    /// Row of the study's measures: the metric that is reduced.
    pub of: usize,
    /// Parameters that it is reduced over; none if the text of the study has a fault.
    pub over: Vec<usize>,
    /// The same, and the parameters that change with them: no figure can show these.
    pub lost: Vec<usize>,
    /// The other parameters that vary in the study. Cases with the same values of these are reduced to one value.
    pub kept: Vec<usize>,
}

impl Reduction {
    /// Whether both reduce the same cases to one value.
    pub fn groups_like(&self, other: &Reduction) -> bool {
        self.lost == other.lost
    }
}

impl Study {
    /// The reductions of the study with their rows of the measures, in the order of the file.
    pub fn reductions(&self) -> impl Iterator<Item = (usize, &Measure, &Reduction)> {
        let measures = self.measures.iter().enumerate();
        measures.filter_map(|(row, measure)| Some((row, measure, measure.reduction.as_ref()?)))
    }

    /// Rows of the parameters that are columns of tables and differ between cases.
    pub fn varying_columns(&self) -> Vec<usize> {
        let table = self.problem.parameters();
        let computed = |row: usize| {
            let given = self.blocks.iter().any(|block| block.gives(row));
            matches!(table[row].default, Default::Follows(_)) && !given
        };
        let columns = self.parameter_columns().into_iter();
        columns
            .filter(|row| computed(*row) || decode::varies(&self.blocks, *row))
            .collect()
    }

    /// The reduction in this row of the measures, if it is one.
    pub fn reduction(&self, row: usize) -> Option<&Reduction> {
        self.measures.get(row)?.reduction.as_ref()
    }
}
