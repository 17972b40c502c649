//! The laws. Each is one file, or one folder.

pub(super) mod friction;
pub mod impact;
pub(super) mod link;
mod shared;
pub(super) mod yielding;
