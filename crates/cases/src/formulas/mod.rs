//! Parameters given by expressions, and conditions.

pub mod derived;
pub mod formula_table;
