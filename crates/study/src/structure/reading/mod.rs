//! What all parts of a structure are read with.

pub(super) mod along;
pub(super) mod files;
pub(crate) mod given;
pub(super) mod reader;
