//! `slipgap run`: results, figures and, if asked for, histories of every study.

use super::drawn;
use super::progress::{self, Tally};
use super::sources::Source;
use super::{UNSOLVED, note, say};
use clap::ValueEnum;
use slipgap::batch::output::{Folder, RESULTS};
use slipgap::batch::results::{self, Table};
use slipgap::batch::sobol::Gathered;
use slipgap::batch::store::Store;
use slipgap::batch::{self, Outcome, Wishes};
use slipgap::error::Error;
use slipgap::problem::Solution;
use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

/// Most cases of a results.csv that nobody asked for.
const MOST_ROWS: u64 = 100_000;

/// Table of the cases that could not be solved.
const FAILURES: &str = "failures.csv";

/// Table of the indices of saltelli designs.
const INDICES: &str = "sobol.csv";

/// Most of them that are named on stderr.
const MOST_NAMED: usize = 20;

/// What a run writes beside figures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// results.csv, however many cases there are, beside the store
    Csv,
    /// The store alone, a folder of Parquet files
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
}

/// Runs the studies into `out`; gives the exit code.
pub fn run(sources: &[Source], out: &Path, manner: &Manner) -> Result<u8, Error> {
    // Folders first: what cannot be written is said before anything is computed.
    let places = sources
        .iter()
        .map(|source| {
            let path = out.join(&source.name);
            Ok((Folder::open(&path)?, Store::open(&path)?))
        })
        .collect::<Result<Vec<_>, Error>>()?;
    let mut code = 0;
    for (source, (folder, store)) in sources.iter().zip(places) {
        if !one(source, folder, store, manner)? {
            code = UNSOLVED;
        }
    }
    Ok(code)
}

/// Runs one study; whether every case was solved.
fn one(source: &Source, mut folder: Folder, store: Store, manner: &Manner) -> Result<bool, Error> {
    let study = &source.study;
    let history = |case: u64| format!("histories/{case}.csv");
    let cases = study.len();
    let bar = progress::bar(&source.name, cases);
    let mut table = match manner.format {
        Some(Format::Parquet) => None,
        None if cases > MOST_ROWS => None,
        _ => Some(Rows::begin(source, &store)?),
    };
    let mut tally = Tally::new(store.is_empty());
    let (mut shown, mut failed) = (Vec::new(), Vec::new());
    let visit = |case: u64, solution: &Solution| {
        let name = history(case);
        folder.put(&name, |out| results::history(study.problem, solution, out))?;
        Ok(())
    };
    let wishes = Wishes {
        store: Some(&store),
        // Histories are not in the store.
        anew: manner.histories,
        keep: &|case| drawn::over_time(study, case),
        visit: manner.histories.then_some(&visit),
    };
    let mut solved = Vec::new();
    let mut designs = Gathered::new(study);
    let mut untouched = 0;
    batch::run(study, &bar, &wishes, |done| {
        tally.add(&done);
        untouched += done.found.untouched(study.problem);
        designs.add(&done);
        // Where nobody looks at cases one by one, they stay columns.
        if table.is_none()
            && study.figures.is_empty()
            && !manner.histories
            && done.found.failures().next().is_none()
        {
            return Ok(());
        }
        for (number, outcome) in done.outcomes(study.problem) {
            if let Some(table) = &mut table {
                table.row(number, &outcome)?;
            }
            if manner.histories && outcome.failure.is_none() {
                solved.push(history(number));
            }
            let fails = outcome.failure.is_some();
            if fails && manner.fail_fast {
                bar.finish_and_clear();
                return Err(Error::Unsolved(unsolved(source, number, &outcome)));
            }
            if fails {
                failed.push((number, outcome.clone()));
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
    match table {
        Some(table) => lines.push(folder.take(&table.finish()?, RESULTS)?),
        None => lines.push(store.folder().to_owned()),
    }
    if !failed.is_empty() {
        name_unsolved(source, &failed);
        lines.push(folder.write(FAILURES, &results::failures(study, &failed)?)?);
    }
    if untouched > 0 {
        note(&format!(
            "{}: {untouched} of {cases} cases never touch before `duration`: their contact metrics are undefined",
            source.file.display()
        ));
    }
    if let Some(indices) = designs.table()? {
        for metric in &indices.without {
            note(&format!(
                "{}: no Sobol' indices: {metric}",
                source.file.display()
            ));
        }
        lines.push(folder.write(INDICES, &indices.bytes)?);
    }
    drawn::figures(study, &mut shown, &mut folder, &mut lines)?;
    store.close(study)?;
    folder.close(study, &source.file, untouched)?;
    let text: String = lines
        .iter()
        .map(|path| format!("{}\n", path.display()))
        .collect();
    say(&text)?;
    Ok(failed.is_empty())
}

/// results.csv as it grows, in the store until it is whole.
struct Rows<'a> {
    path: PathBuf,
    table: Table<'a, BufWriter<File>>,
}

impl<'a> Rows<'a> {
    fn begin(source: &'a Source, store: &Store) -> Result<Rows<'a>, Error> {
        let path = store.folder().join(format!("{RESULTS}.partial"));
        let table = File::create(&path)
            .and_then(|file| Table::new(&source.study, BufWriter::new(file)))
            .map_err(Error::io("cannot write", &path))?;
        Ok(Rows { path, table })
    }

    fn row(&mut self, number: u64, outcome: &Outcome) -> Result<(), Error> {
        let failed = Error::io("cannot write", &self.path);
        self.table.row(number, outcome).map_err(failed)
    }

    fn finish(self) -> Result<PathBuf, Error> {
        let failed = Error::io("cannot write", &self.path);
        let file = self.table.finish().and_then(|out| Ok(out.into_inner()?));
        file.map_err(failed)?;
        Ok(self.path)
    }
}

/// Names cases that could not be solved, the first of many.
pub fn name_unsolved(source: &Source, failed: &[(u64, Outcome)]) {
    for (number, outcome) in failed.iter().take(MOST_NAMED) {
        note(&unsolved(source, *number, outcome));
    }
    if failed.len() > MOST_NAMED {
        let more = failed.len() - MOST_NAMED;
        note(&format!("{}: and {more} more", source.file.display()));
    }
}

fn unsolved(source: &Source, number: u64, outcome: &Outcome) -> String {
    let why = outcome.failure.as_deref().unwrap_or_default();
    format!(
        "{}: case {number} could not be solved: {why}",
        source.file.display()
    )
}
