//! `slipgap run`: results, figures and, if asked for, histories of every study.

use super::drawn;
use super::progress::{self, Tally};
use super::sources::Source;
use super::tables::Tables;
use super::{UNSOLVED, note, say, unsolved};
use clap::ValueEnum;
use slipgap::batch::output::{Folder, INDICES, history};
use slipgap::batch::results;
use slipgap::batch::sobol::Gathered;
use slipgap::batch::store::Store;
use slipgap::batch::{self, Wishes};
use slipgap::error::Error;
use slipgap::problem::{Solution, cases_without_contact};
use std::path::Path;

/// Most cases of a results.csv that nobody asked for.
const MOST_ROWS: u64 = 100_000;

/// Cases from which on the indices of a design take seconds.
const MANY: u64 = 100_000;

/// What a run writes beside figures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// results.csv for any number of cases, and the store
    Csv,
    /// Only the store, a folder of Parquet files
    Parquet,
}

/// How studies are run.
pub struct Manner {
    /// Whether the history of every case is written.
    pub histories: bool,
    /// Whether the first case without a solution ends the run.
    pub fail_fast: bool,
    /// What is written; by default results.csv for up to 10^5 cases.
    pub format: Option<Format>,
    /// Pixels an inch of figures.
    pub dpi: u32,
}

/// Runs the studies into `out`; gives the exit code.
pub fn run(sources: &[Source], out: &Path, manner: &Manner) -> Result<u8, Error> {
    // Folders first: what cannot be written, or is in use, is said before anything is computed.
    for source in sources {
        let path = out.join(&source.name);
        Folder::of_study(&path)?;
        Store::open(&path)?;
    }
    let mut code = 0;
    for source in sources {
        if !one(source, &out.join(&source.name), manner)? {
            code = UNSOLVED;
        }
    }
    Ok(code)
}

/// Runs one study into a folder, which is locked as long; whether every case was solved.
fn one(source: &Source, path: &Path, manner: &Manner) -> Result<bool, Error> {
    let study = &source.study;
    let (mut folder, store) = (Folder::of_study(path)?, Store::open(path)?);
    let cases = study.len();
    folder.begin(
        study,
        &source.file,
        if manner.histories { cases } else { 0 },
    )?;
    let (bar, pace) = progress::with_store(&source.name, study);
    let table = match manner.format {
        Some(format) => format == Format::Csv,
        None => cases <= MOST_ROWS,
    };
    let mut tables = Tables::begin(source, &folder, table)?;
    let mut tally = Tally::new(store.is_empty());
    let mut shown = Vec::new();
    let visit = |case: u64, solution: &Solution| {
        let (name, case) = (history(case), study.case(case));
        if let Some(case) = &case {
            folder.put(&name, |out| results::history(study, case, solution, out))?;
        }
        Ok(())
    };
    let wishes = Wishes {
        store: Some(&store),
        // Histories are not in the store.
        anew: manner.histories,
        keep: &|case| drawn::over_time(study, case),
        visit: manner.histories.then_some(&visit),
        pace: Some(&*pace),
    };
    let mut solved = Vec::new();
    let mut designs = Gathered::new(study);
    let mut untouched = 0;
    batch::run(study, &bar, &wishes, |done| {
        tally.add(&done);
        untouched += cases_without_contact(&*study.problem, &done.found);
        designs.add(&done);
        // Where nobody looks at cases one by one, they stay columns.
        if !tables.has_results()
            && study.figures.is_empty()
            && !manner.histories
            && done.found.failures().next().is_none()
        {
            return Ok(());
        }
        for (number, outcome) in done.outcomes(study) {
            tables.row(&folder, number, &outcome)?;
            match &outcome.failure {
                Some(why) if manner.fail_fast => {
                    bar.finish_and_clear();
                    return Err(Error::Unsolved(unsolved::line(source, number, why)));
                }
                None if manner.histories => solved.push(history(number)),
                _ => {}
            }
            if drawn::anywhere(study, &outcome.case) {
                shown.push(outcome);
            }
        }
        Ok(())
    })?;
    progress::finish(&bar, &source.name, &tally.told(cases));
    folder.note(solved.into_iter());
    let mut lines = Vec::new();
    let every = tables.finish(&mut folder, &store, &mut lines)?;
    if untouched > 0 {
        note(&format!(
            "{}: {untouched} of {cases} cases have no contact before `duration`; their contact metrics are undefined",
            source.file.display()
        ));
    }
    if let Some(indices) = indices(source, &designs)? {
        lines.push(folder.write(INDICES, &indices)?);
    }
    drawn::figures(study, &mut shown, manner.dpi, &mut folder, &mut lines)?;
    // A part of a former study that stays is told last: the results are there all the same.
    let store = store.close();
    folder.close(study, &source.file, untouched)?;
    store?;
    let text: String = lines
        .iter()
        .map(|path| format!("{}\n", path.display()))
        .collect();
    say(&text)?;
    Ok(every)
}

/// The table of indices, if a block has a saltelli design.
pub fn indices(source: &Source, designs: &Gathered) -> Result<Option<Vec<u8>>, Error> {
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
    for metric in &table.without {
        note(&format!(
            "{}: no Sobol' indices: {metric}",
            source.file.display()
        ));
    }
    Ok(Some(table.bytes))
}
