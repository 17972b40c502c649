//! The cases of parts, solved or taken from the store; what they cost.

pub(super) mod compute;
pub(super) mod computed;
pub mod cost;
pub mod divergence;
pub(super) mod missing;
pub(super) mod options;
pub(super) mod part_result;
pub(super) mod run_part;
pub(super) mod run_shard;
pub(super) mod signal_order;
pub(super) mod warned;
pub mod work_progress;
