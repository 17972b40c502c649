//! Shows a run on the terminal.

use super::studies::Studies;
use super::{note, progress};
use indicatif::ProgressBar;
use slipgap::batch::solve::work_progress::WorkProgress;
use slipgap::run::{Observer, Source};
use std::sync::Arc;

/// Number of cases from which the indices of a design take seconds.
const MANY: u64 = 100_000;

/// Progress bars, and notes on stderr.
pub struct Terminal {
    studies: Studies,
    /// The work of the current study.
    work: Arc<WorkProgress>,
}

impl Terminal {
    /// For a command that runs these studies one after the other.
    pub fn new(sources: &[Source]) -> Terminal {
        Terminal {
            studies: Studies::new(sources),
            work: Arc::new(WorkProgress::new(0.0)),
        }
    }

    /// The next study is left out.
    pub fn skip(&mut self, source: &Source) {
        self.studies.skip(source);
    }
}

impl Observer for Terminal {
    fn begin_cases(&mut self, source: &Source) -> (ProgressBar, Arc<WorkProgress>) {
        self.studies.begin(source);
        let (studies, study) = (&self.studies, &source.study);
        let all = studies.estimate().map(|all| (all, studies.outputs()));
        let (bar, work) = progress::bar_with_store(&studies.name(source), study, all);
        self.work = work.clone();
        (bar, work)
    }

    fn end_cases(&mut self, source: &Source, bar: &ProgressBar, summary: &str) {
        self.studies.end_cases(&self.work);
        let left = match bar.is_hidden() {
            true => self.studies.estimate_for_log(),
            false => None,
        };
        let left = left.map_or(String::new(), |left| format!("; {left} left"));
        progress::finish(
            bar,
            &self.studies.name(source),
            &(summary.to_owned() + &left),
        );
    }

    fn begin_indices(&mut self, source: &Source, estimates: usize) -> ProgressBar {
        let long = source.study.len() >= MANY;
        progress::steps(
            &self.studies.name(source),
            "estimating Sobol' indices",
            estimates,
            long,
        )
    }

    fn begin_figures(&mut self, source: &Source, figures: usize) -> ProgressBar {
        progress::figures(&self.studies.name(source), figures, self.studies.estimate())
    }

    fn note(&mut self, line: &str) {
        note(line);
    }
}
