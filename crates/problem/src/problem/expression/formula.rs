//! An expression as steps for a stack of numbers, and its value.

use crate::problem::numbers::parameter::Value;
use crate::problem::table::schema::Text;
use std::fmt;

/// A fault of an expression, and its byte offset.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ExpressionFault {
    /// Byte offset in the expression.
    pub offset: usize,
    /// What is wrong and what is allowed.
    pub message: String,
    /// The name, if it is one that is not known here.
    pub unknown: Option<Box<UnknownName>>,
}

/// A name that is none of those allowed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnknownName {
    /// What it should be, as in `name`.
    pub what: String,
    /// The name.
    pub name: String,
    /// The names allowed.
    pub allowed: Vec<Text>,
}

impl fmt::Display for ExpressionFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for ExpressionFault {}

/// A parsed expression. Its evaluation fails only if a number is not finite or a value is missing.
#[derive(Debug, Clone, Default)]
pub struct Formula {
    /// Each with its offset in the text.
    pub(super) steps: Vec<(Step, usize)>,
    pub(super) uses: Vec<usize>,
    /// Names of the parameters in `uses`.
    pub(super) names: Vec<Text>,
}

/// A step on the stack; true is 1, false is 0.
#[derive(Debug, Clone, Copy)]
pub(super) enum Step {
    Number(f64),
    /// The value of the parameter in a row of the table.
    Parameter(usize),
    /// Whether the parameter in a row has this name.
    Is(usize, &'static str),
    One(fn(f64) -> f64),
    Two(fn(f64, f64) -> f64),
}

impl Formula {
    fn name(&self, row: usize) -> &str {
        let index = self.uses.iter().position(|used| *used == row);
        index.map_or("", |i| &self.names[i])
    }

    /// Rows of its parameters, each once, in the order of the text.
    pub fn uses(&self) -> &[usize] {
        &self.uses
    }

    /// The value for these values of the parameters; true is 1, false is 0.
    ///
    /// # Errors
    /// The result of a step is not finite, or a parameter has no value.
    pub fn value(&self, of: &dyn Fn(usize) -> Option<Value>) -> Result<f64, ExpressionFault> {
        // The last value stands beside the others: a formula of one step needs no stack.
        let (mut stack, mut last): (Vec<f64>, Option<f64>) = (Vec::new(), None);
        for &(step, offset) in &self.steps {
            stack.extend(last);
            let missing = |row: usize| ExpressionFault {
                offset,
                message: format!("{} has no value here", self.name(row)),
                unknown: None,
            };
            let mut take = || stack.pop().unwrap_or(f64::NAN);
            let value = match step {
                Step::Number(x) => x,
                Step::Parameter(row) => of(row)
                    .and_then(Value::as_f64)
                    .ok_or_else(|| missing(row))?,
                Step::Is(row, name) => {
                    let is = of(row).ok_or_else(|| missing(row))? == Value::Name(name);
                    f64::from(u8::from(is))
                }
                Step::One(function) => function(take()),
                Step::Two(function) => {
                    let right = take();
                    function(take(), right)
                }
            };
            if !value.is_finite() {
                let message = format!("must be finite, got {value}");
                return Err(ExpressionFault {
                    offset,
                    message,
                    unknown: None,
                });
            }
            last = Some(value);
        }
        Ok(last.unwrap_or(f64::NAN))
    }
}
