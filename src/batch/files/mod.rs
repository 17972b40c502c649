//! Files that are complete or absent, and their locks.

pub mod atomic;
pub(super) mod locks;
