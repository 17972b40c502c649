//! The axes of a block and their values.

pub(crate) mod design;
pub(crate) mod group;
pub(crate) mod values;
