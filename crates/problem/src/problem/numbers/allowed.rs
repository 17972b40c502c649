//! A number as a value of a parameter.

use super::parameter::{Kind, Parameter, Value};
use std::fmt;

/// Relative difference below which a number counts as a whole number: 10/0.1 is 100.
const WHOLE: f64 = 1e-9;

/// That a number is no value of a parameter. Displayed as what the parameter allows.
#[derive(Debug, Clone, Copy)]
pub struct NotAllowed<'a>(&'a Parameter);

impl fmt::Display for NotAllowed<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0.kind {
            Kind::Number(range) => write!(f, "{range}"),
            Kind::Whole { min, max } => write!(f, "a whole number from {min} to {max}"),
            Kind::Choice(_) => f.write_str("a name"),
        }
    }
}

impl std::error::Error for NotAllowed<'_> {}

/// A number as a value of a parameter.
///
/// # Errors
/// The parameter does not allow it.
pub fn value_of(x: f64, parameter: &Parameter) -> Result<Value, NotAllowed<'_>> {
    let refused = Err(NotAllowed(parameter));
    match parameter.kind {
        Kind::Number(range) if range.contains(x) => Ok(Value::Number(x)),
        Kind::Number(_) => refused,
        Kind::Whole { min, max } => {
            let whole = x.round();
            let near = (x - whole).abs() <= WHOLE * whole.abs();
            if near && whole >= min as f64 && whole <= max as f64 {
                return Ok(Value::Whole(whole as u64));
            }
            refused
        }
        Kind::Choice(_) => refused,
    }
}
