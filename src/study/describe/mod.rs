//! What a study file may say, for editors and readers: the schema, the page, and studies to begin with.

mod reference;
mod schema;
mod start;
mod values;

pub use reference::reference;
pub use schema::schema;
pub use start::start;
