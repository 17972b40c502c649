//! The store of one study: a folder of Parquet parts, one a chunk, each checked by the sum in its name.
//!
//! `part-00000012-<checksum>.parquet` is written under another name and renamed, so that it is there whole or not at all;
//! what is damaged later shows by its sum. Any tool that reads Parquet reads the folder as one table.

mod reading;
mod uniform;
mod writing;

use std::collections::BTreeMap;
use std::fs::{self, File, TryLockError};
use std::io::Write;
use std::path::{Path, PathBuf};

use super::chunk::{Cut, Key, checksum};
use super::whole::whole;
use crate::compare::Rows;
use crate::error::Error;
use crate::problem::cases::Cases;
use crate::problem::found::Found;
use crate::study::Study;
use parquet::errors::ParquetError;
use uniform::Uniform;

/// Name of the store in a folder of results.
pub const STORE: &str = "store";

/// Column of the reason why a case could not be solved.
const FAILURE: &str = "failure";

/// Held by the run that writes.
const LOCK: &str = "lock";

/// A store, opened and locked.
#[derive(Debug)]
pub struct Store {
    folder: PathBuf,
    /// Parts by the number of their chunk.
    parts: BTreeMap<u64, Vec<PathBuf>>,
    uniform: Uniform,
    _lock: File,
}

impl Store {
    /// Opens the store of a folder of results, or makes it.
    ///
    /// # Errors
    /// [`Error::Busy`] while another run has it.
    pub fn open(results: &Path) -> Result<Store, Error> {
        let folder = results.join(STORE);
        fs::create_dir_all(&folder).map_err(Error::io("cannot make folder", &folder))?;
        let path = folder.join(LOCK);
        let lock = File::create(&path).map_err(Error::io("cannot write", &path))?;
        match lock.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => return Err(Error::Busy(folder)),
            Err(TryLockError::Error(e)) => return Err(Error::io("cannot lock", path)(e)),
        }
        let mut parts: BTreeMap<u64, Vec<PathBuf>> = BTreeMap::new();
        let entries = fs::read_dir(&folder).map_err(Error::io("cannot read", &folder))?;
        for entry in entries {
            let path = entry.map_err(Error::io("cannot read", &folder))?.path();
            if let Some((chunk, _)) = named(&path) {
                parts.entry(chunk).or_default().push(path);
            } else if path.extension().is_some_and(|e| e == "partial") {
                // Left by a run that was killed in writing it.
                let _ = fs::remove_file(&path);
            }
        }
        Ok(Store {
            folder,
            parts,
            uniform: Uniform::default(),
            _lock: lock,
        })
    }

    /// The folder.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Whether a former run left anything.
    pub fn is_empty(&self) -> bool {
        self.parts.is_empty()
    }

    /// What was found of a chunk, if it is there whole and nothing has changed; else why not, if something is there.
    pub fn find(
        &self,
        study: &Study,
        chunk: u64,
        key: &Key,
        cases: usize,
    ) -> Result<Found, Option<String>> {
        let mut why = None;
        for path in self.parts.get(&chunk).into_iter().flatten() {
            let damaged = || Some(format!("{} is damaged", path.display()));
            let whole = fs::read(path)
                .ok()
                .filter(|bytes| named(path).is_some_and(|(_, sum)| checksum(bytes) == sum));
            let Some((kept, found)) = whole.and_then(|bytes| reading::read(study, bytes).ok())
            else {
                why = damaged();
                continue;
            };
            match key.change(&kept) {
                Some(change) => why = why.or(Some(change.to_owned())),
                None if found.len() == cases => return Ok(found),
                None => why = damaged(),
            }
        }
        Err(why)
    }

    /// Keeps what was found of a chunk, in place of what was there.
    pub fn put(
        &self,
        study: &Study,
        chunk: u64,
        key: &Key,
        cases: (u64, &Cases),
        found: &Found,
    ) -> Result<(), Error> {
        let bytes = writing::written(study, key, cases, found, &self.uniform)
            .map_err(|e| Error::Internal(format!("cannot make a part of the store: {e}")))?;
        let path = self
            .folder
            .join(format!("part-{chunk:08}-{}.parquet", checksum(&bytes)));
        // Not waited for until it is on the disk: what a power cut takes away shows by its sum.
        whole(&path, |out| out.write_all(&bytes))?;
        for old in self
            .parts
            .get(&chunk)
            .into_iter()
            .flatten()
            .filter(|old| **old != path)
        {
            let _ = fs::remove_file(old);
        }
        Ok(())
    }

    /// Removes parts of chunks that the study no longer has.
    pub fn close(self, study: &Study) -> Result<(), Error> {
        let chunks = Cut::new(study).count();
        for path in self.parts.range(chunks..).flat_map(|(_, paths)| paths) {
            fs::remove_file(path).map_err(Error::io("cannot remove", path))?;
        }
        Ok(())
    }
}

/// The results in the store of a folder, as text.
///
/// # Errors
/// A part that cannot be read, or is damaged.
pub fn rows(results: &Path) -> Result<Rows, Error> {
    let folder = results.join(STORE);
    let entries = fs::read_dir(&folder).map_err(Error::io("cannot read", &folder))?;
    let paths = entries.filter_map(|entry| Some(entry.ok()?.path()));
    let mut parts: Vec<PathBuf> = paths.filter(|path| named(path).is_some()).collect();
    parts.sort();
    let mut rows = Rows::default();
    for path in parts {
        let bytes = fs::read(&path).map_err(Error::io("cannot read", &path))?;
        let good = named(&path).is_some_and(|(_, sum)| checksum(&bytes) == sum);
        let damaged = || {
            let source = std::io::Error::other("damaged; run the study again");
            Error::io("cannot read", &path)(source)
        };
        if !good {
            return Err(damaged());
        }
        reading::text(bytes, &mut rows).map_err(|_| damaged())?;
    }
    Ok(rows)
}

/// Number of the chunk and checksum in the name of a part.
fn named(path: &Path) -> Option<(u64, String)> {
    let name = path.file_name()?.to_str()?;
    let rest = name.strip_prefix("part-")?.strip_suffix(".parquet")?;
    let (chunk, sum) = rest.split_once('-')?;
    Some((chunk.parse().ok()?, sum.to_owned()))
}

fn general(what: &str) -> ParquetError {
    ParquetError::General(what.into())
}
