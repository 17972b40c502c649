//! The names and parameters of a method.

use super::{METHODS, Method};
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
    /// Values that a search tries: weak, medium and strong numerical damping. Those at the same place of all parameters of a method
    /// belong together.
    pub tried: &'static [f64],
    /// What it is, in one sentence.
    pub meaning: &'static str,
}

impl Description {
    /// The method of this name.
    pub fn named(name: &str) -> Option<&'static Description> {
        METHODS.iter().find(|method| method.name == name)
    }

    /// The method with the defaults of its parameters.
    pub fn with_defaults(&self) -> Option<Method> {
        let defaults = self.parameters.iter().map(|parameter| parameter.default);
        (self.method)(&defaults.collect::<Vec<f64>>())
    }
}
