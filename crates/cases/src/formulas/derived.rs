//! Parameters given by expressions of others, and conditions.

use super::formula_table::FormulaTable;
use crate::axis::group::AxisGroup;
use slipgap_problem::problem::expression::Formula;
use slipgap_problem::problem::expression::quoted;
use slipgap_problem::problem::numbers::allowed::value_of;
use slipgap_problem::problem::numbers::parameter::{Parameter, Value, shortest};
use slipgap_problem::problem::{Case, NotComputed, Violation, values_used};

/// A parameter that an expression gives.
#[derive(Debug, Clone)]
pub struct Derived {
    /// Row of `problem.parameters()`.
    pub parameter: usize,
    /// The expression as it is in the study.
    pub text: String,
    /// Whether the expression contains the alternative parameter, from which the problem computes this one anyway, as in
    /// `"k_I": "gamma * n * E * A / L"`. Both values must then agree.
    pub restates: bool,
    /// The expression, with its values.
    pub formula: FormulaTable,
}

/// A condition that combinations must meet.
#[derive(Debug, Clone)]
pub struct Condition {
    /// The condition as it is in the study.
    pub text: String,
    /// The expression, with its values.
    pub formula: FormulaTable,
}

impl Derived {
    /// The value for a case that has the parameters of the expression.
    pub fn value(&self, groups: &[AxisGroup], case: &Case, positions: &[u64]) -> Option<Value> {
        let x = self.formula.value(groups, case, positions)?;
        value_of(x, &case.schema.parameters[self.parameter]).ok()
    }

    /// The rule that a case breaks if the expression gives no valid value.
    pub fn violation(&self, case: &Case) -> Option<Violation> {
        if case.values[self.parameter].is_some() {
            return None;
        }
        let parameter = &case.schema.parameters[self.parameter];
        let message = refused(&self.formula.formula, &self.text, case, parameter)?;
        Some(Violation {
            parameter: parameter.name.clone(),
            message,
            at: None,
        })
    }
}

impl Condition {
    /// Whether the condition is met, if the table has its value.
    pub fn looked_up(&self, groups: &[AxisGroup], positions: &[u64]) -> Option<bool> {
        self.formula.looked_up(groups, positions).map(|x| x != 0.0)
    }

    /// Whether a case meets the condition; `None` if the condition has no value.
    pub fn holds(&self, groups: &[AxisGroup], case: &Case, positions: &[u64]) -> Option<bool> {
        self.formula
            .value(groups, case, positions)
            .map(|x| x == 1.0)
    }
}

/// Why an expression gives no valid value of a parameter; `None` if it gives one.
pub fn refused(
    formula: &Formula,
    text: &str,
    case: &Case,
    parameter: &Parameter,
) -> Option<String> {
    let x = match formula.value(&|row| case.values[row]) {
        Ok(x) => x,
        Err(fault) => return Some(NotComputed::new(formula, text, case, fault).to_string()),
    };
    let allowed = value_of(x, parameter).err()?;
    let (x, values) = (shortest(x), values_used(formula, case));
    let text = quoted(text);
    Some(format!("must be {allowed}, got {text} = {x}{values}"))
}
