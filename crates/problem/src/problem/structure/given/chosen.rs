//! A name that a parameter may choose.

use crate::problem::Case;

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
