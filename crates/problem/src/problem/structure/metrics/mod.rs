//! Metrics: reductions of channels to numbers, with their texts and units.

pub mod against_measured;
pub(crate) mod computed_ground;
pub mod function;
pub mod ground_metric;
pub mod metric;
pub(crate) mod metric_text;
pub mod pieces;
pub mod reduction;
pub(crate) mod title;
pub mod unit_consistency;
pub mod unit_names;
pub mod window;
