//! The values of a formula for all combinations of a block that it depends on.

use super::block::Block;
use crate::formulas::formula_table::FormulaTable;
use slipgap_problem::problem::expression::{ExpressionFault, Formula};
use slipgap_problem::problem::{Case, Schema};
use std::sync::Arc;

/// Most entries of a table. A formula with more depends on so much that hardly any two cases share a value.
const MOST_ENTRIES: u64 = 1 << 20;

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
}
