//! Files that are complete or absent, and their locks.

pub mod atomic;
pub mod heartbeat;
pub(super) mod locks;
