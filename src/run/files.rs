//! Files in folders, and several files at once.

use slipgap_study::error::Error;
use std::path::{Path, PathBuf};
use walkdir::{DirEntry, WalkDir};

/// The entries of a folder and its sub-folders that `wanted` selects, sorted. An error names `what` if there is none.
pub fn find(
    folder: &Path,
    what: &str,
    wanted: impl Fn(&DirEntry) -> bool,
) -> Result<Vec<PathBuf>, Error> {
    let mut paths = Vec::new();
    for entry in WalkDir::new(folder).sort_by_file_name() {
        let entry = entry.map_err(|e| {
            let at = e.path().unwrap_or(folder).to_owned();
            Error::io("cannot read", at)(e.into())
        })?;
        if wanted(&entry) {
            paths.push(entry.into_path());
        }
    }
    match paths.is_empty() {
        true => Err(Error::Usage(format!(
            "no {what} in folder {}",
            folder.display()
        ))),
        false => Ok(paths),
    }
}

/// Whether an entry is a file with the extension `json`.
pub fn is_json(entry: &DirEntry) -> bool {
    let file = entry.path();
    file.is_file() && file.extension().is_some_and(|e| e == "json")
}

/// Reads files in order. The faults of all files are reported together.
pub fn read_all<F, T>(
    files: impl IntoIterator<Item = F>,
    read: impl Fn(F) -> Result<T, Error>,
) -> Result<Vec<T>, Error> {
    let (mut done, mut faults) = (Vec::new(), Vec::new());
    for file in files {
        match read(file) {
            Ok(one) => done.push(one),
            Err(Error::Faults(more)) => faults.extend(more),
            Err(other) => return Err(other),
        }
    }
    match faults.is_empty() {
        true => Ok(done),
        false => Err(Error::Faults(faults)),
    }
}
