//! Parameter studies of friction and impact models in time-history analysis.

pub mod error;
pub mod history;
pub mod problem;
pub mod study;
