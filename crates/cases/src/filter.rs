//! A `where`: which cases a figure, a check or a claim applies to.

use slipgap_problem::problem::Case;
use slipgap_problem::problem::numbers::parameter::Value;

/// Which cases are selected: those that have one of the values of each parameter. A parameter is given by its row.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Filter(pub Vec<(usize, Vec<Value>)>);

impl Filter {
    /// Whether a completed case has one of the values of every parameter.
    pub fn matches(&self, case: &Case) -> bool {
        let has = |row: usize, wanted: &[Value]| {
            case.values
                .get(row)
                .copied()
                .flatten()
                .is_some_and(|value| value.is_one_of(wanted))
        };
        self.0.iter().all(|(row, wanted)| has(*row, wanted))
    }
}
