//! Files that are complete or absent: written under a temporary name, then renamed. What becomes an object is uploaded instead,
//! from a folder for temporary files.
//!
//! The temporary name is random and new, so that no other process and no link can have it. The file is locked while it is
//! written, which distinguishes the files of another run from those that a killed run left.

use super::locks::{self, Locked};
use super::place::is_object;
use super::{objects, place};
use slipgap_study::error::Error;
use std::borrow::Cow;
use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, IoSlice, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError, RwLock, RwLockReadGuard, RwLockWriteGuard};
use std::time::Duration;
use tempfile::{Builder, NamedTempFile};

/// Beginning and end of every temporary name.
const NAME: [&str; 2] = [".slipgap-", ".partial"];

/// Age at which a temporary file is surely of a killed run, on a file system without locks.
const DEAD: Duration = Duration::from_secs(24 * 3600);

/// Number of random letters and digits between them.
const RANDOM: usize = 12;

/// Read-locked while a file is written at once, created or renamed.
static WRITING: RwLock<()> = RwLock::new(());

/// Temporary files that exist.
static TEMPORARY: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// Waits for files that are written at once, removes all temporary files, and prevents new ones until the guard is
/// dropped.
pub fn stop_writing() -> RwLockWriteGuard<'static, ()> {
    let guard = WRITING.write().unwrap_or_else(PoisonError::into_inner);
    for path in temporary_files().iter() {
        let _ = fs::remove_file(path);
    }
    guard
}

/// Writes a file at once.
pub(crate) fn write_atomically(
    path: &Path,
    write: impl FnOnce(&mut AtomicFile) -> io::Result<()>,
) -> Result<(), Error> {
    let _writing = writing(path);
    let mut out = AtomicFile::new(path)?;
    write(&mut out).map_err(Error::io("cannot write", path))?;
    out.rename()
}

/// Writes a file at once, in a folder that exists; replaces a file of this name, and nothing else.
///
/// # Errors
/// A link, a folder, a device or a pipe has this name, or the file cannot be written.
pub fn write_file(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    write_atomically(path, |out| out.write_all(bytes))
}

/// A file under a temporary name. It is removed unless it is committed.
#[derive(Debug)]
pub struct AtomicFile {
    path: PathBuf,
    /// `None` after the file was renamed.
    out: Option<BufWriter<NamedTempFile>>,
    temporary: PathBuf,
}

impl AtomicFile {
    /// Creates the temporary file of `path`, in the same folder.
    pub fn create(path: &Path) -> Result<AtomicFile, Error> {
        let _writing = writing(path);
        AtomicFile::new(path)
    }

    fn new(path: &Path) -> Result<AtomicFile, Error> {
        refuse_others(path).map_err(Error::io("cannot write", path))?;
        let folder = path.parent().unwrap_or(Path::new("."));
        let file =
            new_temporary(&of_temporaries(folder)).map_err(Error::io("cannot write", path))?;
        let temporary = file.path().to_owned();
        temporary_files().insert(temporary.clone());
        Ok(AtomicFile {
            path: path.to_owned(),
            out: Some(BufWriter::new(file)),
            temporary,
        })
    }

    /// Gives the file its final name and replaces a file of that name.
    pub fn commit(self) -> Result<(), Error> {
        let _writing = writing(&self.path);
        self.rename()
    }

    /// Writes pieces one after the other, as few of them as possible at a time: the system then finds larger pages for them.
    pub fn write_pieces(&mut self, pieces: &[impl AsRef<[u8]>]) -> io::Result<()> {
        self.flush()?;
        let mut file = match &self.out {
            Some(out) => out.get_ref().as_file(),
            None => return Err(io::ErrorKind::BrokenPipe.into()),
        };
        let of_pieces = pieces.iter().map(|piece| IoSlice::new(piece.as_ref()));
        let mut slices: Vec<IoSlice> = of_pieces.filter(|slice| !slice.is_empty()).collect();
        let mut left = &mut slices[..];
        while !left.is_empty() {
            match file.write_vectored(left) {
                Ok(0) => return Err(io::ErrorKind::WriteZero.into()),
                Ok(written) => IoSlice::advance_slices(&mut left, written),
                Err(e) if e.kind() == io::ErrorKind::Interrupted => {}
                Err(e) => return Err(e),
            }
        }
        Ok(())
    }

    /// Waits until everything written is on the disk.
    pub fn sync(&mut self) -> io::Result<()> {
        self.flush()?;
        match &self.out {
            Some(out) => out.get_ref().as_file().sync_data(),
            None => Ok(()),
        }
    }

    fn rename(mut self) -> Result<(), Error> {
        let Some(out) = self.out.take() else {
            return Ok(());
        };
        let renamed = match out.into_inner() {
            Ok(file) if is_object(&self.path) => objects::write(&self.path, file.path()),
            Ok(file) => file.persist(&self.path).map(drop).map_err(|e| e.error),
            Err(e) => Err(e.into_error()),
        };
        renamed.map_err(Error::io("cannot write", &self.path))
    }
}

impl Write for AtomicFile {
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

impl Drop for AtomicFile {
    fn drop(&mut self) {
        // Without its final name the file is removed. The rest of the buffer is not written.
        if let Some(out) = self.out.take() {
            let (file, _) = out.into_parts();
            drop(file);
        }
        temporary_files().remove(&self.temporary);
    }
}

/// What is at the path must be a file or absent: a device, a FIFO or a link would be replaced.
fn refuse_others(path: &Path) -> io::Result<()> {
    match fs::symlink_metadata(path) {
        Ok(found) if !found.is_file() => {
            let kind = if found.is_symlink() {
                "a link"
            } else if found.is_dir() {
                "a folder"
            } else {
                "a device or pipe"
            };
            let why = format!(
                "there is {kind}, which is not replaced; give the path of a file or a new one"
            );
            Err(io::Error::new(io::ErrorKind::AlreadyExists, why))
        }
        _ => Ok(()),
    }
}

/// Whether files can be written in a folder.
pub(crate) fn can_write(folder: &Path) -> io::Result<()> {
    match is_object(folder) {
        // Only that the bucket answers: the first upload shows the rest.
        true => place::entries(folder).map(drop),
        false => new_temporary(folder).map(drop),
    }
}

/// Removes the temporary files of killed runs from a folder.
pub(crate) fn remove_leftovers(folder: &Path) {
    let folder = of_temporaries(folder);
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let temporary = is_temporary(&entry.file_name());
        if !temporary || !entry.file_type().is_ok_and(|kind| kind.is_file()) {
            continue;
        }
        if is_dead(&entry.path()) {
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// Whether nobody writes a temporary file any more. A file that is being written is locked. Where files cannot be locked, the
/// age decides: a file is written within seconds.
fn is_dead(path: &Path) -> bool {
    let Ok(file) = File::open(path) else {
        return false;
    };
    match locks::lock(&file, |file| file.try_lock()) {
        Ok(Locked::Here) => true,
        Ok(Locked::Unknown) => {
            let modified = file.metadata().and_then(|metadata| metadata.modified());
            let age = modified.ok().and_then(|time| time.elapsed().ok());
            age.is_some_and(|age| age > DEAD)
        }
        Ok(Locked::Elsewhere) | Err(_) => false,
    }
}

/// The folder in which the files of a folder are written.
fn of_temporaries(folder: &Path) -> Cow<'_, Path> {
    match is_object(folder) {
        true => Cow::Owned(std::env::temp_dir()),
        false => Cow::Borrowed(folder),
    }
}

/// A new file under a random name, locked.
fn new_temporary(folder: &Path) -> io::Result<NamedTempFile> {
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
        // A file system may have no locks; see `is_dead`.
        let _ = file.as_file().lock();
        // Another run may have removed the file before it was locked.
        if fs::symlink_metadata(file.path()).is_ok() {
            return Ok(file);
        }
    }
}

/// Whether an interrupt, as of Ctrl-C, removes this file, too.
pub(super) fn remove_when_interrupted(path: &Path, removed: bool) {
    match removed {
        true => temporary_files().insert(path.to_owned()),
        false => temporary_files().remove(path),
    };
}

/// Whether a name is a temporary name.
fn is_temporary(name: &OsStr) -> bool {
    let name = name.to_str().and_then(|name| name.strip_prefix(NAME[0]));
    let random = name.and_then(|name| name.strip_suffix(NAME[1]));
    random.is_some_and(|r| r.len() == RANDOM && r.bytes().all(|b| b.is_ascii_alphanumeric()))
}

/// `None` for an object: nobody sees it before its upload has ended, for which an interrupted program need not wait.
pub(super) fn writing(path: &Path) -> Option<RwLockReadGuard<'static, ()>> {
    let guard = || WRITING.read().unwrap_or_else(PoisonError::into_inner);
    (!is_object(path)).then(guard)
}

fn temporary_files() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    TEMPORARY.lock().unwrap_or_else(PoisonError::into_inner)
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
    fn a_file_is_complete_or_absent() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.csv");
        fs::write(&path, "old").unwrap();
        let fails = write_atomically(&path, |out| {
            out.write_all(b"half")?;
            Err(io::Error::other("no more"))
        });
        assert!(fails.is_err());
        assert_eq!(names(folder.path()), ["a.csv"]);
        let mut file = AtomicFile::create(&path).unwrap();
        file.write_all(&[b'x'; 1 << 17]).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"old");
        drop(file);
        assert_eq!(names(folder.path()), ["a.csv"]);
        write_atomically(&path, |out| out.write_all(b"new")).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
        assert_eq!(names(folder.path()), ["a.csv"]);
    }

    #[test]
    fn pieces_follow_what_was_written_before() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.bin");
        // More pieces than the system writes at a time.
        let pieces: Vec<Vec<u8>> = (0..3000).map(|i| vec![i as u8; i % 60]).collect();
        write_atomically(&path, |out| {
            out.write_all(b"first")?;
            out.write_pieces(&pieces)?;
            out.write_all(b"last")
        })
        .unwrap();
        let expected = [&b"first"[..], &pieces.concat(), b"last"].concat();
        assert!(fs::read(&path).unwrap() == expected);
    }

    #[test]
    fn leftovers_are_removed_except_files_that_are_being_written() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.csv");
        let mut file = AtomicFile::create(&path).unwrap();
        let [written] = &names(folder.path())[..] else {
            panic!("one file is being written");
        };
        let others = [
            ".slipgap-probe",
            ".slipgap-.partial",
            ".slipgap-0123456789a.partial",
            "results.csv.partial",
        ];
        for name in others.iter().chain(&[".slipgap-0123456789aB.partial"]) {
            fs::write(folder.path().join(name), "rest").unwrap();
        }
        remove_leftovers(folder.path());
        let mut kept: Vec<&str> = others.into_iter().chain([written.as_str()]).collect();
        kept.sort_unstable();
        assert_eq!(names(folder.path()), kept);
        file.write_all(b"complete").unwrap();
        file.commit().unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"complete");
    }

    #[cfg(unix)]
    #[test]
    fn links_are_neither_followed_nor_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let (target, link) = (folder.path().join("target"), folder.path().join("a.csv"));
        fs::write(&target, "target").unwrap();
        std::os::unix::fs::symlink(&target, &link).unwrap();
        let why = write_atomically(&link, |out| out.write_all(b"new")).unwrap_err();
        assert!(why.to_string().contains("there is a link"), "{why}");
        assert_eq!(fs::read(&target).unwrap(), b"target");
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        // `remove_leftovers` does not follow links either.
        let leftover = folder.path().join(".slipgap-0123456789aB.partial");
        std::os::unix::fs::symlink(&target, &leftover).unwrap();
        remove_leftovers(folder.path());
        assert!(fs::symlink_metadata(&leftover).is_ok() && target.exists());
    }
}
