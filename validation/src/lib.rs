//! The statements of the papers and of the literature, tested by computation: each claim of a ledger by the cases of its studies.

mod judge;
pub mod ledger;
mod page;
mod within;

pub use page::{Judged, condition, page};
pub use within::NEAR;

use ledger::{Claim, Ledger, LedgerStudy};
use slipgap_study::CaseMetrics;
use slipgap_study::error::Error;

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

/// Tests every claim of a ledger, reading by reading. `cases` gives the results of all cases of a study; it is called once for each.
///
/// # Errors
/// Those of `cases`. An expectation of a case without a solution does not hold.
pub fn judged(
    ledger: &Ledger,
    cases: impl FnMut(&LedgerStudy) -> Result<Vec<CaseMetrics>, Error>,
) -> Result<Vec<Vec<Finding>>, Error> {
    let solved = ledger.studies.iter().map(cases);
    let studies = solved.collect::<Result<Vec<_>, Error>>()?;
    let claim = |claim: &Claim| {
        let readings = claim.readings.iter();
        let findings = readings.map(|reading| {
            let study = &ledger.studies[reading.study].study;
            judge::reading(study, &studies[reading.study], reading)
        });
        findings.collect()
    };
    Ok(ledger.claims.iter().map(claim).collect())
}
