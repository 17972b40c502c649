//! `slipgap.claims`: the statements of ledgers, tested.

use crate::worker;
use indicatif::ProgressBar;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyType;
use slipgap::batch::programs::allow;
use slipgap::claims::ledger::{self, Ledger};
use slipgap::claims::{Judged, Verdict, compute};
use slipgap::error::Error;
use slipgap::run::files;
use std::path::{Path, PathBuf};

/// The classes `slipgap.Claim` and `slipgap.Reading`.
static CLAIM: PyOnceLock<Py<PyType>> = PyOnceLock::new();
static READING: PyOnceLock<Py<PyType>> = PyOnceLock::new();

/// Tests every claim of a ledger, or of the ledgers in a folder.
#[pyfunction]
#[pyo3(signature = (ledgers, out, jobs, allow_programs))]
pub fn claims(
    py: Python<'_>,
    ledgers: PathBuf,
    out: Option<PathBuf>,
    jobs: Option<i64>,
    allow_programs: bool,
) -> PyResult<Vec<Py<PyAny>>> {
    let jobs = worker::jobs(py, jobs)?;
    let judged = worker::wait(
        py,
        jobs,
        move || judge(&ledgers, out.as_deref(), allow_programs),
        || (),
        |_| Ok(()),
    )?;
    let (claim_class, reading_class) = (
        CLAIM.import(py, "slipgap._records", "Claim")?,
        READING.import(py, "slipgap._records", "Reading")?,
    );
    let mut list = Vec::new();
    for ledger in &judged {
        for (claim, findings) in ledger.claims() {
            let mut readings = Vec::new();
            for (reading, finding) in claim.readings.iter().zip(findings) {
                let fields = (
                    &reading.name,
                    finding.holds,
                    reading.holds,
                    finding.found.clone(),
                );
                readings.push(reading_class.call1(fields)?);
            }
            let verdict = Verdict::of(findings.iter().map(|finding| finding.holds));
            let fields = (
                &ledger.ledger.paper,
                &claim.id,
                &claim.statement,
                verdict.as_str(),
                readings,
            );
            list.push(claim_class.call1(fields)?.unbind());
        }
    }
    Ok(list)
}

/// Computes the studies of the ledgers; cases in the stores of `out` are not computed again.
fn judge(path: &Path, out: Option<&Path>, allow_programs: bool) -> Result<Vec<Judged>, Error> {
    let ledger_files = match path.is_dir() {
        true => files::find(path, "ledgers (*.json)", files::is_json)?,
        false => vec![path.to_owned()],
    };
    let mut ledgers: Vec<Ledger> = files::read_all(ledger_files, |file| ledger::read(&file))?;
    if path.is_dir() && !allow_programs {
        let by_programs = |ledger: &Ledger| {
            let mut studies = ledger.studies.iter();
            studies.any(|named| named.study.programs().is_some())
        };
        ledgers.retain(|ledger| !by_programs(ledger));
    }
    for named in ledgers.iter().flat_map(|ledger| &ledger.studies) {
        allow(&named.file, &named.study, allow_programs)?;
    }
    // A folder without results has no stores.
    let out = out.unwrap_or(Path::new(""));
    let judged = ledgers.into_iter().map(|ledger| {
        let findings = compute(&ledger, out, &ProgressBar::hidden())?;
        Ok(Judged { ledger, findings })
    });
    judged.collect()
}
