//! Parameters with their units and digits, and formulas of them.

pub(crate) mod choice;
pub mod digits;
pub mod parameter;
pub(crate) mod text;
pub mod unit;
