//! What is refused before a case is solved.

pub(crate) mod memory;
pub(crate) mod negative;
pub(crate) mod rules;
