//! The contacts of a structure with a law that is not a clipped line.

mod blocks;
pub(crate) mod contact;
pub(crate) mod contacts;
pub(crate) mod group;
pub(crate) mod lanes;
pub(crate) mod link;
mod open;
mod own;
pub(crate) mod plane;
pub(crate) mod step;
