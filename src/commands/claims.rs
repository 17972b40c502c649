//! `slipgap claims`: the statements of the papers and of the literature with their verdicts, and the page about them.

use super::NOT_MET;
use super::arguments::{JobsArgs, ProgramsArgs, note_left_out};
use super::terminal::{note, print, progress, table};
use crate::batch::output::Folder;
use crate::claims::ledger::{self, Ledger};
use crate::claims::{self, Judged, Verdict};
use crate::commands::arguments::results_folder;
use crate::error::Error;
use crate::run::{cases_run, files};
use clap::Args;
use std::path::{Path, PathBuf};

/// Name of the page.
const PAGE: &str = "claims.md";

/// The arguments of `slipgap claims`.
#[derive(Args)]
pub struct ClaimsArgs {
    /// Ledgers of claims, or folders of them
    #[arg(value_name = "LEDGER|FOLDER", default_value = "claims")]
    ledgers: Vec<PathBuf>,
    /// Folder for claims.md; files that it names are results of the studies in the same folder
    #[arg(long, value_name = "DIR", default_value = "figures", value_parser = results_folder())]
    out: PathBuf,
    #[command(flatten)]
    jobs: JobsArgs,
    #[command(flatten)]
    programs: ProgramsArgs,
}

impl ClaimsArgs {
    /// Tests the claims; returns the exit code.
    pub fn execute(self) -> Result<u8, Error> {
        let programs = self.programs;
        self.jobs.run(|| claims(&self.ledgers, &self.out, programs))
    }
}

/// Tests the claims of the ledgers, prints the verdicts and writes the page into `out`; returns the exit code.
fn claims(paths: &[PathBuf], out: &Path, programs: ProgramsArgs) -> Result<u8, Error> {
    let ledgers = read(paths, programs)?;
    let mut folder = Folder::open(out)?;
    let mut judged = Vec::new();
    for ledger in ledgers {
        let cases = ledger.studies.iter().map(|s| s.study.len()).sum();
        let bar = progress::bar(&ledger.paper, cases);
        let findings = claims::compute(&ledger, out, &bar)?;
        progress::finish(&bar, &ledger.paper, &cases_run(cases));
        judged.push(Judged { ledger, findings });
    }
    let path = folder.write(PAGE, claims::page(&judged).as_bytes())?;
    let mut rows = vec![
        ["claim", "verdict", "", "statement"]
            .map(String::from)
            .to_vec(),
    ];
    for (claim, findings) in judged.iter().flat_map(Judged::claims) {
        let verdict = Verdict::of(findings.iter().map(|f| f.holds));
        let pairs = claim.readings.iter().zip(findings);
        let differing = pairs.filter(|(r, f)| r.holds != f.holds);
        let changed: Vec<&str> = differing.map(|(r, _)| r.name.as_str()).collect();
        let mut statement = claim.statement.clone();
        if let Some(condition) = claims::condition(claim, findings) {
            statement += &format!(" [if: {condition}]");
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
    print(&table(&rows))?;
    let count = rows.len() - 1;
    let changed: usize = judged.iter().map(Judged::changed).sum();
    let (near, unexplained) = judged
        .iter()
        .map(Judged::near)
        .fold((0, 0), |sum, one| (sum.0 + one.0, sum.1 + one.1));
    note(&format!(
        "readings near a limit: {near}, without a reason or with one that is not needed: {unexplained}"
    ));
    note(&format!(
        "{count} claims, {changed} with a verdict other than recorded; {}",
        path.display()
    ));
    Ok(if changed > 0 { NOT_MET } else { 0 })
}

/// Reads the ledgers in files and folders, in order. All faults of all ledgers are reported.
pub fn read(paths: &[PathBuf], programs: ProgramsArgs) -> Result<Vec<Ledger>, Error> {
    let mut files = Vec::new();
    for path in paths {
        if !path.is_dir() {
            files.push(path.clone());
            continue;
        }
        files.extend(files::find(path, "ledgers (*.json)", files::is_json)?);
    }
    let single = files.len() == 1;
    let ledgers = files::read_all(files, |file| ledger::read(&file))?;
    let may_leave = |ledger: &Ledger| {
        let mut studies = ledger.studies.iter();
        !single && !programs.allow_programs && studies.any(|named| named.study.programs().is_some())
    };
    let (without, kept): (Vec<Ledger>, Vec<Ledger>) = ledgers.into_iter().partition(may_leave);
    let studies = without.iter().flat_map(|ledger| &ledger.studies);
    let left_out = studies.filter(|named| named.study.programs().is_some());
    note_left_out(left_out.map(|named| (&*named.file, &named.study)));
    for named in kept.iter().flat_map(|ledger| &ledger.studies) {
        programs.allow_study(&named.file, &named.study)?;
    }
    Ok(kept)
}
