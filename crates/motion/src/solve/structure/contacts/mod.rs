//! The contacts of a structure over a step, and their forces.

pub(crate) mod curved;
mod curved_blocks;
pub(crate) mod curved_contact;
pub(crate) mod curved_group;
pub(crate) mod curved_lanes;
pub(crate) mod curved_link;
mod curved_open;
pub(crate) mod curved_plane;
pub(crate) mod curved_step;
pub(crate) mod forces;
pub(crate) mod in_series;
pub(crate) mod laws;
pub(crate) mod series_newton;
pub(crate) mod series_root;
pub(crate) mod static_friction;
