//! The description of study files: the schema for editors, the reference pages, and example studies.

mod figures;
mod pages;
mod reference;
mod schema;
mod start;
mod structure_page;

pub use pages::{problem_pages, problem_reference, reference};
pub use schema::schema;
pub use start::start;
