//! The folder of a study's results. It has only complete files, and no outdated files of former runs.

pub mod ensemble;
pub mod failures_and_histories;
pub mod fragility;
mod manifest;
mod names;
mod origin;
pub mod reductions;
pub mod results;
pub mod sobol;

pub use manifest::{is_manifest, manifest, problem_of};
pub use names::{
    FAILURES, INDICES, QUANTILES, REDUCTIONS, RESULTS, TESTS, TWO_SAMPLES, history_name,
};

use super::WarnedCases;
use super::files::atomic::{AtomicFile, can_write, remove_leftovers, write_atomically};
use super::files::place::{make_folder, remove_empty_folder, remove_file};
use manifest::Manifest;
use names::{FRAGILITY, HISTORIES, MEMBERS};
use origin::origin;
pub use origin::{differences, differences_between, of_others, outdated};
use serde_json::{Map, Value};
use slipgap_study::Study;
use slipgap_study::error::Error;
use std::io::{self, ErrorKind, Write};
use std::path::{Component, Path, PathBuf};

/// A folder of results, and the names of the files that this run has written.
#[derive(Debug)]
pub struct Folder {
    path: PathBuf,
    written: Vec<String>,
    /// The origin of the results of the run that has begun.
    origin: Map<String, Value>,
}

impl Folder {
    /// Makes the folder and tests whether it can be written to, before any case is computed.
    pub fn open(path: &Path) -> Result<Folder, Error> {
        make_folder(path).map_err(Error::io("cannot make folder", path))?;
        can_write(path).map_err(Error::io("cannot write in folder", path))?;
        remove_leftovers(path);
        Ok(Folder {
            path: path.to_owned(),
            written: Vec::new(),
            origin: Map::new(),
        })
    }

    /// Opens the folder of a study. Its manifest must list the files that former runs wrote.
    pub fn of_study(path: &Path) -> Result<Folder, Error> {
        let folder = Folder::open(path)?;
        Manifest::read(path)?;
        Ok(folder)
    }

    /// Lists the files that a run of the study may write in the manifest, before any is written; with the histories of the
    /// first `cases`.
    pub fn begin(&mut self, study: &Study, file: &Path, cases: u64) -> Result<(), Error> {
        remove_leftovers(&self.path.join(HISTORIES));
        let pictures = |name: &String| ["png", "svg", "pdf"].map(|end| format!("{name}.{end}"));
        let figures = study.figures.iter().flat_map(|f| pictures(&f.name));
        let tables = [
            RESULTS,
            FAILURES,
            INDICES,
            REDUCTIONS,
            QUANTILES,
            TWO_SAMPLES,
            TESTS,
            FRAGILITY,
            MEMBERS,
        ]
        .map(String::from);
        let names = tables.into_iter().chain(figures).collect();
        self.origin = origin(study, file);
        Manifest::read(&self.path)?.begin(&self.path, &self.origin, names, cases)
    }

    /// Writes a file and returns its path.
    pub fn write(&mut self, name: &str, bytes: &[u8]) -> Result<PathBuf, Error> {
        self.written.push(name.to_owned());
        self.write_unlisted(name, |out| out.write_all(bytes))
    }

    /// Writes a file piece by piece and returns its path.
    pub fn write_with(
        &mut self,
        name: &str,
        write: impl FnOnce(&mut AtomicFile) -> io::Result<()>,
    ) -> Result<PathBuf, Error> {
        self.written.push(name.to_owned());
        self.write_unlisted(name, write)
    }

    /// Writes a file, as in `histories/3.csv`, that is not listed as written; see [`Folder::list`].
    pub fn write_unlisted(
        &self,
        name: &str,
        write: impl FnOnce(&mut AtomicFile) -> io::Result<()>,
    ) -> Result<PathBuf, Error> {
        let path = self.path_of(name);
        if let Some(parent) = path.parent() {
            make_folder(parent).map_err(Error::io("cannot make folder", parent))?;
        }
        write_atomically(&path, write)?;
        Ok(path)
    }

    /// Path of a file in the folder.
    pub fn path_of(&self, name: &str) -> PathBuf {
        self.path.join(name)
    }

    /// Creates a file that is written while the study runs.
    pub fn create(&self, name: &str) -> Result<AtomicFile, Error> {
        AtomicFile::create(&self.path_of(name))
    }

    /// Commits the file `name` and returns its path.
    pub fn commit(&mut self, file: AtomicFile, name: &str) -> Result<PathBuf, Error> {
        file.commit()?;
        self.written.push(name.to_owned());
        Ok(self.path_of(name))
    }

    /// Lists files that [`Folder::write_unlisted`] wrote.
    pub fn list(&mut self, names: impl Iterator<Item = String>) {
        self.written.extend(names);
    }

    /// Removes the files of former runs that this run, which has begun, did not write; then writes the manifest, with the number of
    /// cases without contact and the warnings.
    pub fn close(
        mut self,
        study: &Study,
        cases_without_contact: u64,
        warnings: &[WarnedCases],
    ) -> Result<(), Error> {
        self.written.sort();
        let manifest = Manifest::read(&self.path)?;
        for name in manifest.owned(&self.path) {
            // Only files in the folder are removed, also if somebody has edited the manifest.
            let inside = Path::new(&name)
                .components()
                .all(|part| matches!(part, Component::Normal(_)));
            if inside && self.written.binary_search(&name).is_err() {
                self.remove(&name)?;
            }
        }
        Manifest::end(
            &self.path,
            self.origin,
            study,
            &self.written,
            cases_without_contact,
            warnings,
        )
    }

    /// Removes a file of a former run.
    fn remove(&self, name: &str) -> Result<(), Error> {
        let path = self.path_of(name);
        // No run writes a folder of this name.
        if path.is_dir() {
            return Ok(());
        }
        match remove_file(&path) {
            Err(e) if !matches!(e.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory) => {
                return Err(Error::io("cannot remove", path)(e));
            }
            Err(_) | Ok(()) => {}
        }
        if let Some(parent) = path.parent().filter(|parent| *parent != self.path) {
            remove_empty_folder(parent);
        }
        Ok(())
    }
}
