//! What is in a folder, or under a prefix of an object store. A path that begins with `s3://` names an object, or the prefix of
//! objects that is used as a folder. Who reads and writes results by these functions has the same code for both.

use super::objects;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// Whether a path names an object, or a prefix of objects. `pathlib` of Python makes `s3:/` of `s3://`.
pub fn is_object(path: &Path) -> bool {
    path.as_os_str().as_encoded_bytes().starts_with(b"s3:/")
}

/// The form of a path of objects.
const FORM: &str = "must be s3://BUCKET or s3://BUCKET/FOLDER, where the name of a bucket has 3 to 63 letters, digits, points, _ and -, or a folder";

/// A path for results: a folder, or a prefix in a bucket that is named, which else would be the first part of a path inside of it.
///
/// # Errors
/// The form of a path of objects.
pub fn for_results(path: PathBuf) -> Result<PathBuf, &'static str> {
    if !is_object(&path) {
        let text = path.to_string_lossy();
        // Else a folder with the name `https:` or `S3:` would be made.
        let is_address = text.contains("://") || text.to_ascii_lowercase().starts_with("s3:");
        return if is_address { Err(FORM) } else { Ok(path) };
    }
    let given = path.to_str().ok_or(FORM)?;
    let after_scheme = given.strip_prefix("s3:/").unwrap_or(given);
    let rest = after_scheme.strip_prefix('/').unwrap_or(after_scheme);
    let bucket = rest.split(['/', '\\']).next().unwrap_or_default();
    let plain = |c: char| c.is_ascii_alphanumeric() || matches!(c, '.' | '_' | '-');
    match (3..=63).contains(&bucket.len()) && bucket.chars().all(plain) {
        true => Ok(path),
        false => Err(FORM),
    }
}

/// An entry of a folder.
pub(crate) struct Entry {
    pub name: String,
    pub path: PathBuf,
    /// A link to a folder is none.
    pub is_folder: bool,
}

/// The entries of a folder; a prefix without objects has none.
pub(crate) fn entries(folder: &Path) -> io::Result<Vec<Entry>> {
    if is_object(folder) {
        let found = objects::list(folder)?.into_iter();
        return Ok(found
            .map(|(name, is_folder)| Entry {
                path: folder.join(&name),
                name,
                is_folder,
            })
            .collect());
    }
    let mut entries = Vec::new();
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let is_folder = match entry.file_type() {
            Ok(kind) => kind.is_dir(),
            // Another process may have removed it.
            Err(e) if e.kind() == ErrorKind::NotFound => continue,
            Err(e) => return Err(e),
        };
        entries.push(Entry {
            name: entry.file_name().to_string_lossy().into_owned(),
            path: entry.path(),
            is_folder,
        });
    }
    Ok(entries)
}

/// The bytes of a file, or of the one that a link leads to: a pipe would wait for a writer, and a device may have no end.
pub(crate) fn read_file(path: &Path) -> io::Result<Vec<u8>> {
    if is_object(path) {
        return objects::read(path);
    }
    match fs::metadata(path)?.is_file() {
        true => fs::read(path),
        false => Err(io::Error::other("it is not a file; remove it")),
    }
}

/// Whether there is a file of this name.
pub(crate) fn is_file(path: &Path) -> bool {
    match is_object(path) {
        true => objects::is_there(path),
        false => path.is_file(),
    }
}

/// Whether there is a folder of this name, or an object under this prefix.
pub fn is_folder(path: &Path) -> bool {
    match is_object(path) {
        true => objects::list(path).is_ok_and(|entries| !entries.is_empty()),
        false => path.is_dir(),
    }
}

/// Makes a folder. A prefix is there with its first object.
pub(crate) fn make_folder(path: &Path) -> io::Result<()> {
    match is_object(path) {
        true => Ok(()),
        false => fs::create_dir_all(path),
    }
}

/// Removes a file.
pub(crate) fn remove_file(path: &Path) -> io::Result<()> {
    match is_object(path) {
        true => objects::remove(path),
        false => fs::remove_file(path),
    }
}

/// Removes a folder if it is empty. A prefix is gone with its last object.
pub(crate) fn remove_empty_folder(path: &Path) {
    if !is_object(path) {
        let _ = fs::remove_dir(path);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_files_are_read() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.csv");
        fs::write(&path, "own").unwrap();
        assert_eq!(read_file(&path).unwrap(), b"own");
        let why = |path: &Path| read_file(path).unwrap_err();
        assert!(why(folder.path()).to_string().contains("not a file"));
        assert!(
            !cfg!(unix)
                || why(Path::new("/dev/zero"))
                    .to_string()
                    .contains("not a file")
        );
        let none = folder.path().join("b.csv");
        assert_eq!(why(&none).kind(), ErrorKind::NotFound);
    }
}
