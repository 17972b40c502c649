//! The parts of a structure as a study describes them.

pub mod along;
pub mod contact;
pub mod contact_law;
pub mod damping;
pub mod listed;
pub(crate) mod models;
pub mod reduce;
pub mod template;
