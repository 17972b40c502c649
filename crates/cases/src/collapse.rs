//! Axes of parameters that only some names of another parameter have: for the other names they are one value.

use crate::axis::group::{Axis, AxisGroup};
use crate::block::Block;
use crate::formulas::derived::Condition;
use crate::formulas::formula_table::FormulaTable;
use slipgap_problem::problem::Problem;
use slipgap_problem::problem::expression::Formula;
use slipgap_problem::problem::numbers::parameter;
use std::sync::OnceLock;

/// Most combinations of the axes that decide it; of more, the other names have equal cases.
const MOST_ENTRIES: u64 = 1 << 20;

/// The condition of a block that has none.
const ALWAYS: &str = "1 == 1";

impl Block {
    /// Leaves out the combinations that only differ in parameters that do not apply, where the table says so.
    pub fn collapse(&mut self, problem: &dyn Problem) {
        let table = problem.parameters();
        let condition = |axis: &Axis| -> Option<&parameter::Condition> {
            let applies = table[axis.parameter].applies.as_ref();
            applies.filter(|on| on.collapses)
        };
        let governors = |group: &AxisGroup| -> Option<Vec<usize>> {
            let of_axis = |axis: &Axis| {
                let on = condition(axis)?;
                let row = table.iter().position(|known| known.name == on.governor)?;
                self.groups.iter().position(|group| group.has(row))
            };
            let found = group
                .axes
                .iter()
                .map(of_axis)
                .collect::<Option<Vec<usize>>>();
            found.filter(|_| group.len() > 1)
        };
        let numbered = self.groups.iter().enumerate();
        let collapsing: Vec<(usize, Vec<usize>)> = numbered
            .filter_map(|(g, group)| Some((g, governors(group)?)))
            .collect();
        if collapsing.is_empty() {
            return;
        }
        let given = self.when.as_ref();
        if given.is_some_and(|when| when.formula.table.is_none()) {
            return;
        }
        let of_given = given.map_or(&[][..], |when| &when.formula.on);
        let of_groups = collapsing.iter().flat_map(|(g, on)| on.iter().chain([g]));
        let mut on: Vec<usize> = of_given.iter().chain(of_groups).copied().collect();
        on.sort_unstable();
        on.dedup();
        let (text, formula) = match given {
            Some(when) => (when.text.clone(), when.formula.formula.clone()),
            None => match Formula::condition(ALWAYS, table) {
                Ok(formula) => (ALWAYS.to_owned(), formula),
                Err(_) => return,
            },
        };
        let mut formula_table = FormulaTable {
            formula,
            on,
            table: None,
        };
        let entries = formula_table.entries(&self.groups);
        if entries > MOST_ENTRIES {
            return;
        }
        let is_case = |positions: &[u64]| {
            let met =
                given.is_none_or(|when| when.looked_up(&self.groups, positions) == Some(true));
            let applies = |g: usize, on: &[usize]| {
                let mut axes = self.groups[g].axes.iter().zip(on);
                axes.any(|(axis, governor)| {
                    let Some(on) = condition(axis) else {
                        return true;
                    };
                    let mut of_group = self.groups[*governor].axes.iter();
                    let row = of_group.find(|axis| table[axis.parameter].name == on.governor);
                    row.is_some_and(|axis| {
                        on.allows(axis.values.at(positions[*governor] as usize).name())
                    })
                })
            };
            let mut groups = collapsing.iter();
            met && groups.all(|(g, on)| positions[*g] == 0 || applies(*g, on))
        };
        let mut values = Vec::with_capacity(entries as usize);
        let mut positions = vec![0; self.groups.len()];
        for entry in 0..entries {
            let mut rest = entry;
            for group in formula_table.on.iter().rev() {
                positions[*group] = rest % self.groups[*group].len();
                rest /= self.groups[*group].len();
            }
            values.push(f64::from(u8::from(is_case(&positions))));
        }
        formula_table.table = Some(values);
        self.when = Some(Condition {
            text,
            formula: formula_table,
        });
        (self.counts, self.shared) = (OnceLock::new(), OnceLock::new());
    }
}
