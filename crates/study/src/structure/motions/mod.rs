//! Motions of the ground and of supports, and loads: functions of time.

pub(super) mod loads;
pub(super) mod records;
pub(super) mod shape;
pub(super) mod supports;
pub(super) mod table;
