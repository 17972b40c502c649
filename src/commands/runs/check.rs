//! `slipgap check`: every check of every study, with the value tested.

use crate::batch::output::{differences, of_others};
use crate::batch::{self, RunOptions};
use crate::checks::{CheckCollector, TestedValues, Verdict};
use crate::commands::arguments::sources::Source;
use crate::commands::arguments::{JobsArgs, ProgramsArgs, StudiesArgs};
use crate::commands::terminal::{Summary, note, print_all, progress, table_lines};
use crate::commands::{NOT_MET, UNSOLVED};
use crate::error::Error;
use crate::problem::numbers::parameter::shortest;
use crate::run::{UnsolvedCases, cases_run, without_value};
use crate::warnings::StudyWarnings;
use clap::Args;
use std::path::Path;

/// Where `run` writes by default: results there that are of other files or versions are reported.
const RESULTS: &str = "figures";

/// The arguments of `slipgap check`.
#[derive(Args)]
pub struct CheckArgs {
    #[command(flatten)]
    studies: StudiesArgs,
    #[command(flatten)]
    jobs: JobsArgs,
    #[command(flatten)]
    programs: ProgramsArgs,
}

impl CheckArgs {
    /// Tests the checks; returns the exit code.
    pub fn execute(self) -> Result<u8, Error> {
        let studies = self
            .programs
            .allow_in(self.studies.read()?, self.studies.named())?;
        self.jobs.run(|| check(&studies))
    }
}

/// A study and the values that its checks test.
struct Tested<'a> {
    source: &'a Source,
    values: TestedValues,
}

/// Runs the studies without writing files and prints the verdicts; returns the exit code.
fn check(sources: &[Source]) -> Result<u8, Error> {
    let (mut studies, mut all_solved) = (Vec::new(), true);
    let mut summary = Summary::new(sources.len());
    for source in sources {
        let results = Path::new(RESULTS).join(&source.name);
        let differences = differences(&results, &source.study);
        if !differences.is_empty() {
            note(&source.line(&of_others(&results, &differences)));
        }
        let (checked, solved) = run_study(source, &mut summary)?;
        studies.push(checked);
        all_solved &= solved;
    }
    summary.print();
    let header = ["study", "case", "metric", "value", "limits", "verdict"];
    print_all(table_lines(|| {
        let rows = studies.iter().flat_map(|checked| {
            let name = &checked.source.name;
            checked.verdicts().map(move |verdict| row(name, &verdict))
        });
        std::iter::once(header.map(String::from).to_vec()).chain(rows)
    }))?;
    let verdicts = || studies.iter().flat_map(Tested::verdicts);
    let failed = verdicts().filter(|verdict| !verdict.holds()).count();
    let checks = match verdicts().count() {
        1 => "1 check".to_owned(),
        count => format!("{count} checks"),
    };
    note(&format!("{checks}, {failed} not met"));
    // A case without a solution decides the exit code before a check that is not met.
    Ok(match (all_solved, failed) {
        (false, _) => UNSOLVED,
        (true, 0) => 0,
        (true, _) => NOT_MET,
    })
}

/// Runs one study and adds its warnings; returns the checked values, and whether every case was solved.
fn run_study<'a>(source: &'a Source, summary: &mut Summary) -> Result<(Tested<'a>, bool), Error> {
    let study = &source.study;
    let bar = progress::bar(&source.name, study.len());
    let mut checks = CheckCollector::new(study);
    let mut unsolved = UnsolvedCases::new(source);
    let mut warnings = StudyWarnings::new(study);
    let mut cases = 0;
    batch::run(study, &bar, &RunOptions::METRICS, |part| {
        cases += part.len() as u64;
        warnings.add(&part);
        checks.add(&part);
        for (row, why) in part.metrics.failures() {
            unsolved.add(part.number(row), why);
        }
        Ok(())
    })?;
    progress::finish(&bar, &source.name, &cases_run(cases));
    unsolved.lines().for_each(|line| note(&line));
    summary.add(source, &warnings.list());
    for (name, empty, cases) in checks.empty() {
        note(&without_value(source, name, empty, cases));
    }
    let values = checks.finish();
    Ok((Tested { source, values }, unsolved.is_empty()))
}

impl Tested<'_> {
    /// The verdicts, sorted by check and case.
    fn verdicts(&self) -> impl Iterator<Item = Verdict> {
        self.values.verdicts(&self.source.study)
    }
}

fn row(name: &str, verdict: &Verdict) -> Vec<String> {
    vec![
        name.to_owned(),
        verdict.case.to_string(),
        verdict.metric.to_owned(),
        verdict.value.map_or("undefined".into(), shortest),
        verdict.limits(),
        if verdict.holds() { "ok" } else { "NOT MET" }.to_owned(),
    ]
}
