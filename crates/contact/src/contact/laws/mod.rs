//! The laws. Each is one file, or one folder.

pub mod friction;
pub mod impact;
pub mod link;
mod shared;
pub mod yielding;
