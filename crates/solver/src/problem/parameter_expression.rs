//! An expression with its text, and its value for a case.

use super::{ExpressionFault, Formula, quoted};
use crate::problem::Case;

/// An expression of the parameters of a case, with its text in the study.
#[derive(Debug, Clone)]
pub struct ParameterExpression {
    /// The parsed expression.
    pub formula: Formula,
    /// The text.
    pub text: String,
}

impl ParameterExpression {
    /// The value for a completed case.
    ///
    /// # Errors
    /// The message that says why there is none.
    pub fn value(&self, case: &Case) -> Result<f64, String> {
        let value = self.formula.value(&|row| case.values[row]);
        value.map_err(|fault| not_computed(&self.formula, &self.text, case, &fault))
    }
}

/// The message for an expression that has no finite value for a case.
pub fn not_computed(formula: &Formula, text: &str, case: &Case, fault: &ExpressionFault) -> String {
    let values = values_used(formula, case);
    format!("{}{values}: {}", quoted(text), fault.message)
}

/// The values of the parameters in a formula, as ` with n = 3, L = 10`; empty if none has a value.
pub fn values_used(formula: &Formula, case: &Case) -> String {
    let values = formula.uses().iter().filter_map(|row| {
        let value = case.values[*row]?;
        Some(format!("{} = {value}", case.schema.parameters[*row].name))
    });
    match values.collect::<Vec<_>>() {
        values if values.is_empty() => String::new(),
        values => format!(" with {}", values.join(", ")),
    }
}
