//! The claims of `slipgap_validation`, tested by cases that are run here or are in a store.

pub use slipgap_validation::*;

use crate::batch;
use crate::batch::files::place::is_folder;
use crate::batch::store::{STORE, Store};
use indicatif::ProgressBar;
use ledger::{Ledger, LedgerStudy};
use slipgap_study::CaseMetrics;
use slipgap_study::error::Error;
use std::path::Path;

/// The store of a folder of results; none without results, or while another command uses it.
fn store(results: &Path) -> Result<Option<Store>, Error> {
    if !is_folder(&results.join(STORE)) {
        return Ok(None);
    }
    match Store::open(results) {
        Err(Error::Busy(_)) => Ok(None),
        opened => opened.map(Some),
    }
}

/// Tests every claim of a ledger, reading by reading. Each study is run once. Cases in the store of its folder in `out` are not
/// computed again.
///
/// # Errors
/// Of the store, and internal ones. An expectation of a case without a solution does not hold.
pub fn compute(ledger: &Ledger, out: &Path, bar: &ProgressBar) -> Result<Vec<Vec<Finding>>, Error> {
    judged(ledger, |ledger_study: &LedgerStudy| {
        let store = store(&out.join(&ledger_study.name))?;
        let outcomes = batch::all(&ledger_study.study, store.as_ref(), bar)?.into_iter();
        let results = outcomes.map(|outcome| CaseMetrics {
            case: outcome.case,
            metrics: outcome.metrics,
        });
        Ok(results.collect())
    })
}
