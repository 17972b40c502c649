//! Numbers of a structure that may depend on the parameters of a case.

use crate::problem::numbers::parameter::{Range, shortest};
use crate::problem::{Case, ParameterExpression, Violation};
use std::sync::Arc;

/// A number of a structure, with its place in the study.
#[derive(Debug, Clone)]
pub struct Amount {
    /// The number or its expression.
    pub source: Source,
    /// The values allowed.
    pub range: Range,
    /// Byte offset of the value in the study.
    pub at: usize,
    /// Path of the value, such as `structure.bars.g1.EA`.
    pub path: String,
}

/// Where a number comes from.
#[derive(Debug, Clone)]
pub enum Source {
    /// The same in all cases.
    Number(f64),
    /// An expression of parameters.
    Expression(Arc<ParameterExpression>),
}

impl Amount {
    /// The value in a case.
    pub fn value(&self, case: &Case) -> Result<f64, Violation> {
        match &self.source {
            Source::Number(x) => Ok(*x),
            Source::Expression(expression) => {
                let x = expression
                    .value(case)
                    .map_err(|why| self.violation(why.to_string()))?;
                if self.range.contains(x) {
                    return Ok(x);
                }
                let (range, text, x) = (self.range, &expression.text, shortest(x));
                Err(self.violation(format!("must be {range}, got \"{text}\" = {x}")))
            }
        }
    }

    /// The value, if it is the same in all cases.
    pub fn constant(&self) -> Option<f64> {
        match &self.source {
            Source::Number(x) => Some(*x),
            Source::Expression(_) => None,
        }
    }

    /// The value as a whole number from `least` to `most`.
    pub fn whole(&self, case: &Case, least: u32, most: u32) -> Result<u32, Violation> {
        self.as_whole(self.value(case)?, least, most)
    }

    /// A value as a whole number from `least` to `most`.
    pub fn as_whole(&self, x: f64, least: u32, most: u32) -> Result<u32, Violation> {
        let whole = x.round();
        let near = (x - whole).abs() <= 1e-9 * whole.abs();
        if near && whole >= f64::from(least) && whole <= f64::from(most) {
            return Ok(whole as u32);
        }
        let x = shortest(x);
        Err(self.violation(format!(
            "must be a whole number from {least} to {most}, got {x}"
        )))
    }

    /// A rule that the value breaks.
    pub fn violation(&self, message: impl Into<String>) -> Violation {
        Violation {
            parameter: self.path.clone().into(),
            message: message.into(),
            at: Some(self.at),
        }
    }
}
