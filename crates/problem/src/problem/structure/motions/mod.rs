//! The motions of a case, and the values of its metrics.

pub(super) mod compared;
pub(crate) mod derived;
pub(crate) mod exact_motion;
mod in_tests;
pub(crate) mod measured_metrics;
pub(crate) mod metric_values;
pub(crate) mod motion;
pub(crate) mod observer;
pub(crate) mod recorded;
pub(crate) mod solve;
pub(crate) mod still;
pub(crate) mod sweep;
mod terms;
