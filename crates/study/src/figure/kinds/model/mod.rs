//! Figures of the model itself.

pub(super) mod law;
pub(super) mod scheme;
