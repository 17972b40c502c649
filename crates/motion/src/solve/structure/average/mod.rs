//! The constant average acceleration method in increments.

mod contact;
pub(crate) mod moves;
mod repeat;
pub(crate) mod state;
pub(crate) mod step;
