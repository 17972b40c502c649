//! Runs the cases of a study in parallel. No result depends on the order or on the number of threads.

pub mod checks;
pub mod chunks;
pub mod compare;
pub mod files;
pub mod output;
pub mod programs;
pub mod solve;
pub mod status;
pub mod store;
pub mod study_figures;
#[cfg(test)]
mod tests;

pub use chunks::shard::{Shard, ShardFault, shard_of};
pub use slipgap_figures::{DrawnCase, GroupResults, Needed, ShownCases, groups};
pub use solve::compute::keep_memory;
pub use solve::computed::with_computed_columns;
pub use solve::missing::{MissingParts, missing_parts};
pub use solve::options::{OnSolution, RunOptions};
pub use solve::part_result::{Outcome, PartResult};
pub use solve::run_shard::{ShardResult, run_shard};
pub use solve::warned::{WarnedCases, WarningCounts};

use chunks::pipeline::in_order;
use chunks::queue::PartQueue;
use indicatif::ProgressBar;
use slipgap_study::Study;
use slipgap_study::error::Error;
use solve::run_part::run_part;
use store::Store;

/// Runs every case, part by part. `take` receives the parts in order, each as soon as it and all parts before it are
/// finished. An error of `take` ends the run.
///
/// A ratio to a reference case needs the results of all cases: `take` then receives the parts after the last one.
///
/// # Errors
/// The first of `on_solution`, of the store or of `take`.
pub fn run(
    study: &Study,
    bar: &ProgressBar,
    options: &RunOptions,
    mut take: impl FnMut(PartResult) -> Result<(), Error>,
) -> Result<(), Error> {
    if !study.has_ratios() {
        return run_parts(study, bar, options, take);
    }
    let mut parts = Vec::new();
    run_parts(study, bar, options, |part| {
        parts.push(part);
        Ok(())
    })?;
    solve::computed::add_ratios(study, &mut parts);
    parts.into_iter().try_for_each(&mut take)
}

/// Runs every case, part by part, without ratios.
fn run_parts(
    study: &Study,
    bar: &ProgressBar,
    options: &RunOptions,
    take: impl FnMut(PartResult) -> Result<(), Error>,
) -> Result<(), Error> {
    keep_memory();
    programs::start(study)?;
    if let (Some(programs), Some(_)) = (study.programs(), options.on_solution) {
        programs.ask_for_all();
    }
    let work = |part| run_part(study, part, bar, options);
    in_order(study, PartQueue::new(study), work, take)
}

/// The outcomes of all cases at once, for small studies. Cases in a store are not computed again.
///
/// # Errors
/// The first of the store.
pub fn all(study: &Study, store: Option<&Store>, bar: &ProgressBar) -> Result<Vec<Outcome>, Error> {
    let options = RunOptions {
        store,
        ..RunOptions::METRICS
    };
    let mut outcomes = Vec::new();
    run(study, bar, &options, |part| {
        let numbered = part.outcomes(study).into_iter();
        outcomes.extend(numbered.map(|(_, outcome)| outcome));
        Ok(())
    })?;
    Ok(outcomes)
}
