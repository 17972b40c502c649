//! Shows a run on the terminal.

use super::metrics::Metrics;
use super::studies::Studies;
use super::summary::Summary;
use super::{line, note, progress};
use crate::batch::solve::work_progress::WorkProgress;
use crate::batch::{PartResult, WarnedCases};
use crate::run::{Observer, Source};
use indicatif::ProgressBar;
use std::io::{IsTerminal, stderr};
use std::sync::Arc;

/// Number of cases from which the indices of a design take seconds.
const MANY: u64 = 100_000;

/// Progress bars, and notes on stderr.
pub struct Terminal {
    studies: Studies,
    /// The work of the current study.
    work: Arc<WorkProgress>,
    /// Those of the current study, which are shown to a person.
    metrics: Metrics,
    summary: Summary,
}

impl Terminal {
    /// For a command that runs these studies one after the other.
    pub fn new(sources: &[Source]) -> Terminal {
        Terminal {
            studies: Studies::new(sources),
            work: Arc::new(WorkProgress::new(0.0)),
            metrics: Metrics::default(),
            summary: Summary::new(sources.len()),
        }
    }

    /// All studies are finished, or one of them ends the command.
    pub fn end(&self) {
        self.summary.print();
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
        let rest = studies
            .estimate()
            .map(|estimate| (estimate, studies.outputs()));
        let (bar, work) = progress::bar_with_store(&studies.name(source), study, rest);
        self.work = work.clone();
        self.metrics = match stderr().is_terminal() {
            true => Metrics::of(source),
            false => Metrics::default(),
        };
        (bar, work)
    }

    fn part(&mut self, part: &PartResult) {
        self.metrics.add(part);
    }

    fn end_cases(&mut self, source: &Source, bar: &ProgressBar, summary: &str) {
        self.studies.end_cases(&self.work);
        let estimate = match bar.is_hidden() {
            true => self.studies.estimate_for_log(),
            false => None,
        };
        let left = estimate.map_or(String::new(), |left| format!("; {left} left"));
        progress::finish(
            bar,
            &self.studies.name(source),
            &(summary.to_owned() + &left),
        );
        let table = self.metrics.text();
        table.lines().for_each(line);
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

    fn note(&mut self, text: &str) {
        note(text);
    }

    fn results(&mut self, source: &Source, warnings: &[WarnedCases]) {
        self.summary.add(source, warnings);
    }
}
