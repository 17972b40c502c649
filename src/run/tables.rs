//! The tables that are written during a run: results.csv if wanted, and failures.csv if a case has no solution.

use super::unsolved::UnsolvedCases;
use super::{Observer, Source};
use crate::batch::PartResult;
use crate::batch::files::atomic::AtomicFile;
use crate::batch::output::failures_and_histories::FailureTable;
use crate::batch::output::results::ResultTable;
use crate::batch::output::{FAILURES, Folder, RESULTS};
use crate::batch::store::Store;
use slipgap_study::error::Error;
use std::io;
use std::path::PathBuf;

/// The tables so far. They are removed unless they are finished.
pub struct Tables<'a> {
    source: &'a Source,
    results: Option<ResultTable<'a, AtomicFile>>,
    failures: Option<FailureTable<AtomicFile>>,
    unsolved: UnsolvedCases<'a>,
}

impl<'a> Tables<'a> {
    /// Creates results.csv if it is wanted.
    pub fn create(source: &'a Source, folder: &Folder, results: bool) -> Result<Tables<'a>, Error> {
        let table =
            |file| ResultTable::new(&source.study, file).map_err(write_error(folder, RESULTS));
        let results = match results {
            true => Some(folder.create(RESULTS).and_then(table)?),
            false => None,
        };
        Ok(Tables {
            source,
            results,
            failures: None,
            unsolved: UnsolvedCases::new(source),
        })
    }

    /// Adds the cases of a part.
    pub fn add(&mut self, folder: &Folder, part: &PartResult) -> Result<(), Error> {
        if let Some(table) = &mut self.results {
            let written = table.add(part);
            written.map_err(write_error(folder, RESULTS))?;
        }
        let mut shown = part.cases.shown();
        for (row, why) in part.metrics.failures() {
            let number = part.number(row);
            self.unsolved.add(number, why);
            let table = match &mut self.failures {
                Some(table) => table,
                none => {
                    let table = FailureTable::new(&self.source.study, folder.create(FAILURES)?);
                    none.insert(table.map_err(write_error(folder, FAILURES))?)
                }
            };
            let written = table.row(number, shown.at(row), why);
            written.map_err(write_error(folder, FAILURES))?;
        }
        Ok(())
    }

    /// Commits the files, adds their paths to `paths`, and reports cases without a solution. It returns whether every
    /// case was solved.
    pub fn finish(
        self,
        folder: &mut Folder,
        store: &Store,
        paths: &mut Vec<PathBuf>,
        observer: &mut dyn Observer,
    ) -> Result<bool, Error> {
        paths.push(match self.results {
            Some(table) => {
                let file = table.finish().map_err(write_error(folder, RESULTS))?;
                folder.commit(file, RESULTS)?
            }
            None => store.folder().to_owned(),
        });
        self.unsolved.lines().for_each(|line| observer.note(&line));
        if let Some(table) = self.failures {
            let file = table.finish().map_err(write_error(folder, FAILURES))?;
            paths.push(folder.commit(file, FAILURES)?);
        }
        Ok(self.unsolved.is_empty())
    }
}

/// The error of a table that cannot be written.
fn write_error(folder: &Folder, name: &str) -> impl FnOnce(io::Error) -> Error {
    Error::io("cannot write", folder.path_of(name))
}
