//! What is refused before a case is solved.

pub(crate) mod case_rules;
pub(crate) mod memory;
pub(crate) mod negative;
