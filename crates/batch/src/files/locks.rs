//! Locks of files, on file systems that have them.
//!
//! NFS, Lustre and others may be mounted without. No result depends on a lock: a part is complete or absent by its rename, and
//! valid by its key and its checksum. A lock only reports a second run early.

use std::fs::{File, TryLockError};
use std::io::{self, ErrorKind};

/// ENOLCK and EOPNOTSUPP, on Windows ERROR_INVALID_FUNCTION and ERROR_NOT_SUPPORTED; ENOSYS has a kind of its own.
const UNSUPPORTED: [i32; 2] = match (cfg!(target_os = "linux"), cfg!(windows)) {
    (true, _) => [37, 95],
    (_, true) => [1, 50],
    _ => [77, 45],
};

/// Whether a file is locked.
#[derive(Debug)]
pub enum Locked {
    /// By this call.
    Here,
    /// By another file handle.
    Elsewhere,
    /// The file system has no locks.
    Unknown,
}

/// Locks a file by `lock`.
///
/// # Errors
/// Of a file system that has locks.
pub fn lock(
    file: &File,
    lock: impl Fn(&File) -> Result<(), TryLockError>,
) -> Result<Locked, io::Error> {
    match lock(file) {
        Ok(()) => Ok(Locked::Here),
        Err(TryLockError::WouldBlock) => Ok(Locked::Elsewhere),
        Err(TryLockError::Error(e)) if is_unsupported(&e) => Ok(Locked::Unknown),
        Err(TryLockError::Error(e)) => Err(e),
    }
}

fn is_unsupported(error: &io::Error) -> bool {
    let number = error.raw_os_error();
    error.kind() == ErrorKind::Unsupported || number.is_some_and(|n| UNSUPPORTED.contains(&n))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_system_without_locks_is_no_error_but_any_other_error_is() {
        let file = tempfile::tempfile().unwrap();
        let of = |number: i32| {
            lock(&file, |_| {
                Err(TryLockError::Error(io::Error::from_raw_os_error(number)))
            })
        };
        for number in UNSUPPORTED {
            assert!(matches!(of(number), Ok(Locked::Unknown)), "{number}");
        }
        // ENOSYS: Lustre that is mounted without `flock`.
        #[cfg(target_os = "linux")]
        assert!(matches!(of(38), Ok(Locked::Unknown)));
        // EIO and EACCES on every Unix.
        for number in [5, 13] {
            assert_eq!(of(number).unwrap_err().raw_os_error(), Some(number));
        }
        assert!(matches!(
            lock(&file, |file| file.try_lock()),
            Ok(Locked::Here)
        ));
        let elsewhere = lock(&file, |_| Err(TryLockError::WouldBlock));
        assert!(matches!(elsewhere, Ok(Locked::Elsewhere)));
    }
}
