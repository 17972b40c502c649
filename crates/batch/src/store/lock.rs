//! The lock of a store: one run uses it at a time.

use crate::files::locks::{self, Locked};
use slipgap_study::error::Error;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io;
use std::path::Path;

/// Locked by the run that writes. pandas and pyarrow skip files whose names begin with a point.
const LOCK: &str = ".lock";

/// The name in an earlier version, which these programs read as a part.
const FORMER_LOCK: &str = "lock";

/// A lock of a store until it is dropped.
#[derive(Debug)]
pub struct Lock(File);

impl Drop for Lock {
    /// Unlocks the file. Closing it would not do: a process that is started at this moment has the file open, too.
    fn drop(&mut self) {
        let _ = self.0.unlock();
    }
}

/// Opens the lock file and locks it by `acquire`. On a file system without locks the run goes on without.
pub fn acquire(
    folder: &Path,
    acquire: impl Fn(&File) -> Result<(), TryLockError>,
) -> Result<Lock, Error> {
    let path = folder.join(LOCK);
    // A link could lead to a file of the user.
    if fs::symlink_metadata(&path).is_ok_and(|metadata| !metadata.is_file()) {
        let why = io::Error::other("it is not a file; remove it");
        return Err(Error::io("cannot lock", path)(why));
    }
    let lock = OpenOptions::new()
        .read(true)
        .write(true)
        .create(true)
        .truncate(false)
        .open(&path)
        .map_err(Error::io("cannot write", &path))?;
    match locks::lock(&lock, acquire) {
        Ok(Locked::Here | Locked::Unknown) => Ok(Lock(lock)),
        Ok(Locked::Elsewhere) => Err(Error::Busy(folder.to_owned())),
        Err(e) => Err(Error::io("cannot lock", path)(e)),
    }
}

/// Removes the lock file, which this process has locked.
pub fn remove(folder: &Path) {
    let _ = fs::remove_file(folder.join(LOCK));
}

/// Removes the lock of an earlier version: an empty file that is not locked.
pub fn remove_former(folder: &Path) {
    let path = folder.join(FORMER_LOCK);
    if fs::symlink_metadata(&path).is_ok_and(|metadata| metadata.is_file() && metadata.len() == 0)
        && let Ok(file) = File::open(&path)
        && file.try_lock().is_ok()
    {
        let _ = fs::remove_file(path);
    }
}
