//! The store of one study: a folder of Parquet parts, one a chunk, each checked by the sum in its name.
//!
//! `part-00000012-<checksum>.parquet` is written under another name and renamed, so that it is there whole or not at all;
//! what is damaged later shows by its sum. Any tool that reads Parquet reads the folder as one table.

mod part;

use std::collections::BTreeMap;
use std::fs::{self, File, TryLockError};
use std::path::{Path, PathBuf};

use super::chunk::{Cut, Done, Key, checksum};
use super::whole::whole;
use crate::batch::Outcome;
use crate::compare::Rows;
use crate::error::Error;
use crate::problem::Case;
use crate::study::Study;

/// Name of the store in a folder of results.
pub const STORE: &str = "store";

/// Held by the run that writes.
const LOCK: &str = "lock";

/// A store, opened and locked.
#[derive(Debug)]
pub struct Store {
    folder: PathBuf,
    /// Parts by the number of their chunk.
    parts: BTreeMap<u64, Vec<PathBuf>>,
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

    /// The outcomes of a chunk, if they are there whole and nothing has changed; else why not, if something is there.
    pub fn find(
        &self,
        study: &Study,
        chunk: u64,
        key: &Key,
        cases: &[(u64, Case)],
    ) -> Result<Vec<Outcome>, Option<String>> {
        let mut why = None;
        for path in self.parts.get(&chunk).into_iter().flatten() {
            let damaged = || Some(format!("{} is damaged", path.display()));
            let whole = fs::read(path)
                .ok()
                .filter(|bytes| named(path).is_some_and(|(_, sum)| checksum(bytes) == sum));
            let Some((kept, rows)) = whole.and_then(|bytes| part::read(study, bytes).ok()) else {
                why = damaged();
                continue;
            };
            match key.change(&kept) {
                Some(change) => why = why.or(Some(change.to_owned())),
                None if rows.len() == cases.len() => {
                    let cases = cases.iter().map(|(_, case)| case.clone());
                    let outcome = |(case, (metrics, failure))| Outcome {
                        case,
                        metrics,
                        solution: None,
                        failure,
                    };
                    return Ok(cases.zip(rows).map(outcome).collect());
                }
                None => why = damaged(),
            }
        }
        Err(why)
    }

    /// Keeps the outcomes of a chunk, in place of what was there.
    pub fn put(
        &self,
        study: &Study,
        chunk: u64,
        key: &Key,
        first: u64,
        outcomes: &[Outcome],
    ) -> Result<(), Error> {
        let bytes = part::written(study, key, first, outcomes)
            .map_err(|e| Error::Internal(format!("cannot make a part of the store: {e}")))?;
        let path = self
            .folder
            .join(format!("part-{chunk:08}-{}.parquet", checksum(&bytes)));
        whole(&path, |out| {
            use std::io::Write;
            out.write_all(&bytes)?;
            out.flush()?;
            // It may be needed after a power cut.
            out.get_ref().sync_data()
        })?;
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
        part::text(bytes, &mut rows).map_err(|_| damaged())?;
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

impl Done {
    /// Outcomes from the store.
    pub(super) fn kept(first: u64, outcomes: Vec<Outcome>) -> Done {
        Done {
            outcomes,
            first,
            kept: Ok(()),
        }
    }
}
