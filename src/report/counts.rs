//! How many cases have no results, or no contact to measure.

use super::text::escape;
use crate::batch::Outcome;
use crate::study::Study;
use std::io::{self, Write};

/// Metrics that are undefined only where bars never touch.
const OF_CONTACT: [&str; 3] = ["max_overlap", "peak_force", "restitution"];

/// Cases, counted as they come.
#[derive(Debug)]
pub struct Counts {
    cases: u64,
    unsolved: u64,
    /// Why the first of those could not be solved, with its number.
    first: Option<(u64, String)>,
    untouched: u64,
    /// Place of a metric of contact, if the study has one.
    contact: Option<usize>,
}

impl Counts {
    /// No case yet.
    pub fn new(study: &Study) -> Counts {
        let name = |place: usize| &study.problem.metrics()[place].name;
        let place = |wanted: &str| study.metrics.iter().copied().find(|m| name(*m) == wanted);
        Counts {
            cases: 0,
            unsolved: 0,
            first: None,
            untouched: 0,
            contact: OF_CONTACT.iter().find_map(|wanted| place(wanted)),
        }
    }

    /// Counts the next case.
    pub fn add(&mut self, number: u64, outcome: &Outcome) {
        self.cases += 1;
        if let Some(why) = &outcome.failure {
            self.unsolved += 1;
            self.first.get_or_insert_with(|| (number, why.clone()));
        } else if self.contact.is_some_and(|m| outcome.metrics[m].is_none()) {
            self.untouched += 1;
        }
    }

    /// Writes what there is to say.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        if self.untouched > 0 {
            writeln!(
                out,
                "<p>{} of {} cases have no contact before <code>duration</code>; their contact metrics are undefined.</p>",
                self.untouched, self.cases
            )?;
        }
        if let Some((number, why)) = &self.first {
            writeln!(
                out,
                "<p>{} of {} cases could not be solved; case {number}: {}.</p>",
                self.unsolved,
                self.cases,
                escape(why)
            )?;
        }
        Ok(())
    }
}
