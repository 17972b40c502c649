//! The files of a store: their names, and their content if it has the checksum in the name.

use super::catch_panic::catch_panic;
use super::key::checksum;
use super::miss::Miss;
use super::reading::{self, Summary};
use super::rows::Rows;
use crate::files::place::{entries, is_object, read_file};
use bytes::Bytes;
use slipgap_study::error::Error;
use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// Name of the store in a folder of results.
pub const STORE: &str = "store";

/// The name of a part.
pub fn name(start: u64, checksum: &str) -> String {
    format!("part-{start:012}-{checksum}.parquet")
}

/// Start and checksum in the name of a part; `None` for a name that no run writes.
pub fn parse_name(path: &Path) -> Option<(u64, &str)> {
    let name = path.file_name()?.to_str()?;
    let rest = name.strip_prefix("part-")?.strip_suffix(".parquet")?;
    let (start, sum) = rest.split_once('-')?;
    let digits = start.len() >= 8 && start.bytes().all(|b| b.is_ascii_digit());
    let hexadecimal = |b: u8| matches!(b, b'0'..=b'9' | b'a'..=b'f');
    let valid = digits && sum.len() == 32 && sum.bytes().all(hexadecimal);
    Some((start.parse().ok().filter(|_| valid)?, sum))
}

/// The name of a sub-folder of a store.
pub fn folder_name(number: u64) -> String {
    format!("{number:06}")
}

/// A store and its sub-folders.
///
/// # Errors
/// A folder that cannot be read.
pub fn folders(store: &Path) -> Result<Vec<PathBuf>, Error> {
    let mut folders = vec![store.to_owned()];
    for entry in entries(store).map_err(Error::io("cannot read", store))? {
        let name = &entry.name;
        let numbered = name.len() >= 6 && name.bytes().all(|b| b.is_ascii_digit());
        if numbered && entry.is_folder {
            folders.push(entry.path);
        }
    }
    Ok(folders)
}

/// The parts of a store, in order, with the starts in their names.
pub fn all_in(store: &Path) -> Result<Vec<(u64, PathBuf)>, Error> {
    let start = |path: &PathBuf| parse_name(path).map(|(start, _)| start);
    let paths = similar_in(store)?.into_iter();
    let mut parts: Vec<_> = paths
        .filter_map(|path| Some((start(&path)?, path)))
        .collect();
    parts.sort();
    Ok(parts)
}

/// The files `part-*.parquet` of a store.
pub fn similar_in(store: &Path) -> Result<Vec<PathBuf>, Error> {
    let mut paths = Vec::new();
    for folder in folders(store)? {
        paths.extend(similar_in_one(&folder)?);
    }
    Ok(paths)
}

fn similar_in_one(folder: &Path) -> Result<Vec<PathBuf>, Error> {
    let mut paths = Vec::new();
    for entry in entries(folder).map_err(Error::io("cannot read", folder))? {
        let similar = entry.name.starts_with("part-") && entry.name.ends_with(".parquet");
        if similar && !entry.is_folder {
            paths.push(entry.path);
        }
    }
    Ok(paths)
}

/// The bytes of a part, if they have the checksum in its name.
///
/// # Errors
/// A server does not give it.
pub fn read_checked(path: &Path) -> Result<Option<Vec<u8>>, Miss> {
    let bytes = read_part(path)?;
    Ok(bytes.filter(|bytes| is_undamaged(path, bytes)))
}

/// The bytes of a part, or of what has its name. A network that wants a password answers with a page, which is no damaged part.
fn read_bytes(path: &Path) -> io::Result<Vec<u8>> {
    let bytes = read_file(path)?;
    match is_object(path) && bytes.trim_ascii_start().starts_with(b"<") {
        true => Err(io::Error::other(
            "the answer is none of S3: a page of the network, or another server",
        )),
        false => Ok(bytes),
    }
}

/// The bytes of a part. A file that cannot be read is as good as damaged; a server may give it later.
fn read_part(path: &Path) -> Result<Option<Vec<u8>>, Miss> {
    match read_bytes(path) {
        Err(e) if is_object(path) && e.kind() != ErrorKind::NotFound => {
            Err(Miss::Unread(path.to_owned(), e.to_string()))
        }
        read => Ok(read.ok()),
    }
}

/// What the footer of a part says; `None` if it is damaged. Damage of its rows is not seen.
///
/// # Errors
/// A server does not give it.
pub fn summary(path: &Path) -> Result<Option<Summary>, Miss> {
    let caught = match is_object(path) {
        true => {
            let bytes = read_part(path)?.map(Bytes::from);
            catch_panic(|| reading::summary(bytes?).ok())
        }
        false => {
            // A pipe would wait for a writer.
            let is_file = fs::metadata(path).is_ok_and(|found| found.is_file());
            let file = is_file.then(|| File::open(path).ok()).flatten();
            catch_panic(|| reading::summary(file?).ok())
        }
    };
    Ok(caught.flatten())
}

/// The same of a part whose bytes have the checksum in its name.
///
/// # Errors
/// A server does not give it.
pub fn checked_summary(path: &Path) -> Result<Option<Summary>, Miss> {
    let bytes = read_checked(path)?.map(Bytes::from);
    Ok(catch_panic(|| reading::summary(bytes?).ok()).flatten())
}

/// Whether an object store lists these parts: a server may answer that it has an object, and not keep it. A folder is not asked.
///
/// # Errors
/// The first part that is not there.
pub fn check_kept(store: &Path, parts: &BTreeSet<PathBuf>) -> Result<(), Error> {
    if !is_object(store) || parts.is_empty() {
        return Ok(());
    }
    let listed: BTreeSet<PathBuf> = similar_in(store)?.into_iter().collect();
    match parts.iter().find(|part| !listed.contains(*part)) {
        None => Ok(()),
        Some(part) => {
            let why =
                "the server does not list it: it did not keep it, or another run has removed it";
            Err(Error::io("cannot keep", part)(io::Error::other(why)))
        }
    }
}

fn is_undamaged(path: &Path, bytes: &[u8]) -> bool {
    parse_name(path).is_some_and(|(_, sum)| checksum(&[bytes]) == sum)
}

/// The results in the store of a folder, as text.
///
/// # Errors
/// A part that cannot be read, or is damaged.
pub fn rows(results: &Path) -> Result<Rows, Error> {
    let folder = results.join(STORE);
    let mut rows = Rows::default();
    for (_, path) in all_in(&folder)? {
        let bytes = read_bytes(&path).map_err(Error::io("cannot read", &path))?;
        let damaged = || {
            let source = io::Error::other("damaged; run the study again");
            Error::io("cannot read", &path)(source)
        };
        if !is_undamaged(&path, &bytes) {
            return Err(damaged());
        }
        let read = catch_panic(|| reading::read_text(bytes));
        rows.extend(read.and_then(Result::ok).ok_or_else(damaged)?);
    }
    Ok(rows)
}
