//! Parameter studies of friction and impact models in time-history analysis.

pub mod batch;
pub mod checks;
pub mod error;
pub mod exact;
pub mod figures;
pub mod history;
pub mod lane;
pub mod law;
pub mod metrics;
pub mod problem;
pub mod stepper;
pub mod structure;
pub mod study;
pub mod textbook;
