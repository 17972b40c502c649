//! The store of one study: a folder of Parquet parts, each checked by the sum in its name.
//!
//! `part-000000016384-<checksum>.parquet` is written under another name and renamed, so that it is there whole or not at
//! all; what is damaged later shows by its sum. Any tool that reads Parquet reads the folder as one table.

mod caught;
mod reading;
#[cfg(test)]
mod tests;
mod uniform;
mod writing;

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use super::chunk::starts_near;
use super::key::{Key, checksum};
use super::whole::{sweep, whole};
use crate::compare::Rows;
use crate::error::Error;
use crate::problem::cases::Cases;
use crate::solve::MetricTable;
use crate::study::Study;
use caught::caught;
use parquet::errors::ParquetError;
use uniform::Uniform;

/// Name of the store in a folder of results.
pub const STORE: &str = "store";

/// Column of the reason why a case could not be solved.
const FAILURE: &str = "failure";

/// Held by the run that writes. Its name begins with a point: pandas and pyarrow skip such files in a folder of parts.
const LOCK: &str = ".lock";

/// Its former name, which those tools take for a part.
const FORMER_LOCK: &str = "lock";

/// A store, opened and locked.
#[derive(Debug)]
pub struct Store {
    folder: PathBuf,
    /// Parts that were there, by the start in their names.
    parts: BTreeMap<u64, Vec<PathBuf>>,
    /// Parts of this run: found or written.
    own: Mutex<BTreeSet<PathBuf>>,
    uniform: Uniform,
    _lock: File,
}

impl Store {
    /// Opens the store of a folder of results, or makes it.
    ///
    /// # Errors
    /// [`Error::Busy`] while another run has it.
    pub fn open(results: &Path) -> Result<Store, Error> {
        Store::locked_by(results, |lock| lock.try_lock())
    }

    /// The same, but waits while another run has it.
    pub fn open_in_turn(results: &Path) -> Result<Store, Error> {
        Store::locked_by(results, |lock| lock.lock().map_err(TryLockError::Error))
    }

    fn locked_by(
        results: &Path,
        lock: impl Fn(&File) -> Result<(), TryLockError>,
    ) -> Result<Store, Error> {
        let folder = results.join(STORE);
        fs::create_dir_all(&folder).map_err(Error::io("cannot make folder", &folder))?;
        let lock = locked(&folder, lock)?;
        remove_former_lock(&folder);
        sweep(&folder);
        let mut parts: BTreeMap<u64, Vec<PathBuf>> = BTreeMap::new();
        for (start, path) in there(&folder)? {
            parts.entry(start).or_default().push(path);
        }
        Ok(Store {
            folder,
            parts,
            own: Mutex::default(),
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

    /// What was found of the cases of a part, if it is there whole and nothing has changed; else why not, if something is
    /// there.
    pub fn find(
        &self,
        study: &Study,
        start: u64,
        key: &Key,
        cases: usize,
    ) -> Result<MetricTable, Option<String>> {
        let mut why = None;
        for path in self.parts.get(&start).into_iter().flatten() {
            let whole = whole_part(path);
            // A sum is no signature: what a forged part holds may be anything.
            let read = |bytes| caught(|| reading::read(study, bytes, key, cases).ok()).flatten();
            match whole.and_then(read) {
                Some(Ok(found)) => {
                    self.own().insert(path.clone());
                    return Ok(found);
                }
                Some(Err(change)) => why = why.or(Some(change.to_owned())),
                None => why = Some(format!("{} is damaged", path.display())),
            }
        }
        Err(why)
    }

    /// Cases of former parts near a part that was not found, by the identities of their parameters.
    pub fn former(&self, study: &Study, start: u64, key: &Key) -> Former {
        let mut former = Former::default();
        for path in self.parts.range(starts_near(start)).flat_map(|(_, p)| p) {
            let whole = whole_part(path);
            let read = |bytes| caught(|| reading::former(study, bytes, key).ok()).flatten();
            if let Some((identities, found)) = whole.and_then(read).flatten() {
                let part = former.found.len();
                let rows = identities.into_iter().enumerate();
                let rows = rows.map(|(row, identity)| (identity, (part, row)));
                former.rows.extend(rows);
                former.found.push(found);
            }
        }
        former
    }

    /// Keeps what was found of a part.
    pub fn put(
        &self,
        study: &Study,
        start: u64,
        key: &Key,
        cases: (u64, &Cases),
        found: &MetricTable,
    ) -> Result<(), Error> {
        let bytes = writing::written(study, key, cases, found, &self.uniform)
            .map_err(|e| Error::Internal(format!("cannot make a part of the store: {e}")))?;
        let path = self
            .folder
            .join(format!("part-{start:012}-{}.parquet", checksum(&bytes)));
        // Not waited for until it is on the disk: what a power cut takes away shows by its sum.
        whole(&path, |out| out.write_all(&bytes))?;
        // What it replaces stays until `close`: other parts may find cases in it.
        self.own().insert(path);
        Ok(())
    }

    /// Removes every part that is not of this run, which has handed over all its cases: the store then holds these. A copy
    /// under another name `part-*.parquet` goes too, since tools that read the folder would read it.
    ///
    /// # Errors
    /// A part that cannot be removed.
    pub fn close(self) -> Result<(), Error> {
        let own = self.own();
        let mut failed = None;
        for path in like_parts(&self.folder)? {
            if !own.contains(&path)
                && let Err(e) = fs::remove_file(&path)
                && e.kind() != ErrorKind::NotFound
            {
                failed = failed.or(Some((path, e)));
            }
        }
        match failed {
            None => Ok(()),
            Some((path, e)) => {
                let why = format!("{e}; its rows are not of this study");
                Err(Error::io("cannot remove", path)(io::Error::new(
                    e.kind(),
                    why,
                )))
            }
        }
    }

    fn own(&self) -> MutexGuard<'_, BTreeSet<PathBuf>> {
        self.own.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Cases of former parts.
#[derive(Debug, Default)]
pub struct Former {
    /// Part and row by the identity of the parameters.
    rows: HashMap<u128, (usize, usize)>,
    found: Vec<MetricTable>,
}

impl Former {
    /// What was found of the case with this identity.
    pub fn get(&self, identity: u128) -> Option<(&MetricTable, usize)> {
        let (part, row) = self.rows.get(&identity)?;
        Some((&self.found[*part], *row))
    }
}

/// The bytes of a part, where its name has their sum.
fn whole_part(path: &Path) -> Option<Vec<u8>> {
    let bytes = fs::read(path).ok()?;
    named(path)
        .is_some_and(|(_, sum)| checksum(&bytes) == sum)
        .then_some(bytes)
}

/// Opens and locks the file that a run holds.
fn locked(folder: &Path, take: impl Fn(&File) -> Result<(), TryLockError>) -> Result<File, Error> {
    let path = folder.join(LOCK);
    // A link could lead to a file of the user's.
    if fs::symlink_metadata(&path).is_ok_and(|there| !there.is_file()) {
        let why = io::Error::other("it is not a file; remove it");
        return Err(Error::io("cannot lock", path)(why));
    }
    let mut options = OpenOptions::new();
    let options = options.read(true).write(true).create(true).truncate(false);
    let lock = options
        .open(&path)
        .map_err(Error::io("cannot write", &path))?;
    match take(&lock) {
        Ok(()) => Ok(lock),
        Err(TryLockError::WouldBlock) => Err(Error::Busy(folder.to_owned())),
        Err(TryLockError::Error(e)) => Err(Error::io("cannot lock", path)(e)),
    }
}

/// Removes the lock that an earlier version left: an empty file, which no run holds.
fn remove_former_lock(folder: &Path) {
    let path = folder.join(FORMER_LOCK);
    if fs::symlink_metadata(&path).is_ok_and(|there| there.is_file() && there.len() == 0)
        && let Ok(file) = File::open(&path)
        && file.try_lock().is_ok()
    {
        let _ = fs::remove_file(path);
    }
}

/// The parts in a folder, with the start in their names.
fn there(folder: &Path) -> Result<Vec<(u64, PathBuf)>, Error> {
    let start = |path: &PathBuf| named(path).map(|(start, _)| start);
    let all = like_parts(folder)?.into_iter();
    let mut parts: Vec<_> = all.filter_map(|path| Some((start(&path)?, path))).collect();
    parts.sort();
    Ok(parts)
}

/// The files `part-*.parquet` in a folder.
fn like_parts(folder: &Path) -> Result<Vec<PathBuf>, Error> {
    let mut found = Vec::new();
    let unread = |e| Error::io("cannot read", folder)(e);
    for entry in fs::read_dir(folder).map_err(unread)? {
        let entry = entry.map_err(unread)?;
        let name = entry.file_name();
        let name = name.to_string_lossy();
        let like = name.starts_with("part-") && name.ends_with(".parquet");
        if like && !entry.file_type().map_err(unread)?.is_dir() {
            found.push(entry.path());
        }
    }
    Ok(found)
}

/// The results in the store of a folder, as text.
///
/// # Errors
/// A part that cannot be read, or is damaged.
pub fn rows(results: &Path) -> Result<Rows, Error> {
    let folder = results.join(STORE);
    let mut rows = Rows::default();
    for (_, path) in there(&folder)? {
        let bytes = fs::read(&path).map_err(Error::io("cannot read", &path))?;
        let good = named(&path).is_some_and(|(_, sum)| checksum(&bytes) == sum);
        let damaged = || {
            let source = io::Error::other("damaged; run the study again");
            Error::io("cannot read", &path)(source)
        };
        if !good {
            return Err(damaged());
        }
        let read = caught(|| reading::text(bytes));
        rows.extend(read.and_then(Result::ok).ok_or_else(damaged)?);
    }
    Ok(rows)
}

/// Start and checksum in the name of a part; a name that no run gives is not a part's.
fn named(path: &Path) -> Option<(u64, &str)> {
    let name = path.file_name()?.to_str()?;
    let rest = name.strip_prefix("part-")?.strip_suffix(".parquet")?;
    let (start, sum) = rest.split_once('-')?;
    let digits = start.len() >= 8 && start.bytes().all(|b| b.is_ascii_digit());
    let hexadecimal = |b: u8| matches!(b, b'0'..=b'9' | b'a'..=b'f');
    let own = digits && sum.len() == 32 && sum.bytes().all(hexadecimal);
    Some((start.parse().ok().filter(|_| own)?, sum))
}

fn general(what: &str) -> ParquetError {
    ParquetError::General(what.into())
}
