//! Cases as columns, and the schema of a problem.

pub(crate) mod case;
pub mod cases;
pub(in crate::problem) mod metric_rows;
pub(crate) mod parameter_column;
pub mod schema;
pub(crate) mod solution;
