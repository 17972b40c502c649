//! Study files by their name in a folder with sub-folders.

use std::fs::{self, DirEntry};
use std::path::{Component, Path, PathBuf};

use crate::error::Error;

/// The files in a folder and its sub-folders whose path ends with `name`, as in `slide.json` or `bridges/slide.json`, sorted. Hidden
/// files and folders are left out, as in every command.
///
/// # Errors
/// A folder that cannot be read.
pub fn named(folder: &Path, name: &Path) -> Result<Vec<PathBuf>, Error> {
    let mut found = Vec::new();
    let plain = |part: Component| matches!(part, Component::Normal(_));
    if folder.is_dir() && name.components().all(plain) {
        search(folder, name, &mut found)?;
    }
    found.sort();
    Ok(found)
}

fn search(folder: &Path, name: &Path, found: &mut Vec<PathBuf>) -> Result<(), Error> {
    let failed = |error| Error::io("cannot read", folder)(error);
    for entry in fs::read_dir(folder).map_err(failed)? {
        let entry = entry.map_err(failed)?;
        if is_hidden(&entry) {
            continue;
        }
        let path = entry.path();
        // Links to folders are not followed: they may lead in a circle.
        if entry.file_type().map_err(failed)?.is_dir() {
            search(&path, name, found)?;
        } else if path.ends_with(name) && path.is_file() {
            found.push(path);
        }
    }
    Ok(())
}

fn is_hidden(entry: &DirEntry) -> bool {
    entry.file_name().to_string_lossy().starts_with('.')
}

#[cfg(test)]
mod tests {
    use super::*;

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
