//! What the program says about itself: the schema of its studies, completions for shells, manual pages.

pub mod completions;
pub mod man;
pub mod schema;
