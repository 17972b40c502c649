//! Friction in a plane.

mod closed_forms;
mod exact;
mod static_ratio;
