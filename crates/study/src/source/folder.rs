//! The folder of a study. Every file beside the study is read here, so that the list of what was read is complete.

use super::input::{hexadecimal, open};
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::io::{self, Read};
use std::path::Path;
use std::sync::{Mutex, PoisonError};

/// A file that was read: a record, a matrix, a table or what was measured.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ReadFile {
    /// Its name in the study: a path in the folder of the study.
    pub name: String,
    /// Its length in bytes.
    pub size: u64,
    /// SHA-256 of its bytes, in hexadecimal digits.
    pub sha256: String,
}

/// The folder of a study, and what was read in it.
pub(crate) struct Folder<'a> {
    /// Its path.
    pub path: &'a Path,
    /// The name of the study in it.
    pub study: String,
    read: Mutex<BTreeMap<String, ReadFile>>,
}

impl<'a> Folder<'a> {
    /// The folder at a path, of which nothing is read yet, with a study.
    pub fn new(path: &'a Path, study: &str) -> Folder<'a> {
        let read = Mutex::default();
        let stem = Path::new(study).file_stem().unwrap_or_default();
        let study = stem.to_string_lossy().into_owned();
        Folder { path, study, read }
    }

    /// The bytes of a file of bounded size, or why there are none.
    pub fn bytes(&self, file: &str, largest: u64) -> Result<Vec<u8>, String> {
        let path = &self.path.join(file);
        if std::fs::metadata(path).is_ok_and(|found| !found.is_file()) {
            return Err("not a file".into());
        }
        let unread = |error: io::Error| format!("cannot read {}: {error}", path.display());
        let opened = open(path).map_err(unread)?;
        if opened.limit() > largest {
            return Err(format!("larger than {} MiB", largest >> 20));
        }
        let mut bytes = Vec::new();
        opened
            .take(largest)
            .read_to_end(&mut bytes)
            .map_err(unread)?;
        let read = || self.read.lock().unwrap_or_else(PoisonError::into_inner);
        // A file that several parts of a study name has one hash, computed beside the lock.
        if !read().contains_key(file) {
            let known = ReadFile {
                name: file.to_owned(),
                size: bytes.len() as u64,
                sha256: hexadecimal(&Sha256::digest(&bytes)),
            };
            read().insert(file.to_owned(), known);
        }
        Ok(bytes)
    }

    /// The files that were read, by name.
    pub fn into_files(self) -> Vec<ReadFile> {
        let unlocked = self.read.into_inner();
        let read = unlocked.unwrap_or_else(PoisonError::into_inner);
        read.into_values().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_that_is_read_is_listed_once() {
        let temporary = tempfile::tempdir().unwrap();
        std::fs::write(temporary.path().join("b.csv"), "abc").unwrap();
        std::fs::write(temporary.path().join("a.csv"), "").unwrap();
        let folder = Folder::new(temporary.path(), "s.json");
        for name in ["b.csv", "a.csv", "b.csv"] {
            folder.bytes(name, 3).unwrap();
        }
        for (name, largest) in [("b.csv", 2), ("c.csv", 9), (".", 9)] {
            folder.bytes(name, largest).unwrap_err();
        }
        // The examples of FIPS 180-4.
        let of = |name: &str, size, sha256: &str| ReadFile {
            name: name.into(),
            size,
            sha256: sha256.into(),
        };
        let empty = "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";
        let abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        assert_eq!(
            folder.into_files(),
            [of("a.csv", 0, empty), of("b.csv", 3, abc)]
        );
    }
}
