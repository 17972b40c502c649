//! Files that are there whole or not at all.

use crate::error::Error;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::{PoisonError, RwLock, RwLockWriteGuard};

/// Shared by all who write a file, from its beginning until it has its name.
static WRITING: RwLock<()> = RwLock::new(());

/// Waits for the files that are being written, and lets no further one begin while the guard lives.
pub fn no_more_writing() -> RwLockWriteGuard<'static, ()> {
    WRITING.write().unwrap_or_else(PoisonError::into_inner)
}

/// Writes a file under a temporary name and renames it: it is there whole or not at all.
pub(super) fn whole(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
) -> Result<(), Error> {
    let _writing = WRITING.read().unwrap_or_else(PoisonError::into_inner);
    let mut partial = path.as_os_str().to_owned();
    partial.push(".partial");
    let partial = PathBuf::from(partial);
    File::create(&partial)
        .map(BufWriter::new)
        .and_then(|mut out| write(&mut out).and_then(|()| out.flush()))
        .and_then(|()| fs::rename(&partial, path))
        .map_err(|e| {
            let _ = fs::remove_file(&partial);
            Error::io("cannot write", path)(e)
        })
}
