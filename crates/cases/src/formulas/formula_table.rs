//! A formula with its values for all combinations of the groups that it depends on.

use crate::axis::group::AxisGroup;
use slipgap_problem::problem::Case;
use slipgap_problem::problem::expression::Formula;

/// A formula and its table of values.
#[derive(Debug, Clone)]
pub struct FormulaTable {
    /// The formula.
    pub formula: Formula,
    /// The groups that the formula depends on, in rising order.
    pub on: Vec<usize>,
    /// The values by the positions of these groups, the last group fastest. `None` if the table would be too large.
    pub table: Option<Vec<f64>>,
}

impl FormulaTable {
    /// Number of entries of the table.
    pub fn entries(&self, groups: &[AxisGroup]) -> u64 {
        let lens = self.on.iter().map(|group| groups[*group].len());
        lens.fold(1, u64::saturating_mul)
    }

    /// The value in the table at these positions of the groups, which nothing reads if there is no table.
    pub fn looked_up(&self, groups: &[AxisGroup], positions: &[u64]) -> Option<f64> {
        let table = self.table.as_ref()?;
        let index = |index: u64, group: &usize| index * groups[*group].len() + positions[*group];
        let entry = self.on.iter().fold(0, index);
        table.get(entry as usize).copied()
    }

    /// The value in the table, or computed from a case. `None` if it has no finite value.
    pub fn value(&self, groups: &[AxisGroup], case: &Case, positions: &[u64]) -> Option<f64> {
        self.looked_up(groups, positions)
            .or_else(|| self.formula.value(&|row| case.values[row]).ok())
    }
}
