//! The text of a study: reading, parsing with the place of every key and value, and reporting faults.

pub(crate) mod faults;
pub(super) mod hint;
pub(crate) mod input;
pub(super) mod number;
pub(crate) mod object;
pub(crate) mod place;
pub(super) mod plain;
pub(super) mod setting;
pub(crate) mod tree;
