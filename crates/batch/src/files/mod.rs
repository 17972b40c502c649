//! Files that are complete or absent, and their locks, in folders and in object stores.

pub mod atomic;
pub mod heartbeat;
pub(super) mod locks;
#[cfg_attr(not(feature = "object-store"), path = "no_objects.rs")]
mod objects;
pub mod place;
