//! `slipgap claims`: the papers' sentences with their verdicts, and the page about them.

use super::{NOT_MET, columns, files, note, progress, say};
use slipgap::batch::output::Folder;
use slipgap::claims::ledger::{self, Ledger};
use slipgap::claims::{self, Judged, Verdict};
use slipgap::error::Error;
use std::path::{Path, PathBuf};

/// Name of the page.
const PAGE: &str = "claims.md";

/// Judges the ledgers, prints them and writes the page into `out`; gives the exit code.
pub fn claims(named: &[PathBuf], out: &Path) -> Result<u8, Error> {
    let ledgers = read(named)?;
    let mut folder = Folder::open(out)?;
    let mut all = Vec::new();
    for ledger in ledgers {
        let cases = ledger.studies.iter().map(|s| s.study.len()).sum();
        let bar = progress::bar(&ledger.paper, cases);
        let findings = claims::compute(&ledger, &bar)?;
        progress::finish(&bar, &ledger.paper, &progress::run(cases));
        all.push(Judged { ledger, findings });
    }
    let path = folder.write(PAGE, claims::page(&all).as_bytes())?;
    let mut rows = vec![
        ["claim", "verdict", "", "statement"]
            .map(String::from)
            .to_vec(),
    ];
    for (claim, findings) in all.iter().flat_map(Judged::claims) {
        let verdict = Verdict::of(findings.iter().map(|f| f.holds));
        let pairs = claim.readings.iter().zip(findings);
        let held = pairs
            .clone()
            .filter(|(_, f)| f.holds)
            .map(|(r, _)| r.name.as_str());
        let changed = pairs.filter(|(r, f)| r.holds != f.holds);
        let changed: Vec<&str> = changed.map(|(r, _)| r.name.as_str()).collect();
        let mut statement = claim.statement.clone();
        if verdict == Verdict::HoldsIf {
            let held: Vec<&str> = held.collect();
            statement += &format!(" [if: {}]", held.join("; "));
        }
        if !changed.is_empty() {
            statement += &format!(" [changed: {}]", changed.join("; "));
        }
        let mark = if changed.is_empty() { "" } else { "CHANGED" };
        rows.push(vec![
            claim.id.clone(),
            verdict.as_str().into(),
            mark.into(),
            statement,
        ]);
    }
    say(&columns(&rows))?;
    let count = rows.len() - 1;
    let changed: usize = all.iter().map(Judged::changed).sum();
    note(&format!(
        "{count} claims, {changed} with a verdict other than recorded; {}",
        path.display()
    ));
    Ok(if changed > 0 { NOT_MET } else { 0 })
}

/// Reads the ledgers of the files and folders named, in order; every fault of every ledger is reported.
pub fn read(named: &[PathBuf]) -> Result<Vec<Ledger>, Error> {
    let mut files = Vec::new();
    for path in named {
        if !path.is_dir() {
            files.push(path.clone());
            continue;
        }
        files.extend(files::under(path, "ledgers (*.json)", files::is_json)?);
    }
    files::each(files, |file| ledger::read(&file))
}
