//! The store of a study: a folder of Parquet parts, or a prefix of an object store, each with its checksum in its name.
//!
//! `part-000000016384-<checksum>.parquet` is written under a temporary name and renamed, so that it is complete or absent.
//! The checksum detects later damage. The parts of a large study are in sub-folders `000000`, `000001`, so that none has very
//! many names. Any program that reads Parquet can read the folder as one table.

mod catch_panic;
mod constant_columns;
mod earlier_cases;
pub mod key;
mod lock;
mod miss;
mod numbers;
mod parquet_columns;
mod part_file;
mod reading;
mod rows;
mod streams;
#[cfg(test)]
mod tests;
mod writing;

pub use earlier_cases::EarlierCases;
pub use miss::Miss;
pub use part_file::{STORE, all_in, checked_summary, rows, summary};
pub use reading::Summary;
pub use rows::Rows;

use std::collections::{BTreeMap, BTreeSet};
use std::fs::{File, TryLockError};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use super::chunks::chunk::{self, starts_in_same_chunk};
use super::files::atomic::{can_write, remove_leftovers, write_atomically};
use super::files::heartbeat::remove_signs;
use super::files::place::{is_object, make_folder, remove_empty_folder, remove_file};
use bytes::Bytes;
use catch_panic::catch_panic;
use constant_columns::ConstantColumns;
use key::{Difference, Key, checksum};
use slipgap_motion::solve::MetricTable;
use slipgap_problem::problem::table::cases::Cases;
use slipgap_study::Study;
use slipgap_study::error::Error;

/// How often a part is written again whose temporary file another process has removed.
const ATTEMPTS: usize = 5;

/// A store. The run that opens it alone has locked it, if the file system has locks. An object store has none.
#[derive(Debug)]
pub struct Store {
    folder: PathBuf,
    /// Parts of earlier runs, by the start in their names.
    parts: BTreeMap<u64, Vec<PathBuf>>,
    /// Parts of this run: loaded or saved.
    current: Mutex<BTreeSet<PathBuf>>,
    constant_columns: ConstantColumns,
    /// Whether other processes write to the store.
    shared: bool,
    lock: Option<lock::Lock>,
}

impl Store {
    /// Opens the store of a folder of results, or makes it.
    ///
    /// # Errors
    /// [`Error::Busy`] if another run uses it.
    pub fn open(results: &Path) -> Result<Store, Error> {
        Store::open_with(results, |lock| lock.try_lock())
    }

    /// Opens the store, or makes it, and waits while another run uses it.
    pub fn wait_and_open(results: &Path) -> Result<Store, Error> {
        Store::open_with(results, |lock| lock.lock().map_err(TryLockError::Error))
    }

    /// Opens the store for a shard, beside others, or makes it. No lock is taken and no file removed.
    pub fn open_shared(results: &Path) -> Result<Store, Error> {
        let folder = Store::make_folder(results)?;
        Store::of_folder(folder, None, true)
    }

    fn open_with(
        results: &Path,
        acquire: impl Fn(&File) -> Result<(), TryLockError>,
    ) -> Result<Store, Error> {
        let folder = Store::make_folder(results)?;
        let lock = match is_object(&folder) {
            true => None,
            false => Some(lock::acquire(&folder, acquire)?),
        };
        lock::remove_former(&folder);
        part_file::folders(&folder)?
            .iter()
            .for_each(|folder| remove_leftovers(folder));
        Store::of_folder(folder, lock, false)
    }

    fn make_folder(results: &Path) -> Result<PathBuf, Error> {
        let folder = results.join(STORE);
        make_folder(&folder).map_err(Error::io("cannot make folder", &folder))?;
        Ok(folder)
    }

    fn of_folder(folder: PathBuf, lock: Option<lock::Lock>, shared: bool) -> Result<Store, Error> {
        let mut store = Store {
            folder,
            parts: BTreeMap::new(),
            current: Mutex::default(),
            constant_columns: ConstantColumns::default(),
            shared,
            lock,
        };
        store.list_parts()?;
        Ok(store)
    }

    /// Lists the parts again, also those that other machines have saved.
    ///
    /// # Errors
    /// A folder that cannot be written or read.
    pub fn list_again(&mut self) -> Result<(), Error> {
        // A client of NFS may list a folder as it was up to a minute ago, unless it has changed the folder itself.
        for folder in part_file::folders(&self.folder)? {
            can_write(&folder).map_err(Error::io("cannot write in folder", &folder))?;
        }
        self.list_parts()
    }

    fn list_parts(&mut self) -> Result<(), Error> {
        self.parts.clear();
        for (start, path) in part_file::all_in(&self.folder)? {
            self.parts.entry(start).or_default().push(path);
        }
        Ok(())
    }

    /// The folder.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Whether the store had no parts when it was opened.
    pub fn is_empty(&self) -> bool {
        self.parts.is_empty()
    }

    /// The metrics of a part with so many cases, if a stored part is undamaged and has the same key.
    pub fn load(
        &self,
        study: &Study,
        start: u64,
        key: &Key,
        cases: usize,
    ) -> Result<MetricTable, Miss> {
        self.find(start, |bytes| reading::read(study, bytes, key, cases))
    }

    /// What `read` finds in the first undamaged part with this start and the right key.
    fn find<T>(
        &self,
        start: u64,
        read: impl Fn(Vec<u8>) -> parquet::errors::Result<Result<T, Difference>>,
    ) -> Result<T, Miss> {
        let mut miss = Miss::Absent;
        for path in self.parts.get(&start).into_iter().flatten() {
            let bytes = part_file::read_checked(path)?;
            // The checksum is not a signature: a manipulated part can have any content.
            let read = |bytes| catch_panic(|| read(bytes).ok()).flatten();
            match bytes.and_then(read) {
                Some(Ok(found)) => {
                    self.current().insert(path.clone());
                    return Ok(found);
                }
                Some(Err(difference)) if miss == Miss::Absent => miss = Miss::Outdated(difference),
                Some(Err(_)) => {}
                None => miss = Miss::Damaged(path.clone()),
            }
        }
        Err(miss)
    }

    /// Whether [`Store::load`] would give the metrics of the part. They are not decoded.
    pub fn check(&self, start: u64, key: &Key, cases: usize) -> Result<(), Miss> {
        self.find(start, |bytes| reading::check(bytes, key, cases))
    }

    /// The cases of stored parts of the same chunk.
    pub fn earlier_cases(&self, study: &Study, start: u64, key: &Key) -> EarlierCases {
        let mut earlier = EarlierCases::default();
        let parts = self.parts.range(starts_in_same_chunk(study, start));
        // Up to one that a server does not give: each of the others would be waited for, too.
        let checked = parts
            .flat_map(|(_, paths)| paths)
            .map_while(|path| part_file::read_checked(path).ok());
        for bytes in checked.flatten() {
            let read = catch_panic(|| reading::read_hashed(study, bytes, key).ok());
            if let Some((hashes, metrics)) = read.flatten().flatten() {
                earlier.add(hashes, metrics);
            }
        }
        earlier
    }

    /// Writes a part. `cases` has the number of the first case.
    pub fn save(
        &self,
        study: &Study,
        start: u64,
        key: &Key,
        cases: (u64, &Cases),
        metrics: &MetricTable,
    ) -> Result<(), Error> {
        let pieces = writing::encode(study, key, cases, metrics, &self.constant_columns)
            .map_err(|e| Error::Internal(format!("cannot make a part of the store: {e}")))?;
        let folder = chunk::folder(study, start)
            .map(part_file::folder_name)
            .map_or(self.folder.clone(), |name| self.folder.join(name));
        let path = folder.join(part_file::name(start, &checksum(&pieces)));
        self.write(&path, &pieces)?;
        // The parts that it replaces remain until `close`: other parts may use their cases.
        self.current().insert(path);
        Ok(())
    }

    /// Writes the file of a part.
    fn write(&self, path: &Path, pieces: &[Bytes]) -> Result<(), Error> {
        let write = || {
            // A merge that finds no parts removes the folders that it has made.
            if let Some(folder) = path.parent() {
                make_folder(folder).map_err(Error::io("cannot make folder", folder))?;
            }
            write_atomically(path, |out| {
                out.write_pieces(pieces)?;
                // A run does not wait for the disk: after a power failure the checksum shows a damaged part. A shard reports
                // its parts as kept to other machines, and only now is it certain that the server has them, and the space.
                if self.shared { out.sync() } else { Ok(()) }
            })
        };
        let mut written = write();
        // Locks may hold only on one machine, so that a run on another one takes the temporary file for a leftover.
        for _ in 0..ATTEMPTS {
            match &written {
                Err(Error::Io { source, .. }) if source.kind() == ErrorKind::NotFound => {
                    written = write();
                }
                _ => break,
            }
        }
        written
    }

    /// Whether the store has the parts that this process has saved or found: a server may have lost some.
    pub fn check_kept(&self) -> Result<(), Error> {
        part_file::check_kept(&self.folder, &self.current())
    }

    /// Removes every part that is not of this run, after all cases were run. All files `part-*.parquet` are removed, also
    /// copies under other names, because programs that read the folder would read them.
    ///
    /// # Errors
    /// A part that cannot be removed; one of this run that another run of an object store, which has no lock, has removed.
    pub fn close(self) -> Result<(), Error> {
        self.check_kept()?;
        let current = self.current();
        let mut failed = None;
        for path in part_file::similar_in(&self.folder)? {
            if !current.contains(&path)
                && let Err(e) = remove_file(&path)
                && e.kind() != ErrorKind::NotFound
            {
                failed = failed.or(Some((path, e)));
            }
        }
        remove_signs(&self.folder);
        // Sub-folders without parts.
        for folder in part_file::folders(&self.folder)?.iter().skip(1) {
            remove_empty_folder(folder);
        }
        let Some((path, e)) = failed else {
            return part_file::check_kept(&self.folder, &current);
        };
        let why = io::Error::new(e.kind(), format!("{e}; its rows are not of this study"));
        Err(Error::io("cannot remove", path)(why))
    }

    /// Closes the store without a change. If it has no parts, its lock is removed.
    pub fn leave(self) {
        if self.is_empty() && self.lock.is_some() {
            lock::remove(&self.folder);
        }
    }

    fn current(&self) -> MutexGuard<'_, BTreeSet<PathBuf>> {
        self.current.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
