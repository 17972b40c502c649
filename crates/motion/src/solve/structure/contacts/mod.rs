//! The contacts of a structure over a step, and their forces.

pub(crate) mod curved;
pub(crate) mod forces;
pub(crate) mod in_series;
pub(crate) mod laws;
pub(crate) mod series_newton;
pub(crate) mod series_root;
pub(crate) mod static_fault;
pub(crate) mod static_friction;
pub(crate) mod static_in_plane;
