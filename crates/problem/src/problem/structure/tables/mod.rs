//! The schema of a study of structures, its columns, and the rows of matrices that it names.

pub(crate) mod history_columns;
pub mod named_rows;
pub mod schema;
