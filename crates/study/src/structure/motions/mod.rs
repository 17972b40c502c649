//! Motions of the ground and of supports, and loads: functions of time.

pub(super) mod ground;
pub(super) mod loads;
mod members;
mod record_keys;
pub(super) mod records;
mod scale_to;
pub(super) mod set;
mod shape;
pub(super) mod supports;
pub(super) mod table;
mod target;
