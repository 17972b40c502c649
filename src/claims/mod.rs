//! The statements of the papers and of the literature, tested by computation: each claim of a ledger by the cases of its studies.

mod judge;
pub mod ledger;
mod page;
mod within;

pub use page::{Judged, condition, page};
pub use within::NEAR;

use crate::batch;
use crate::batch::store::{STORE, Store};
use indicatif::ProgressBar;
use ledger::{Claim, Ledger};
use slipgap_study::error::Error;
use std::path::Path;

/// The result of testing a claim.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// The claim holds in every reading tested.
    Holds,
    /// It holds in some of them.
    HoldsIf,
    /// It holds in none.
    Fails,
}

impl Verdict {
    /// The verdict from those of the readings.
    pub fn of(readings: impl Iterator<Item = bool>) -> Verdict {
        let (mut yes, mut no) = (false, false);
        for holds in readings {
            yes |= holds;
            no |= !holds;
        }
        match (yes, no) {
            (true, false) => Verdict::Holds,
            (true, true) => Verdict::HoldsIf,
            (false, _) => Verdict::Fails,
        }
    }

    /// The verdict as text.
    pub fn as_str(self) -> &'static str {
        match self {
            Verdict::Holds => "holds",
            Verdict::HoldsIf => "holds if",
            Verdict::Fails => "fails",
        }
    }
}

/// The store of a folder of results; none without results, or while another command uses it.
fn store(results: &Path) -> Result<Option<Store>, Error> {
    if !results.join(STORE).is_dir() {
        return Ok(None);
    }
    match Store::open(results) {
        Err(Error::Busy(_)) => Ok(None),
        opened => opened.map(Some),
    }
}

/// The computed result of a reading.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// Whether it holds.
    pub holds: bool,
    /// The values found for each expectation, in Markdown.
    pub found: Vec<String>,
    /// The values of the expectations that are so near their limits that limits moved by `NEAR` change the verdict.
    pub near: Vec<String>,
}

/// Tests every claim of a ledger, reading by reading. Each study is run once. Cases in the store of its folder in `out` are not
/// computed again.
///
/// # Errors
/// Of the store, and internal ones. An expectation of a case without a solution does not hold.
pub fn compute(ledger: &Ledger, out: &Path, bar: &ProgressBar) -> Result<Vec<Vec<Finding>>, Error> {
    let mut outcomes = Vec::new();
    for ledger_study in &ledger.studies {
        let store = store(&out.join(&ledger_study.name))?;
        outcomes.push(batch::all(&ledger_study.study, store.as_ref(), bar)?);
    }
    let claim = |claim: &Claim| {
        let readings = claim.readings.iter();
        let findings = readings.map(|reading| {
            let study = &ledger.studies[reading.study].study;
            judge::reading(study, &outcomes[reading.study], reading)
        });
        findings.collect()
    };
    Ok(ledger.claims.iter().map(claim).collect())
}
