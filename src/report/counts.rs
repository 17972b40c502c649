//! Numbers of cases without a solution or without contact.

use super::text::escape;
use crate::batch::Outcome;
use crate::batch::divergence::{self, Divergence};
use crate::solve::Unsolvable;
use crate::study::Study;
use std::io::{self, Write};

/// The numbers of cases so far.
#[derive(Debug)]
pub struct Counts {
    cases: u64,
    unsolved: u64,
    /// The first case that could not be solved, and why.
    first_unsolved: Option<(u64, Unsolvable)>,
    without_contact: u64,
    /// The cases that diverge, by metrics that say it.
    divergence: Divergence,
    /// Row of the metric that is undefined only in cases without contact, if the problem has one.
    contact_metric: Option<usize>,
    /// Name of the parameter that is the duration.
    duration: String,
    /// What was done to input files.
    note: Option<String>,
}

impl Counts {
    /// No case yet.
    pub fn new(study: &Study) -> Counts {
        let schema = study.problem.schema();
        Counts {
            cases: 0,
            unsolved: 0,
            first_unsolved: None,
            without_contact: 0,
            divergence: Divergence::default(),
            contact_metric: schema.contact_metric,
            duration: schema.parameters[schema.duration].name.to_string(),
            note: study.problem.note().map(str::to_owned),
        }
    }

    /// Counts the next case.
    pub fn add(&mut self, study: &Study, number: u64, outcome: &Outcome) {
        self.cases += 1;
        let problem = &study.problem;
        let metrics = &outcome.metrics[..problem.metrics().len()];
        let solved = outcome.failure.is_none();
        let diverges = solved.then(|| problem.diverges_by(metrics)).flatten();
        self.divergence.add(diverges);
        if let Some(why) = &outcome.failure {
            self.unsolved += 1;
            self.first_unsolved
                .get_or_insert_with(|| (number, why.clone()));
        } else if self
            .contact_metric
            .is_some_and(|row| outcome.metrics[row].is_none())
        {
            self.without_contact += 1;
        }
    }

    /// Looks for cases that diverge, if no metric of the study says which do.
    pub fn look_for_divergence(&mut self, study: &Study) {
        if self.divergence.looked_at == 0 {
            self.divergence = divergence::sampled(study).unwrap_or_default();
        }
    }

    /// Writes the numbers that are not 0.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        if let Some(note) = &self.note {
            writeln!(out, "<p>Note: {}.</p>", escape(note))?;
        }
        if self.without_contact > 0 {
            writeln!(
                out,
                "<p>{} of {} cases have no contact before <code>{}</code>; their contact metrics are undefined.</p>",
                self.without_contact,
                self.cases,
                escape(&self.duration)
            )?;
        }
        if self.divergence.looked_at > 0 {
            let divergence = escape(&self.divergence.to_string());
            writeln!(out, "<p>Divergence: {divergence}.</p>")?;
        }
        if let Some((number, why)) = &self.first_unsolved {
            writeln!(
                out,
                "<p>{} of {} cases could not be solved; case {number}: {}.</p>",
                self.unsolved,
                self.cases,
                escape(&why.to_string())
            )?;
        }
        Ok(())
    }
}
