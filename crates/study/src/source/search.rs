//! Study files by their name in a folder with sub-folders.

use crate::error::Error;
use std::path::{Component, Path, PathBuf};
use walkdir::{DirEntry, WalkDir};

/// The files in a folder and its sub-folders whose path ends with `name`, as in `slide.json` or `bridges/slide.json`, sorted. Hidden
/// files and folders are left out, as in every command; links to folders are not followed, since they may lead in a circle.
///
/// # Errors
/// A folder that cannot be read.
pub fn named(folder: &Path, name: &Path) -> Result<Vec<PathBuf>, Error> {
    let mut found = Vec::new();
    let plain = |part: Component| matches!(part, Component::Normal(_));
    if !folder.is_dir() || !name.components().all(plain) {
        return Ok(found);
    }
    let entries = WalkDir::new(folder).min_depth(1).into_iter();
    for entry in entries.filter_entry(|entry| !is_hidden(entry)) {
        let entry = entry.map_err(|e| {
            let at = e.path().unwrap_or(folder).to_owned();
            Error::io("cannot read", at)(e.into())
        })?;
        if entry.path().ends_with(name) && entry.path().is_file() {
            found.push(entry.into_path());
        }
    }
    found.sort();
    Ok(found)
}

fn is_hidden(entry: &DirEntry) -> bool {
    entry.file_name().to_string_lossy().starts_with('.')
}

/// A relative path with `/` on every system.
pub fn slashes(path: &Path) -> String {
    let parts: Vec<_> = path.iter().map(|part| part.to_string_lossy()).collect();
    parts.join("/")
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn files_are_found_by_their_name_or_by_the_end_of_their_path() {
        let folder = std::env::temp_dir().join(format!("slipgap-search-{}", std::process::id()));
        for file in [
            "a.json",
            "x/a.json",
            "x/y/b.json",
            ".old/b.json",
            "z/xa.json",
        ] {
            let path = folder.join(file);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, "{}").unwrap();
        }
        let of = |name: &str| {
            let files = named(&folder, Path::new(name)).unwrap().into_iter();
            let relative = files.map(|file| file.strip_prefix(&folder).unwrap().to_owned());
            relative.collect::<Vec<PathBuf>>()
        };
        let paths = |names: &[&str]| names.iter().map(PathBuf::from).collect::<Vec<_>>();
        assert_eq!(of("a.json"), paths(&["a.json", "x/a.json"]));
        assert_eq!(of("b.json"), paths(&["x/y/b.json"]));
        assert_eq!(of("y/b.json"), paths(&["x/y/b.json"]));
        assert_eq!(of("a"), paths(&[]));
        assert_eq!(of("../x/a.json"), paths(&[]));
        assert!(
            named(&folder.join("none"), Path::new("a.json"))
                .unwrap()
                .is_empty()
        );
        fs::remove_dir_all(folder).unwrap();
    }
}
