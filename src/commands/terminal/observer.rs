//! Shows a run on the terminal.

use super::{note, progress};
use indicatif::ProgressBar;
use slipgap::batch::work_progress::WorkProgress;
use slipgap::run::{Observer, Source};
use std::sync::Arc;

/// Number of cases from which the indices of a design take seconds.
const MANY: u64 = 100_000;

/// Progress bars, and notes on stderr.
pub struct Terminal;

impl Observer for Terminal {
    fn begin_cases(&mut self, source: &Source) -> (ProgressBar, Arc<WorkProgress>) {
        progress::bar_with_store(&source.name, &source.study)
    }

    fn end_cases(&mut self, source: &Source, bar: &ProgressBar, summary: &str) {
        progress::finish(bar, &source.name, summary);
    }

    fn begin_indices(&mut self, source: &Source, estimates: usize) -> ProgressBar {
        let long = source.study.len() >= MANY;
        progress::steps(&source.name, "estimating Sobol' indices", estimates, long)
    }

    fn note(&mut self, line: &str) {
        note(line);
    }
}
