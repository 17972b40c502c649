//! The files of a folder, or of a pattern with one `*`.

use std::path::{Path, is_separator};

/// Most files of an axis.
const MOST: usize = 10_000;

/// Files of an axis: what `*` is in the name of each, and its path in the study.
pub(super) type Found = Vec<(String, String)>;

/// The files that a folder or a pattern names, or why there are none.
pub(super) fn matching(pattern: &str, folder: &Path) -> Result<Found, String> {
    let is_folder = folder.join(pattern).is_dir();
    let (parent, name) = match pattern.rsplit_once(is_separator) {
        _ if is_folder => (pattern.trim_end_matches(is_separator), "*"),
        Some((parent, name)) => (parent, name),
        None => ("", pattern),
    };
    let Some((before, after)) = name
        .split_once('*')
        .filter(|(_, after)| !after.contains('*'))
    else {
        return Err("must be a folder, or a pattern with one * in the name of the files".into());
    };
    if parent.contains('*') {
        return Err("must have its * in the name of the files, not in that of a folder".into());
    }
    let place = match pattern.starts_with(is_separator) && parent.is_empty() {
        true => Path::new("/").to_owned(),
        // A study without a folder in its path is in this one.
        false if folder.as_os_str().is_empty() => Path::new(".").join(parent),
        false => folder.join(parent),
    };
    let entries = std::fs::read_dir(&place);
    let entries =
        entries.map_err(|why| format!("cannot read the folder {}: {why}", place.display()))?;
    let mut found = Vec::new();
    for entry in entries {
        let entry =
            entry.map_err(|why| format!("cannot read the folder {}: {why}", place.display()))?;
        let Ok(name) = entry.file_name().into_string() else {
            continue;
        };
        // Pages beside the records of a folder.
        if name.starts_with('.') || is_folder && name.to_ascii_lowercase().ends_with(".md") {
            continue;
        }
        let star = name
            .strip_prefix(before)
            .and_then(|rest| rest.strip_suffix(after));
        if let Some(star) = star
            && entry.path().is_file()
        {
            let path = match pattern.contains(is_separator) || is_folder {
                true => format!("{parent}/{name}"),
                false => name.clone(),
            };
            found.push((star.to_owned(), path));
        }
    }
    found.sort_by(|a, b| a.1.cmp(&b.1));
    match found.len() {
        0 => Err(format!("no file in {} has such a name", place.display())),
        1..=MOST => Ok(found),
        many => Err(format!("{many} files; allowed: at most {MOST}")),
    }
}
