//! The axes of a block and their values.

pub mod design;
pub mod group;
pub mod spaced;
pub mod values;
