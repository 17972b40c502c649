//! Cases as columns, and the schema of a problem.

pub(crate) mod case;
pub mod cases;
pub(crate) mod column;
pub mod schema;
pub(crate) mod solution;
