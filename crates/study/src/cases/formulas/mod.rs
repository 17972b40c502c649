//! Parameters given by expressions, and conditions.

pub(crate) mod derived;
pub(crate) mod formula_table;
