//! Friction in a plane.

mod closed_forms;
mod exact;
