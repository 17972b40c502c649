//! Runs a study into its folder of results: the store, tables, figures, manifest. The program and the Python package write
//! the same bytes, because both call [`run_study`].

mod figures;
pub mod files;
mod group_tables;
mod merge;
mod observer;
mod source;
mod tables;
mod tally;
#[cfg(test)]
mod tests_computed;
mod unsolved;

pub use group_tables::{indices, without_value};
pub use merge::merge_study;
pub use observer::Observer;
pub use source::{
    STUDIES, Source, check_printable, file_name, found, place_in_studies, results_name,
};
pub use tally::{Tally, cases_run};
pub use unsolved::UnsolvedCases;

use crate::batch::WarnedCases;
use crate::batch::files::heartbeat::Heartbeat;
use crate::batch::groups::sobol::DesignMetrics;
use crate::batch::output::ensemble::EnsembleMetrics;
use crate::batch::output::failures_and_histories::write_history;
use crate::batch::output::reductions::ReducedMetrics;
use crate::batch::output::{Folder, INDICES, REDUCTIONS, history_name};
use crate::batch::store::Store;
use crate::batch::{self, RunOptions, ShownCases};
use crate::study_figures;
use crate::warnings::StudyWarnings;
use slipgap_drawing::style;
use slipgap_problem::problem::{Case, Solution, cases_without_contact};
use slipgap_study::error::Error;
use std::path::PathBuf;
use tables::Tables;

/// Largest number of cases for which results.csv is written by default.
const MOST_ROWS: u64 = 100_000;

/// The note on a study without the table.
const WITHOUT_TABLE: &str = "no results.csv, because there are more than 100000 cases; the store has them, and --format csv writes the table, too";

/// What a run writes.
#[derive(Debug, Clone, Copy)]
pub struct OutputOptions {
    /// Whether the history of every case is written.
    pub histories: bool,
    /// Whether the first case without a solution ends the run.
    pub fail_fast: bool,
    /// Whether results.csv is written; `None` for up to 10^5 cases.
    pub table: Option<bool>,
    /// Pixels per inch of figures.
    pub dpi: u32,
    /// Whether all curves of figures are black.
    pub black: bool,
}

impl Default for OutputOptions {
    fn default() -> OutputOptions {
        OutputOptions {
            histories: false,
            fail_fast: false,
            table: None,
            dpi: style::DPI,
            black: false,
        }
    }
}

/// What a run wrote.
#[derive(Debug)]
pub struct Written {
    /// Its files, and the store if there is no results.csv.
    pub paths: Vec<PathBuf>,
    /// Whether every case was solved.
    pub solved: bool,
    /// The warnings.
    pub warnings: Vec<WarnedCases>,
}

impl Written {
    /// Whether there is a warning that is not a note.
    pub fn has_warnings(&self) -> bool {
        self.warnings.iter().any(|warning| !warning.is_note)
    }

    /// The paths, one in each line.
    pub fn list(&self) -> String {
        let paths = self.paths.iter();
        paths.map(|path| format!("{}\n", path.display())).collect()
    }
}

/// Refuses whole histories that do not fit in memory, before any work.
fn check_histories(source: &Source) -> Result<(), Error> {
    let study = &source.study;
    let mut cases = study.range(0, study.raw_len());
    let fault = cases.find_map(|(number, case)| {
        Some((
            number,
            study
                .problem
                .as_structure()
                .and_then(|structure| structure.history_fault(&case))?,
        ))
    });
    fault.map_or(Ok(()), |(number, fault)| {
        let what = format!(
            "case {number}: {} {}; run it without --histories",
            fault.parameter, fault.message
        );
        Err(Error::Usage(source.line(&what)))
    })
}

/// Runs a study into its folder. Cases in the store are not computed again.
///
/// # Errors
/// A file that cannot be written, and with `fail_fast` the first case without a solution.
pub fn run_study(
    source: &Source,
    mut folder: Folder,
    store: Store,
    output: &OutputOptions,
    observer: &mut dyn Observer,
) -> Result<Written, Error> {
    let study = &source.study;
    let cases = study.len();
    if output.histories {
        check_histories(source)?;
    }
    let histories_of = if output.histories { cases } else { 0 };
    folder.begin(study, &source.file, histories_of)?;
    let (bar, work) = observer.begin_cases(source);
    let computed = work.clone();
    let heart = Heartbeat::start(store.folder(), None, move || computed.computed());
    let mut tables = Tables::create(source, &folder, output.table.unwrap_or(cases <= MOST_ROWS))?;
    let mut tally = Tally::new(store.is_empty(), output.histories);
    let needed = study_figures::needed(study);
    let mut shown = ShownCases::new(study.problem.schema());
    let on_solution = |number: u64, solution: &Solution| {
        if let Some(case) = &study.case(number) {
            folder.write_unlisted(&history_name(number), |out| {
                write_history(study, case, solution, out)
            })?;
        }
        Ok(())
    };
    let keep = |case: &Case| study_figures::show_history(study, case);
    let options = RunOptions {
        store: Some(&store),
        // The store has no histories.
        recompute: output.histories,
        keep_history: study_figures::show_histories(study).then_some(&keep),
        on_solution: output.histories.then_some(&on_solution),
        progress: Some(&*work),
    };
    let mut histories = Vec::new();
    let mut designs = DesignMetrics::new(study);
    let mut reductions = ReducedMetrics::new(study);
    let mut ensembles = EnsembleMetrics::new(study);
    let mut warnings = StudyWarnings::new(study);
    let mut without_contact = 0;
    batch::run(study, &bar, &options, |mut part| {
        tally.add(&part);
        observer.part(&part);
        warnings.add(&part);
        without_contact += cases_without_contact(&*study.problem, &part.metrics);
        designs.add(part.first, &part.cases, &part.metrics);
        reductions.add(&part);
        if let Some(ensembles) = &mut ensembles {
            ensembles.add(&part);
        }
        tables.add(&folder, &part)?;
        let failed = part.metrics.failures().next();
        if let Some((row, why)) = failed.filter(|_| output.fail_fast) {
            bar.finish_and_clear();
            let line = unsolved::line(source, part.number(row), why);
            return Err(Error::Unsolved(line));
        }
        if output.histories {
            let solved = (0..part.len()).filter(|row| part.metrics.failure(*row).is_none());
            histories.extend(solved.map(|row| history_name(part.number(row))));
        }
        study_figures::add(study, &needed, &mut part, &mut shown);
        Ok(())
    })?;
    drop(heart);
    observer.end_cases(source, &bar, &tally.summary());
    folder.list(histories.into_iter());
    let mut paths = Vec::new();
    let solved = tables.finish(&mut folder, &store, &mut paths, observer)?;
    let warnings = warnings.list();
    observer.results(source, &warnings);
    if let Some(indices) = indices(source, &designs, observer)? {
        paths.push(folder.write(INDICES, &indices)?);
    }
    if let Some(table) = reductions.table()? {
        for (name, empty, cases) in &table.empty {
            observer.note(&without_value(source, name, *empty, *cases));
        }
        paths.push(folder.write(REDUCTIONS, &table.bytes)?);
    }
    if let Some(metrics) = &ensembles {
        group_tables::write(source, metrics, &mut folder, &mut paths, observer)?;
    }
    if output.table.is_none() && cases > MOST_ROWS {
        observer.note(&source.line(WITHOUT_TABLE));
    }
    figures::write(
        source,
        &mut shown,
        &designs,
        output,
        &mut folder,
        &mut paths,
        observer,
    )?;
    // An outdated part that cannot be removed is reported last, because the results are complete.
    let closed = store.close();
    folder.close(study, without_contact, &warnings)?;
    closed?;
    Ok(Written {
        paths,
        solved,
        warnings,
    })
}
