//! What a study names: parameters, labels, metrics and channels.

pub(super) mod amounts;
pub(crate) mod free_names;
pub(super) mod labels;
pub(super) mod named_metrics;
pub(crate) mod names;
pub(crate) mod shown;
pub(super) mod units;
