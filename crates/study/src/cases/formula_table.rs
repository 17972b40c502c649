//! A formula with its values for all combinations of the groups that it depends on.

use super::block::Block;
use super::group::AxisGroup;
use slipgap_solver::problem::expression::{ExpressionFault, Formula};
use slipgap_solver::problem::{Case, Schema};
use std::sync::Arc;

/// Most entries of a table. A formula with more depends on so much that hardly any two cases share a value.
const MOST_ENTRIES: u64 = 1 << 20;

/// A formula and its table of values.
#[derive(Debug, Clone)]
pub(crate) struct FormulaTable {
    pub formula: Formula,
    /// The groups that the formula depends on, in rising order.
    pub on: Vec<usize>,
    /// The values by the positions of these groups, the last group fastest. `None` if the table would be too large.
    pub table: Option<Vec<f64>>,
}

impl FormulaTable {
    /// The formula without a table.
    pub fn new(formula: Formula, block: &Block) -> FormulaTable {
        let mut on = Vec::new();
        for &row in formula.uses() {
            if let Some(group) = block.groups.iter().position(|group| group.has(row)) {
                on.push(group);
            }
            if let Some(derived) = block.derived.iter().find(|d| d.parameter == row) {
                on.extend(&derived.formula.on);
            }
        }
        on.sort_unstable();
        on.dedup();
        FormulaTable {
            formula,
            on,
            table: None,
        }
    }

    /// Computes the table, if it is not too large.
    ///
    /// # Errors
    /// The first case without a value, and why it has none.
    pub fn fill(
        &mut self,
        block: &Block,
        schema: &Arc<Schema>,
    ) -> Result<(), (Box<Case>, ExpressionFault)> {
        let entries = self.entries(&block.groups);
        if entries > MOST_ENTRIES {
            return Ok(());
        }
        let mut values = Vec::new();
        for entry in 0..entries {
            let case = self.case(block, entry, schema);
            match self.formula.value(&|row| case.values[row]) {
                Ok(value) => values.push(value),
                Err(fault) => return Err((Box::new(case), fault)),
            }
        }
        self.table = Some(values);
        Ok(())
    }

    /// A case with the parameters that the formula depends on, at an entry of the table.
    pub fn case(&self, block: &Block, entry: u64, schema: &Arc<Schema>) -> Case {
        let mut positions = vec![0; block.groups.len()];
        let mut rest = entry;
        for &group in self.on.iter().rev() {
            positions[group] = rest % block.groups[group].len();
            rest /= block.groups[group].len();
        }
        let mut case = Case::new(schema);
        block.fill(&mut case, &positions, block.derived.len());
        case
    }

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
