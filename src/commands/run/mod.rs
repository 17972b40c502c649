//! `slipgap run`: results, figures and, if wanted, histories of every study.

mod figures;
mod tables;
mod tally;
mod unsolved;

pub use tally::Tally;
pub use unsolved::UnsolvedCases;

use super::UNSOLVED;
use super::sources::Source;
use super::terminal::{note, print, progress};
use clap::ValueEnum;
use slipgap::batch::output::ensemble::EnsembleMetrics;
use slipgap::batch::output::reductions::ReducedMetrics;
use slipgap::batch::output::sobol::DesignMetrics;
use slipgap::batch::output::tables::write_history;
use slipgap::batch::output::{Folder, INDICES, QUANTILES, REDUCTIONS, TWO_SAMPLES, history_name};
use slipgap::batch::store::Store;
use slipgap::batch::{self, RunOptions};
use slipgap::error::Error;
use slipgap::problem::{Solution, cases_without_contact};
use slipgap::study_figures;
use std::path::{Path, PathBuf};
use tables::Tables;

/// Largest number of cases for which results.csv is written by default.
const MOST_ROWS: u64 = 100_000;

/// Number of cases from which the indices of a design take seconds.
const MANY: u64 = 100_000;

/// The files of a run in addition to figures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// results.csv for any number of cases, and the store
    Csv,
    /// Only the store, a folder of Parquet files
    Parquet,
}

/// The options of a run.
pub struct RunArgs {
    /// Whether the history of every case is written.
    pub histories: bool,
    /// Whether the first case without a solution ends the run.
    pub fail_fast: bool,
    /// The files to write; by default results.csv for up to 10^5 cases.
    pub format: Option<Format>,
    /// Pixels per inch of figures.
    pub dpi: u32,
}

/// Runs the studies into `out`; returns the exit code.
pub fn run(sources: &[Source], out: &Path, args: &RunArgs) -> Result<u8, Error> {
    // All folders are opened first: a folder that cannot be written or is in use ends the command before any computing.
    for source in sources {
        let path = out.join(&source.name);
        Folder::of_study(&path)?;
        Store::open(&path)?;
    }
    let mut code = 0;
    for source in sources {
        let path = out.join(&source.name);
        let folder = Folder::of_study(&path)?;
        if !run_study(source, folder, Store::open(&path)?, args)? {
            code = UNSOLVED;
        }
    }
    Ok(code)
}

/// Runs one study into its folder; returns whether every case was solved.
pub fn run_study(
    source: &Source,
    mut folder: Folder,
    store: Store,
    args: &RunArgs,
) -> Result<bool, Error> {
    let study = &source.study;
    let cases = study.len();
    folder.begin(study, &source.file, if args.histories { cases } else { 0 })?;
    let (bar, work) = progress::bar_with_store(&source.name, study);
    let csv = match args.format {
        Some(Format::Csv) => true,
        Some(Format::Parquet) => false,
        None => cases <= MOST_ROWS,
    };
    let mut tables = Tables::create(source, &folder, csv)?;
    let mut tally = Tally::new(store.is_empty());
    let mut shown = Vec::new();
    let on_solution = |number: u64, solution: &Solution| {
        if let Some(case) = &study.case(number) {
            folder.write_unlisted(&history_name(number), |out| {
                write_history(study, case, solution, out)
            })?;
        }
        Ok(())
    };
    let options = RunOptions {
        store: Some(&store),
        // The store has no histories.
        recompute: args.histories,
        keep_history: &|case| study_figures::show_history(study, case),
        on_solution: args.histories.then_some(&on_solution),
        progress: Some(&*work),
    };
    let mut histories = Vec::new();
    let mut designs = DesignMetrics::new(study);
    let mut reductions = ReducedMetrics::new(study);
    let mut ensembles = EnsembleMetrics::new(study);
    let mut without_contact = 0;
    batch::run(study, &bar, &options, |part| {
        tally.add(&part);
        without_contact += cases_without_contact(&*study.problem, &part.metrics);
        designs.add(&part);
        reductions.add(&part);
        if let Some(ensembles) = &mut ensembles {
            ensembles.add(&part);
        }
        // Cases are separated from the columns only if they are needed one by one.
        if !tables.has_results()
            && study.figures.is_empty()
            && !args.histories
            && part.metrics.failures().next().is_none()
        {
            return Ok(());
        }
        for (number, outcome) in part.outcomes(study) {
            tables.add(&folder, number, &outcome)?;
            match &outcome.failure {
                Some(why) if args.fail_fast => {
                    bar.finish_and_clear();
                    return Err(Error::Unsolved(unsolved::line(source, number, why)));
                }
                None if args.histories => histories.push(history_name(number)),
                Some(_) | None => {}
            }
            if study_figures::show(study, &outcome.case) {
                shown.push(outcome);
            }
        }
        Ok(())
    })?;
    progress::finish(&bar, &source.name, &tally.summary(cases));
    folder.list(histories.into_iter());
    let mut paths = Vec::new();
    let solved = tables.finish(&mut folder, &store, &mut paths)?;
    if without_contact > 0 {
        let file = source.file.display();
        let schema = study.problem.schema();
        let duration = &schema.parameters[schema.duration].name;
        note(&format!(
            "{file}: {without_contact} of {cases} cases have no contact before `{duration}`; their contact metrics are undefined"
        ));
    }
    if let Some(indices) = indices(source, &designs)? {
        paths.push(folder.write(INDICES, &indices)?);
    }
    if let Some(table) = reductions.table()? {
        for (name, empty, cases) in &table.empty {
            note(&without_value(source, name, *empty, *cases));
        }
        paths.push(folder.write(REDUCTIONS, &table.bytes)?);
    }
    if let Some(ensembles) = &ensembles {
        write_ensembles(source, ensembles, &mut folder, &mut paths)?;
    }
    figures::write(study, &mut shown, args.dpi, &mut folder, &mut paths)?;
    // An outdated part that cannot be removed is reported last, because the results are complete.
    let closed = store.close();
    folder.close(study, &source.file, without_contact)?;
    closed?;
    let text: String = paths
        .iter()
        .map(|path| format!("{}\n", path.display()))
        .collect();
    print(&text)?;
    Ok(solved)
}

/// The note on a reduction of cases of which some have no value.
pub fn without_value(source: &Source, name: &str, empty: u64, cases: u64) -> String {
    let file = source.file.display();
    format!("{file}: \"{name}\" leaves out {empty} of {cases} cases, which have no value")
}

/// The table of Sobol' indices, if a block has a saltelli design.
pub fn indices(source: &Source, designs: &DesignMetrics) -> Result<Option<Vec<u8>>, Error> {
    let estimates = designs.estimates();
    if estimates == 0 {
        return Ok(None);
    }
    let long = source.study.len() >= MANY;
    let bar = progress::steps(&source.name, "estimating Sobol' indices", estimates, long);
    let table = designs.table(|| bar.inc(1));
    bar.finish_and_clear();
    let Some(table) = table? else {
        return Ok(None);
    };
    for metric in &table.undefined {
        note(&format!(
            "{}: no Sobol' indices: {metric}",
            source.file.display()
        ));
    }
    Ok(Some(table.bytes))
}

/// Writes the tables of a study with an ensemble, and reports metrics that are empty in some cases.
fn write_ensembles(
    source: &Source,
    ensembles: &EnsembleMetrics,
    folder: &mut Folder,
    paths: &mut Vec<PathBuf>,
) -> Result<(), Error> {
    paths.push(folder.write_with(QUANTILES, |out| ensembles.write_quantiles(out))?);
    if ensembles.has_pairs() {
        paths.push(folder.write_with(TWO_SAMPLES, |out| ensembles.write_two_samples(out))?);
    }
    let empty = ensembles
        .empty()
        .map(|(metric, count)| format!("{metric} in {count}"));
    let empty: Vec<String> = empty.collect();
    if !empty.is_empty() {
        let (file, all) = (source.file.display(), ensembles.cases());
        let empty = empty.join(", ");
        note(&format!(
            "{file}: {QUANTILES} leaves out empty values: {empty} of {all} cases"
        ));
    }
    Ok(())
}
