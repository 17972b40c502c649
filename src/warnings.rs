//! The warnings of a study, collected part by part: those of its cases, and checks that are not met. What is a result in some cases
//! is a warning only if all cases have it, and else a note or nothing.

use crate::batch::{PartResult, WarnedCases, WarningCounts};
use crate::checks::{self, ReducedChecks};
use slipgap_motion::solve::Warning;
use slipgap_study::Study;
use std::collections::BTreeSet;

/// The warnings of the cases so far.
#[derive(Debug)]
pub struct StudyWarnings<'a> {
    study: &'a Study,
    cases: u64,
    /// Those without a solution, which have no warnings.
    unsolved: u64,
    counts: WarningCounts,
    reduced: ReducedChecks<'a>,
    /// Cases with a check that is not met.
    not_met: BTreeSet<u64>,
}

impl<'a> StudyWarnings<'a> {
    /// No case yet.
    pub fn new(study: &'a Study) -> StudyWarnings<'a> {
        StudyWarnings {
            study,
            cases: 0,
            unsolved: 0,
            counts: WarningCounts::default(),
            reduced: ReducedChecks::new(study),
            not_met: BTreeSet::new(),
        }
    }

    /// Adds the cases of a part, computed or from the store.
    pub fn add(&mut self, part: &PartResult) {
        self.cases += part.len() as u64;
        self.unsolved += part.metrics.failures().count() as u64;
        for (row, warnings) in part.metrics.warned() {
            let number = part.number(row);
            warnings
                .iter()
                .for_each(|kind| self.counts.add(kind, number));
        }
        let (study, not_met) = (self.study, &mut self.not_met);
        self.reduced.add_part(part, &mut |number, check, value| {
            if !checks::is_met(study, check, value) {
                not_met.insert(number);
            }
        });
    }

    /// The warnings, after all parts.
    pub fn list(mut self) -> Vec<WarnedCases> {
        for (check, case, value) in self.reduced.values() {
            if !checks::is_met(self.study, check, value) {
                self.not_met.insert(case);
            }
        }
        for case in &self.not_met {
            self.counts.add(Warning::CheckNotMet, *case);
        }
        let mut warnings = self.counts.list(self.study, self.cases);
        let solved = self.cases - self.unsolved;
        for warning in warnings
            .iter_mut()
            .filter(|warning| warning.kind.is_of_all_cases())
        {
            warning.is_note = warning.cases != solved;
        }
        // What slides, yields or pulls in some cases needs no word; how many cases have no contact is always said.
        let is_said = |kind: Warning| !kind.is_of_all_cases() || kind == Warning::NoContact;
        warnings.retain(|warning| !warning.is_note || is_said(warning.kind));
        warnings
    }
}
