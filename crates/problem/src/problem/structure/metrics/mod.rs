//! Metrics: reductions of channels to numbers, with their texts and units.

pub mod against_measured;
pub(crate) mod computed_ground;
pub mod function;
pub mod ground;
pub mod metric;
pub mod pieces;
pub mod reduction;
pub(crate) mod text;
pub(crate) mod title;
pub mod unit_consistency;
pub mod units;
pub mod window;
