//! Figures of metrics over parameters and over one another.

pub(super) mod budget;
pub(super) mod convergence;
pub(super) mod envelope;
pub(super) mod front;
pub(super) mod map;
pub(super) mod metric;
pub(super) mod scatter;
