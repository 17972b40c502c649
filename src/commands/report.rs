//! `slipgap report`: one page about studies that needs no other file.

use super::arguments::sources::Source;
use super::arguments::{JobsArgs, ProgramsArgs, StudiesArgs, results_folder};
use super::claims;
use super::terminal::{Terminal, note, print};
use crate::batch::groups::sobol::DesignMetrics;
use crate::batch::output::ensemble::EnsembleMetrics;
use crate::batch::output::{Folder, outdated};
use crate::batch::store::Store;
use crate::batch::{self, RunOptions, ShownCases};
use crate::checks::ReducedChecks;
use crate::claims::compute;
use crate::claims::ledger::Ledger;
use crate::error::Error;
use crate::figures::FigureData;
use crate::problem::Case;
use crate::report::{
    self, Checks, Counts, Drawing, Indices, MOST_BYTES, Quantiles, Results, Section, TestedReading,
};
use crate::run::{self, Observer, OutputOptions, Tally};
use crate::study::Study;
use crate::study_figures;
use crate::warnings::StudyWarnings;
use clap::Args;
use indicatif::ProgressBar;
use rayon::prelude::*;
use std::path::{Path, PathBuf};
use std::slice;

/// Name of the page.
const PAGE: &str = "report.html";

/// Folder of the ledgers of claims.
const LEDGERS: &str = "claims";

/// The arguments of `slipgap report`.
#[derive(Args)]
pub struct ReportArgs {
    #[command(flatten)]
    studies: StudiesArgs,
    /// Folder for report.html and the results of the studies
    #[arg(long, value_name = "DIR", default_value = "figures", value_parser = results_folder())]
    out: PathBuf,
    #[command(flatten)]
    jobs: JobsArgs,
    #[command(flatten)]
    programs: ProgramsArgs,
}

impl ReportArgs {
    /// Writes the page; returns the exit code.
    pub fn execute(self) -> Result<u8, Error> {
        let studies = self
            .programs
            .allow_in(self.studies.read()?, self.studies.named())?;
        let programs = self.programs;
        self.jobs.run(|| report(&studies, &self.out, programs))
    }
}

/// Runs the studies with the stores in `out` and writes the page there; returns the exit code.
fn report(sources: &[Source], out: &Path, programs: ProgramsArgs) -> Result<u8, Error> {
    let folder = Folder::open(out)?;
    // Before anything is computed, because a ledger may have faults.
    let ledgers = match Path::new(LEDGERS).is_dir() {
        true => claims::read(&[PathBuf::from(LEDGERS)], programs)?,
        false => Vec::new(),
    };
    let mut sections = Vec::new();
    let mut bytes_left = MOST_BYTES;
    let mut terminal = Terminal::new(sources);
    for source in sources {
        let section = section(source, (out, bytes_left), &mut terminal)?;
        bytes_left = bytes_left.saturating_sub(section.results.bytes());
        sections.push(section);
    }
    // Together, because the few cases of one study do not keep all threads busy.
    let counts: Vec<(&mut Counts, &Study)> = sections
        .iter_mut()
        .map(|section| (&mut section.counts, section.study))
        .collect();
    counts
        .into_par_iter()
        .for_each(|(counts, study)| counts.look_for_divergence(study));
    // The claims read the stores of the sections.
    for (section, readings) in sections
        .iter_mut()
        .zip(tested_readings(sources, &ledgers, out)?)
    {
        section.claims = readings;
    }
    let path = folder.write_unlisted(PAGE, |file| report::write(file, &mut sections))?;
    print(&format!("{}\n", path.display()))
}

/// Runs a study into its folder in `out`. `largest` is the largest size of its results.
fn section<'a>(
    source: &'a Source,
    (out, largest): (&Path, usize),
    terminal: &mut Terminal,
) -> Result<Section<'a>, Error> {
    let study = &source.study;
    let results = out.join(&source.name);
    update_results(source, &results)?;
    // Several reports of one study wait for each other.
    let store = Store::wait_and_open(&results)?;
    let (bar, work) = terminal.begin_cases(source);
    let keep = |case: &Case| study_figures::show_history(study, case);
    let options = RunOptions {
        store: Some(&store),
        keep_history: study_figures::show_histories(study).then_some(&keep),
        progress: Some(&*work),
        ..RunOptions::METRICS
    };
    let mut tally = Tally::new(store.is_empty(), false);
    let mut results = Results::new(study, store.folder().to_owned(), largest);
    let (mut counts, mut checks) = (Counts::new(study), Checks::default());
    let mut warnings = StudyWarnings::new(study);
    let needed = study_figures::needed(study);
    let mut shown = ShownCases::new(study.problem.schema());
    let mut designs = DesignMetrics::new(study);
    let mut reduced = ReducedChecks::new(study);
    let mut ensembles = EnsembleMetrics::new(study);
    batch::run(study, &bar, &options, |mut part| {
        tally.add(&part);
        designs.add(part.first, &part.cases, &part.metrics);
        warnings.add(&part);
        if let Some(ensembles) = &mut ensembles {
            ensembles.add(&part);
        }
        study_figures::add(study, &needed, &mut part, &mut shown);
        for (number, outcome) in part.outcomes(study) {
            results.add(&outcome);
            counts.add(study, number, &outcome);
            checks.judge(study, number, &outcome);
            reduced.add(number, &outcome.case, |metric| outcome.metrics[metric]);
        }
        Ok(())
    })?;
    terminal.end_cases(source, &bar, &tally.summary());
    store.close()?;
    counts.warnings = warnings.list();
    checks.judge_reduced(study, &reduced);
    let indices = run::indices(source, &designs, terminal)?;
    let mut drawings = Vec::new();
    study_figures::add_histories(study, &mut shown);
    for figure in &study.figures {
        let draw = |data: &FigureData| Drawing::new(data);
        drawings.push(study_figures::with_data(
            study, figure, &shown, &designs, draw,
        )?);
    }
    Ok(Section {
        name: &source.name,
        file: source.origin(),
        text: source.text.clone(),
        study,
        figures: drawings,
        results,
        counts,
        indices: Indices::new(indices.as_deref().unwrap_or_default()),
        quantiles: ensembles.as_ref().map(Quantiles::new),
        checks,
        claims: Vec::new(),
    })
}

/// Runs the study again if results.csv is of another version of it, of its files or of the program, so that store and results.csv have the same rows.
fn update_results(source: &Source, results: &Path) -> Result<(), Error> {
    if outdated(results, &source.study).is_empty() {
        return Ok(());
    }
    let folder = Folder::of_study(results)?;
    let store = Store::wait_and_open(results)?;
    // Another report may have run the study during the wait.
    let differences = outdated(results, &source.study);
    if differences.is_empty() {
        return Ok(());
    }
    note(&format!(
        "{}: the results are of {}; running it again",
        source.name,
        differences.join("; ")
    ));
    // Cases without a solution do not end the command; the page reports them.
    run::run_study(
        source,
        folder,
        store,
        &OutputOptions::default(),
        &mut Terminal::new(slice::from_ref(source)),
    )?;
    Ok(())
}

/// For each study the readings of claims that it tests, tested now.
fn tested_readings(
    sources: &[Source],
    ledgers: &[Ledger],
    out: &Path,
) -> Result<Vec<Vec<TestedReading>>, Error> {
    let mut readings: Vec<Vec<TestedReading>> = sources.iter().map(|_| Vec::new()).collect();
    let same = |a: &Path, b: &Path| {
        a.canonicalize()
            .ok()
            .is_some_and(|a| b.canonicalize().ok() == Some(a))
    };
    for ledger in ledgers {
        let index = |study: usize| {
            let file = &ledger.studies[study].file;
            // A study with settings of the command line does not test a claim.
            let unchanged = |source: &Source| source.study.settings.is_empty();
            let mut sources = sources.iter();
            sources.position(|source| unchanged(source) && same(&source.file, file))
        };
        if (0..ledger.studies.len()).all(|study| index(study).is_none()) {
            continue;
        }
        let findings = compute(ledger, out, &ProgressBar::hidden())?;
        note(&format!("{}: judged", ledger.paper));
        for (claim, findings) in ledger.claims.iter().zip(findings) {
            for (reading, finding) in claim.readings.iter().zip(findings) {
                if let Some(index) = index(reading.study) {
                    readings[index].push(TestedReading {
                        id: claim.id.clone(),
                        statement: claim.statement.clone(),
                        reading: reading.name.clone(),
                        computed: finding.found.join("; "),
                        holds: finding.holds,
                    });
                }
            }
        }
    }
    Ok(readings)
}
