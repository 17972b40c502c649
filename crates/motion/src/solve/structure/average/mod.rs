//! The constant average acceleration method in increments.

mod curved;
mod lane_contacts;
pub(crate) mod lane_state;
pub(crate) mod moves;
mod once;
mod repeat;
pub(crate) mod step;
