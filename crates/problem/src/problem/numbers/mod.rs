//! Parameters with their units, and formulas of them.

pub mod allowed;
pub(crate) mod choice;
pub mod parameter;
pub(crate) mod short;
pub(crate) mod text;
pub mod unit;
