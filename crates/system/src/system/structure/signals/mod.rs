//! Functions of time, and motions of supports.

pub(crate) mod baseline;
mod displaced;
pub(crate) mod mean;
pub(crate) mod motion_pieces;
pub(crate) mod signal;
pub(crate) mod support_motion;
