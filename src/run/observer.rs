//! What a run reports while it goes on.

use super::Source;
use crate::batch::solve::work_progress::WorkProgress;
use crate::batch::{PartResult, WarnedCases};
use indicatif::ProgressBar;
use std::sync::Arc;

/// Receives the progress and the notes of a run.
pub trait Observer: Send {
    /// The cases begin: the bar that counts them, and the counter of their work, which can also stop the run.
    fn begin_cases(&mut self, source: &Source) -> (ProgressBar, Arc<WorkProgress>);

    /// The results of a part, in the order of the cases.
    fn part(&mut self, _part: &PartResult) {}

    /// All cases are finished; `summary` says in a line how many were computed.
    fn end_cases(&mut self, source: &Source, bar: &ProgressBar, summary: &str);

    /// The bar that counts the estimates of Sobol' indices.
    fn begin_indices(&mut self, source: &Source, estimates: usize) -> ProgressBar;

    /// The bar that counts the figures.
    fn begin_figures(&mut self, source: &Source, figures: usize) -> ProgressBar;

    /// A line about the results, as about cases without a solution.
    fn note(&mut self, line: &str);

    /// The warnings of all cases. The study has notes on its input, too.
    fn results(&mut self, _source: &Source, _warnings: &[WarnedCases]) {}
}
