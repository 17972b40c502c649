//! Files that are there whole or not at all: written under a name of their own, then renamed.
//!
//! The temporary name is random and new, so that no process and no link can have it, and its file is locked while it is
//! written, so that what a killed run left can be told from what another run is writing.

use crate::error::Error;
use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError, RwLock, RwLockReadGuard, RwLockWriteGuard};
use tempfile::{Builder, NamedTempFile};

/// Beginning and end of every temporary name.
const NAME: [&str; 2] = [".slipgap-", ".partial"];

/// Random letters and digits between them.
const RANDOM: usize = 12;

/// Shared by all who write a file at once or give one its name.
static WRITING: RwLock<()> = RwLock::new(());

/// Files that grow over a whole run.
static GROWING: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// Waits for the files that are being written, lets no further one begin or get its name while the guard lives, and
/// removes those that are not whole.
pub fn no_more_writing() -> RwLockWriteGuard<'static, ()> {
    let guard = WRITING.write().unwrap_or_else(PoisonError::into_inner);
    for partial in growing().iter() {
        let _ = fs::remove_file(partial);
    }
    guard
}

/// Writes a file at once.
pub(super) fn whole(
    path: &Path,
    write: impl FnOnce(&mut Growing) -> io::Result<()>,
) -> Result<(), Error> {
    let _writing = writing();
    let mut out = Growing::new(path)?;
    write(&mut out).map_err(Error::io("cannot write", path))?;
    out.named()
}

/// A file as it grows; it goes where it does not come to [`Growing::finish`].
#[derive(Debug)]
pub struct Growing {
    path: PathBuf,
    /// There until it has its name.
    out: Option<BufWriter<NamedTempFile>>,
    partial: PathBuf,
}

impl Growing {
    /// Begins what is to be `path`, in the same folder.
    pub fn begin(path: &Path) -> Result<Growing, Error> {
        let _writing = writing();
        Growing::new(path)
    }

    fn new(path: &Path) -> Result<Growing, Error> {
        let folder = path.parent().unwrap_or(Path::new("."));
        let file = temporary(folder).map_err(Error::io("cannot write", path))?;
        let partial = file.path().to_owned();
        growing().insert(partial.clone());
        Ok(Growing {
            path: path.to_owned(),
            out: Some(BufWriter::new(file)),
            partial,
        })
    }

    /// Gives it its name, in place of what has it.
    pub fn finish(self) -> Result<(), Error> {
        let _writing = writing();
        self.named()
    }

    /// Waits until what is written is on the disk.
    pub fn sync(&mut self) -> io::Result<()> {
        self.flush()?;
        match &self.out {
            Some(out) => out.get_ref().as_file().sync_data(),
            None => Ok(()),
        }
    }

    fn named(mut self) -> Result<(), Error> {
        let Some(out) = self.out.take() else {
            return Ok(());
        };
        let renamed = match out.into_inner() {
            Ok(file) => file.persist(&self.path).map_err(|e| e.error),
            Err(e) => Err(e.into_error()),
        };
        renamed.map_err(Error::io("cannot write", &self.path))?;
        Ok(())
    }
}

impl Write for Growing {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.out {
            Some(out) => out.write(bytes),
            None => Err(io::ErrorKind::BrokenPipe.into()),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.as_mut().map_or(Ok(()), Write::flush)
    }
}

impl Drop for Growing {
    fn drop(&mut self) {
        // Without the name it goes, with what was not written yet.
        if let Some(out) = self.out.take() {
            let (file, _) = out.into_parts();
            drop(file);
        }
        growing().remove(&self.partial);
    }
}

/// Whether files can be written in a folder: an answer before any computing.
pub(super) fn can_write(folder: &Path) -> io::Result<()> {
    temporary(folder).map(drop)
}

/// Removes from a folder what killed runs left of the files that they were writing.
pub(super) fn sweep(folder: &Path) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let partial = is_temporary(&entry.file_name());
        if !partial || !entry.file_type().is_ok_and(|kind| kind.is_file()) {
            continue;
        }
        // While it is being written, it is locked.
        if let Ok(file) = File::open(entry.path())
            && file.try_lock().is_ok()
        {
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// A new file under a random name, locked.
fn temporary(folder: &Path) -> io::Result<NamedTempFile> {
    let folder = if folder.as_os_str().is_empty() {
        Path::new(".")
    } else {
        folder
    };
    let new = |path: &Path| {
        let mut options = OpenOptions::new();
        options.read(true).write(true).create_new(true).open(path)
    };
    loop {
        let file = Builder::new()
            .prefix(NAME[0])
            .suffix(NAME[1])
            .rand_bytes(RANDOM)
            .make_in(folder, new)?;
        // Where there are no locks, nothing is swept either.
        let _ = file.as_file().lock();
        // Another run may have swept it before it was locked.
        if fs::symlink_metadata(file.path()).is_ok() {
            return Ok(file);
        }
    }
}

/// Whether a name is one that [`temporary`] gives.
fn is_temporary(name: &OsStr) -> bool {
    let name = name.to_str().and_then(|name| name.strip_prefix(NAME[0]));
    let random = name.and_then(|name| name.strip_suffix(NAME[1]));
    random.is_some_and(|r| r.len() == RANDOM && r.bytes().all(|b| b.is_ascii_alphanumeric()))
}

fn writing() -> RwLockReadGuard<'static, ()> {
    WRITING.read().unwrap_or_else(PoisonError::into_inner)
}

fn growing() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    GROWING.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).unwrap().map(Result::unwrap);
        let mut names: Vec<String> = entries
            .map(|e| e.file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    #[test]
    fn a_file_is_there_whole_or_not_at_all() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.csv");
        fs::write(&path, "former").unwrap();
        let fails = whole(&path, |out| {
            out.write_all(b"half")?;
            Err(io::Error::other("no more"))
        });
        assert!(fails.is_err());
        assert_eq!(names(folder.path()), ["a.csv"]);
        let mut growing = Growing::begin(&path).unwrap();
        growing.write_all(&[b'x'; 1 << 17]).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"former");
        drop(growing);
        assert_eq!(names(folder.path()), ["a.csv"]);
        whole(&path, |out| out.write_all(b"new")).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
        assert_eq!(names(folder.path()), ["a.csv"]);
    }

    #[test]
    fn what_a_killed_run_left_is_swept_and_what_is_being_written_is_not() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.csv");
        let mut growing = Growing::begin(&path).unwrap();
        let [live] = &names(folder.path())[..] else {
            panic!("one file is being written");
        };
        let own = [
            ".slipgap-probe",
            ".slipgap-.partial",
            ".slipgap-0123456789a.partial",
            "results.csv.partial",
        ];
        for name in own.iter().chain(&[".slipgap-0123456789aB.partial"]) {
            fs::write(folder.path().join(name), "left").unwrap();
        }
        sweep(folder.path());
        let mut kept: Vec<&str> = own.into_iter().chain([live.as_str()]).collect();
        kept.sort_unstable();
        assert_eq!(names(folder.path()), kept);
        growing.write_all(b"whole").unwrap();
        growing.finish().unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"whole");
    }

    #[cfg(unix)]
    #[test]
    fn no_link_is_followed() {
        let folder = tempfile::tempdir().unwrap();
        let (mine, link) = (folder.path().join("mine"), folder.path().join("a.csv"));
        fs::write(&mine, "mine").unwrap();
        std::os::unix::fs::symlink(&mine, &link).unwrap();
        whole(&link, |out| out.write_all(b"new")).unwrap();
        assert_eq!(fs::read(&mine).unwrap(), b"mine");
        assert_eq!(fs::read(&link).unwrap(), b"new");
        // Not by a sweep either: a link is no file of a run.
        let left = folder.path().join(".slipgap-0123456789aB.partial");
        std::os::unix::fs::symlink(&mine, &left).unwrap();
        sweep(folder.path());
        assert!(fs::symlink_metadata(&left).is_ok() && mine.exists());
    }
}
