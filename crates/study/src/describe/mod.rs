//! The description of study files: the schema for editors, the reference page, and example studies.

mod reference;
mod schema;
mod start;
mod structure;
mod values;

pub use reference::reference;
pub use schema::schema;
pub use start::start;
