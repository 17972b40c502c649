//! The description of study files: the schema for editors, the reference pages, and example studies.

mod figures;
mod reference;
mod schema;
mod start;
mod structure;
mod structure_page;
mod values;

pub use reference::{problem_pages, problem_reference, reference};
pub use schema::schema;
pub use start::start;
