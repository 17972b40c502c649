//! The text of a study: reading, parsing with the place of every key and value, and reporting faults.

pub mod faults;
pub mod field;
pub mod folder;
pub(super) mod hint;
pub mod input;
pub mod object;
pub mod place;
pub mod search;
pub(super) mod setting;
pub mod tree;
