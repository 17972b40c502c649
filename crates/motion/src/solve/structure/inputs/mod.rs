//! Loads, limits and signals at the steps of a run.

pub(crate) mod loads;
pub(crate) mod pressing;
pub(crate) mod samples;
