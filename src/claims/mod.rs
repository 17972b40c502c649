//! The papers' sentences, judged by computation: each claim of a ledger against the cases of the studies that settle it.

mod judge;
pub mod ledger;
mod page;

pub use page::{Judged, page};

use crate::batch;
use crate::error::Error;
use indicatif::ProgressBar;
use ledger::{Claim, Ledger};

/// What a claim comes to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// In every reading tried.
    Holds,
    /// In some of them.
    HoldsIf,
    /// In none.
    Fails,
}

impl Verdict {
    /// From the readings' own verdicts.
    pub fn of(readings: impl Iterator<Item = bool>) -> Verdict {
        let (mut yes, mut no) = (false, false);
        for holds in readings {
            yes |= holds;
            no |= !holds;
        }
        match (yes, no) {
            (true, false) => Verdict::Holds,
            (true, true) => Verdict::HoldsIf,
            _ => Verdict::Fails,
        }
    }

    /// In words.
    pub fn said(self) -> &'static str {
        match self {
            Verdict::Holds => "holds",
            Verdict::HoldsIf => "holds if",
            Verdict::Fails => "fails",
        }
    }
}

/// What a reading came to, computed now.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// Whether it holds.
    pub holds: bool,
    /// What was found, expectation by expectation, in Markdown.
    pub found: Vec<String>,
}

/// Computes every claim of a ledger, reading by reading; each of its studies is run once.
///
/// # Errors
/// A case without a solution is none: what looks at it does not hold.
pub fn compute(ledger: &Ledger, bar: &ProgressBar) -> Result<Vec<Vec<Finding>>, Error> {
    let mut outcomes = Vec::new();
    for settling in &ledger.studies {
        outcomes.push(batch::all(&settling.study, bar)?);
    }
    let claim = |claim: &Claim| {
        let readings = claim.readings.iter();
        let judged = readings.map(|reading| {
            let study = &ledger.studies[reading.study].study;
            judge::reading(study, &outcomes[reading.study], reading)
        });
        judged.collect()
    };
    Ok(ledger.claims.iter().map(claim).collect())
}
