//! Computes the parts of a shard.

use super::compute;
use super::run_part::{KeptPart, keep_part};
use super::work_progress::WorkProgress;
use crate::chunks::pipeline::in_order;
use crate::chunks::queue::PartQueue;
use crate::chunks::shard::Shard;
use crate::files::heartbeat::Heartbeat;
use crate::programs;
use crate::store::Store;
use indicatif::ProgressBar;
use slipgap_study::Study;
use slipgap_study::error::Error;
use std::sync::Arc;

/// What a shard has done. All its parts are in the store.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct ShardResult {
    /// Number of parts of the shard.
    pub parts: u64,
    /// Number of these that were computed; the others were in the store.
    pub computed: u64,
    /// Number of cases in the computed parts that could not be solved.
    pub unsolved: u64,
}

/// Computes the parts of a shard that the store does not have, and saves them.
///
/// # Errors
/// The first part that cannot be saved.
pub fn run_shard(
    study: &Study,
    shard: Shard,
    store: &Store,
    bar: &ProgressBar,
) -> Result<ShardResult, Error> {
    compute::keep_memory();
    programs::start(study)?;
    let progress = Arc::new(WorkProgress::new(0.0));
    let shown = progress.clone();
    let _heart = Heartbeat::start(store.folder(), Some(shard), move || shown.computed());
    let queue = PartQueue::of_shard(study, shard);
    let work = |part| keep_part(study, part, bar, store, &progress);
    let mut result = ShardResult::default();
    in_order(study, queue, work, |part: KeptPart| {
        result.parts += 1;
        result.computed += u64::from(part.computed);
        result.unsolved += part.unsolved;
        Ok(())
    })?;
    store.check_kept()?;
    Ok(result)
}
