//! Functions of time, and motions of supports.

pub(crate) mod baseline;
mod displaced;
pub(crate) mod mean;
pub(crate) mod motion;
pub(crate) mod motion_pieces;
pub(crate) mod signal;
