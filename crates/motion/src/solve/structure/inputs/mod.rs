//! Loads, limits and signals at the steps of a run.

pub(crate) mod loads_at_steps;
pub(crate) mod pressing;
pub(crate) mod sampled_signals;
