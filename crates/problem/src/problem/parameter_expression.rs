//! An expression with its text, and its value for a case.

use super::Case;
use crate::problem::expression::{ExpressionFault, Formula, quoted};
use std::fmt;

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
    /// A result that is not finite, or a parameter without a value.
    pub fn value(&self, case: &Case) -> Result<f64, NotComputed> {
        let value = self.formula.value(&|row| case.values[row]);
        value.map_err(|fault| NotComputed::new(&self.formula, &self.text, case, fault))
    }
}

/// That an expression has no finite value for a case. Displayed with the values of its parameters.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NotComputed {
    text: String,
    values: String,
    fault: ExpressionFault,
}

impl NotComputed {
    /// For a formula with its text, which has this fault in a case.
    pub fn new(formula: &Formula, text: &str, case: &Case, fault: ExpressionFault) -> NotComputed {
        NotComputed {
            text: text.to_owned(),
            values: values_used(formula, case),
            fault,
        }
    }
}

impl fmt::Display for NotComputed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}: {}", quoted(&self.text), self.values, self.fault)
    }
}

impl std::error::Error for NotComputed {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        Some(&self.fault)
    }
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
