//! Numbers of cases without a solution, and warnings and notes.

use super::text::{code, escape};
use slipgap_batch::solve::divergence::{self, Divergence};
use slipgap_batch::{Outcome, WarnedCases};
use slipgap_motion::solve::Unsolvable;
use slipgap_study::Study;
use std::io::{self, Write};

/// The numbers of cases so far.
#[derive(Debug, Default)]
pub struct Counts {
    cases: u64,
    unsolved: u64,
    /// The first case that could not be solved, and why.
    first_unsolved: Option<(u64, Unsolvable)>,
    /// The cases that diverge, by metrics that say it.
    divergence: Divergence,
    /// What was done to input files.
    notes: Vec<String>,
    /// The warnings, when all cases are counted.
    pub warnings: Vec<WarnedCases>,
}

impl Counts {
    /// No case yet.
    pub fn new(study: &Study) -> Counts {
        Counts {
            notes: study.notes(),
            ..Counts::default()
        }
    }

    /// Counts the next case.
    pub fn add(&mut self, study: &Study, number: u64, outcome: &Outcome) {
        self.cases += 1;
        let problem = &study.problem;
        let metrics = &outcome.metrics[..problem.metrics().len()];
        let solved = outcome.failure.is_none();
        let diverges = solved
            .then(|| {
                problem
                    .as_structure()
                    .and_then(|structure| structure.diverges_by(metrics))
            })
            .flatten();
        self.divergence.add(diverges);
        if let Some(why) = &outcome.failure {
            self.unsolved += 1;
            self.first_unsolved
                .get_or_insert_with(|| (number, why.clone()));
        }
    }

    /// Looks for cases that diverge, if no metric of the study says which do.
    pub fn look_for_divergence(&mut self, study: &Study) {
        if self.divergence.looked_at == 0 {
            self.divergence = divergence::sampled(study).unwrap_or_default();
        }
    }

    /// Number of cases without a solution.
    pub fn unsolved(&self) -> u64 {
        self.unsolved
    }

    /// Writes the numbers that are not 0.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        for note in &self.notes {
            writeln!(out, "<p>Note: {}.</p>", escape(note))?;
        }
        for warning in &self.warnings {
            let [sentence, example] = [warning.sentence(), warning.example()];
            let (word, kind, example) = (warning.word(), warning.kind.name(), escape(&example));
            writeln!(
                out,
                "<p>{}.</p>\n<p class=\"facts\">{word} {kind}; {example}</p>",
                code(&escape(&sentence))
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
