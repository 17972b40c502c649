//! The folder of one study's results: whole files only, and nothing left over from a former run.

use super::manifest::{HISTORIES, Manifest};
use super::whole::{Growing, can_write, sweep, whole};
use crate::error::Error;
use crate::study::Study;
use std::fs;
use std::io::{self, ErrorKind, Write};
use std::path::{Component, Path, PathBuf};

pub use super::manifest::{history, is_manifest, outdated, problem_of};

/// Name of the table of results.
pub const RESULTS: &str = "results.csv";

/// Table of the cases that could not be solved.
pub const FAILURES: &str = "failures.csv";

/// Table of the indices of saltelli designs.
pub const INDICES: &str = "sobol.csv";

/// A folder that results go to, and what this run has put there.
#[derive(Debug)]
pub struct Folder {
    path: PathBuf,
    written: Vec<String>,
}

impl Folder {
    /// Makes the folder and tries to write in it, so that an answer comes before any computing.
    pub fn open(path: &Path) -> Result<Folder, Error> {
        fs::create_dir_all(path).map_err(Error::io("cannot make folder", path))?;
        can_write(path).map_err(Error::io("cannot write in folder", path))?;
        sweep(path);
        Ok(Folder {
            path: path.to_owned(),
            written: Vec::new(),
        })
    }

    /// The same for the folder of a study, where it must be known which files former runs wrote.
    pub fn of_study(path: &Path) -> Result<Folder, Error> {
        let folder = Folder::open(path)?;
        Manifest::read(path)?;
        Ok(folder)
    }

    /// Notes what a run of the study may leave, before it writes any of it, with the histories of the first `cases`.
    pub fn begin(&self, study: &Study, file: &Path, cases: u64) -> Result<(), Error> {
        sweep(&self.path.join(HISTORIES));
        let figure = |name: &String| ["png", "svg", "pdf"].map(|end| format!("{name}.{end}"));
        let figures = study.figures.iter().flat_map(|f| figure(&f.name));
        let tables = [RESULTS, FAILURES, INDICES].map(String::from);
        let names = tables.into_iter().chain(figures).collect();
        Manifest::read(&self.path)?.begin(&self.path, study, file, names, cases)
    }

    /// Writes `name`, as in `histories/3.csv`, and gives its path.
    pub fn write(&mut self, name: &str, bytes: &[u8]) -> Result<PathBuf, Error> {
        self.written.push(name.to_owned());
        self.put(name, |out| out.write_all(bytes))
    }

    /// Writes one of many files of a sub-folder, piece by piece, without noting it; see [`Folder::note`].
    pub fn put(
        &self,
        name: &str,
        write: impl FnOnce(&mut Growing) -> io::Result<()>,
    ) -> Result<PathBuf, Error> {
        let path = self.place(name);
        if let Some(parent) = path.parent() {
            fs::create_dir_all(parent).map_err(Error::io("cannot make folder", parent))?;
        }
        whole(&path, write)?;
        Ok(path)
    }

    /// Path of a file in it.
    pub fn place(&self, name: &str) -> PathBuf {
        self.path.join(name)
    }

    /// Begins a file that grows while the study runs.
    pub fn grow(&self, name: &str) -> Result<Growing, Error> {
        Growing::begin(&self.place(name))
    }

    /// Takes what has grown as `name`, and gives its path.
    pub fn take(&mut self, grown: Growing, name: &str) -> Result<PathBuf, Error> {
        grown.finish()?;
        self.written.push(name.to_owned());
        Ok(self.place(name))
    }

    /// Notes files that [`Folder::put`] wrote.
    pub fn note(&mut self, names: impl Iterator<Item = String>) {
        self.written.extend(names);
    }

    /// Removes what former runs wrote and this one did not, then writes the manifest, with the number of cases in which
    /// no contact happens.
    pub fn close(mut self, study: &Study, file: &Path, untouched: u64) -> Result<(), Error> {
        self.written.sort();
        let manifest = Manifest::read(&self.path)?;
        for name in manifest.owned(&self.path) {
            // Only names inside the folder: a manifest edited by hand must not reach further.
            let inside = Path::new(&name)
                .components()
                .all(|part| matches!(part, Component::Normal(_)));
            if inside && self.written.binary_search(&name).is_err() {
                self.remove(&name)?;
            }
        }
        Manifest::end(&self.path, study, file, &self.written, untouched)
    }

    /// Removes a file that a former run wrote.
    fn remove(&self, name: &str) -> Result<(), Error> {
        let path = self.place(name);
        // A folder in its place is not what the run wrote.
        if path.is_dir() {
            return Ok(());
        }
        match fs::remove_file(&path) {
            Err(e) if !matches!(e.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory) => {
                return Err(Error::io("cannot remove", path)(e));
            }
            _ => {}
        }
        // A sub-folder goes with its last file; one that still holds something stays.
        if let Some(parent) = path.parent().filter(|parent| *parent != self.path) {
            let _ = fs::remove_dir(parent);
        }
        Ok(())
    }
}
