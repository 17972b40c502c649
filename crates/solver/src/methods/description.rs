//! The names and parameters of a method.

use super::Method;
use crate::range::Range;

/// A method as a study names it.
#[derive(Debug)]
pub struct Description {
    /// Its name.
    pub name: &'static str,
    /// What it is, for the schema and the pages.
    pub meaning: &'static str,
    /// Its parameters.
    pub parameters: &'static [MethodParameter],
    /// The method with these numbers, one for each parameter in their order; `None` for another count of numbers.
    pub method: fn(&[f64]) -> Option<Method>,
}

/// A parameter of a method: a number without unit.
#[derive(Debug)]
pub struct MethodParameter {
    /// Its key in a study.
    pub name: &'static str,
    /// How figures write it.
    pub symbol: &'static str,
    /// Its values.
    pub range: Range,
    /// Its value if a study does not give it.
    pub default: f64,
    /// What it is, in one sentence.
    pub meaning: &'static str,
}
