//! The tables that grow while a study runs: results.csv, if it is written, and failures.csv, if a case has no solution.

use super::sources::Source;
use super::unsolved::Unsolved;
use slipgap::batch::Outcome;
use slipgap::batch::output::{FAILURES, Folder, RESULTS};
use slipgap::batch::results::{Failures, Table};
use slipgap::batch::store::Store;
use slipgap::batch::whole::Growing;
use slipgap::error::Error;
use std::io;
use std::path::PathBuf;

/// The tables as far as they have grown; what is not finished goes.
pub struct Tables<'a> {
    source: &'a Source,
    results: Option<Table<'a, Growing>>,
    failures: Option<Failures<Growing>>,
    unsolved: Unsolved<'a>,
}

impl<'a> Tables<'a> {
    /// Begins them, results.csv only where it is wanted.
    pub fn begin(source: &'a Source, folder: &Folder, results: bool) -> Result<Tables<'a>, Error> {
        let table = |file| Table::new(&source.study, file).map_err(unwritten(folder, RESULTS));
        let results = match results {
            true => Some(folder.grow(RESULTS).and_then(table)?),
            false => None,
        };
        Ok(Tables {
            source,
            results,
            failures: None,
            unsolved: Unsolved::new(source),
        })
    }

    /// Whether each case becomes a row of results.csv.
    pub fn has_results(&self) -> bool {
        self.results.is_some()
    }

    /// Adds one case.
    pub fn row(&mut self, folder: &Folder, number: u64, outcome: &Outcome) -> Result<(), Error> {
        if let Some(table) = &mut self.results {
            let written = table.row(number, outcome);
            written.map_err(unwritten(folder, RESULTS))?;
        }
        let Some(why) = &outcome.failure else {
            return Ok(());
        };
        self.unsolved.add(number, why);
        let table = match &mut self.failures {
            Some(table) => table,
            none => {
                let table = Failures::new(&self.source.study, folder.grow(FAILURES)?);
                none.insert(table.map_err(unwritten(folder, FAILURES))?)
            }
        };
        let written = table.row(number, &outcome.case, why);
        written.map_err(unwritten(folder, FAILURES))
    }

    /// Gives them their names, tells of cases without a solution, and adds what was written to `lines`; whether every
    /// case was solved.
    pub fn finish(
        self,
        folder: &mut Folder,
        store: &Store,
        lines: &mut Vec<PathBuf>,
    ) -> Result<bool, Error> {
        lines.push(match self.results {
            Some(table) => {
                let grown = table.finish().map_err(unwritten(folder, RESULTS))?;
                folder.take(grown, RESULTS)?
            }
            None => store.folder().to_owned(),
        });
        self.unsolved.tell();
        if let Some(table) = self.failures {
            let grown = table.finish().map_err(unwritten(folder, FAILURES))?;
            lines.push(folder.take(grown, FAILURES)?);
        }
        Ok(self.unsolved.is_empty())
    }
}

/// What the operating system said of a table of the folder.
fn unwritten(folder: &Folder, name: &str) -> impl FnOnce(io::Error) -> Error {
    Error::io("cannot write", folder.place(name))
}
