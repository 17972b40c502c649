//! What stands in folders, and many files at once.

use slipgap::error::Error;
use std::path::{Path, PathBuf};
use walkdir::{DirEntry, WalkDir};

/// What is `wanted` under a folder, in the order of names; an error that names `what` if there is nothing.
pub fn under(
    folder: &Path,
    what: &str,
    wanted: impl Fn(&DirEntry) -> bool,
) -> Result<Vec<PathBuf>, Error> {
    let mut found = Vec::new();
    for entry in WalkDir::new(folder).sort_by_file_name() {
        let entry = entry.map_err(|e| {
            let at = e.path().unwrap_or(folder).to_owned();
            Error::io("cannot read", at)(e.into())
        })?;
        if wanted(&entry) {
            found.push(entry.into_path());
        }
    }
    match found.is_empty() {
        true => Err(Error::Usage(format!(
            "no {what} in folder {}",
            folder.display()
        ))),
        false => Ok(found),
    }
}

/// Whether an entry is a file whose name ends in `.json`.
pub fn is_json(entry: &DirEntry) -> bool {
    let file = entry.path();
    file.is_file() && file.extension().is_some_and(|e| e == "json")
}

/// Reads one after the other; the faults of all are reported together.
pub fn each<F, T>(
    files: impl IntoIterator<Item = F>,
    read: impl Fn(F) -> Result<T, Error>,
) -> Result<Vec<T>, Error> {
    let (mut all, mut faults) = (Vec::new(), Vec::new());
    for file in files {
        match read(file) {
            Ok(one) => all.push(one),
            Err(Error::Faults(more)) => faults.extend(more),
            Err(other) => return Err(other),
        }
    }
    match faults.is_empty() {
        true => Ok(all),
        false => Err(Error::Faults(faults)),
    }
}
