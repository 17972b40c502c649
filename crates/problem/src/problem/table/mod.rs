//! Cases as columns, and the schema of a problem.

pub(crate) mod case;
pub mod cases;
pub(crate) mod column;
pub(in crate::problem) mod metric_rows;
pub mod schema;
pub(crate) mod solution;
