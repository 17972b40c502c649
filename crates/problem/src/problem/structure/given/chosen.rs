//! What parameters may choose.

use crate::problem::Case;
use crate::problem::numbers::parameter::Value;

/// A name that is the same in all cases, or that a parameter chooses.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Chosen {
    /// The name.
    Name(&'static str),
    /// Row of the parameter.
    Parameter(usize),
}

impl Chosen {
    /// The name in a case; empty if the parameter has none.
    pub fn name(self, case: &Case) -> &'static str {
        match self {
            Chosen::Name(name) => name,
            Chosen::Parameter(row) => case.name_at(row),
        }
    }
}

/// The place of what a case chooses by the values of the parameters in these rows.
pub fn place<T>(rows: &[usize], choices: &[(Vec<Value>, T)], case: &Case) -> Option<usize> {
    choices.iter().position(|(values, _)| {
        let mut chosen = rows.iter().zip(values);
        chosen.all(|(row, value)| case.values[*row] == Some(*value))
    })
}
