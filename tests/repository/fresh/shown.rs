//! What of figures/ is committed: the pictures that pages show, and small tables. All else is in the list of hashes, so that a clone
//! stays light.

use crate::{CLAIMS, hashes};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Component, Path, PathBuf};

/// A table below this size is committed, in bytes.
const LARGEST_TABLE: u64 = 5_000;

/// The pictures that a page shows or links to, by their paths in the repository.
fn pictures(page: &str) -> BTreeSet<String> {
    let text =
        fs::read_to_string(crate::root().join(page)).unwrap_or_else(|e| panic!("{page}: {e}"));
    // What is inside code is no link.
    let prose = text
        .split("```")
        .step_by(2)
        .flat_map(|part| part.split('`').step_by(2));
    let links = prose.flat_map(|part| part.split("](").skip(1));
    let targets = links.filter_map(|rest| rest.split([')', '#', ' ']).next());
    let pictures = targets.filter(|target| target.ends_with(".png") && !target.contains(':'));
    let folder = Path::new(page).parent().unwrap();
    pictures.map(|target| plain(&folder.join(target))).collect()
}

/// A path without `..`, with `/` on every system.
fn plain(path: &Path) -> String {
    let mut parts = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => drop(parts.pop()),
            Component::CurDir => {}
            Component::Prefix(_) | Component::RootDir | Component::Normal(_) => parts.push(part),
        }
    }
    let parts: Vec<&str> = parts.iter().map(|part| part.to_str().unwrap()).collect();
    parts.join("/")
}

#[test]
fn committed_results_are_pictures_of_pages_and_small_tables() {
    let Some(tracked) = crate::tracked(&["figures", "*.md"]) else {
        eprintln!("no git repository: not tested which results are committed");
        return;
    };
    let pages = tracked.iter().filter(|name| name.ends_with(".md"));
    let pictured: BTreeSet<String> = pages.flat_map(|page| pictures(page)).collect();
    let shown: BTreeSet<&String> = pictured
        .iter()
        .filter(|name| name.starts_with("figures/"))
        .collect();
    assert!(shown.len() > 20, "{shown:?}");
    let mut faults = Vec::new();
    for name in shown.iter().filter(|name| !tracked.contains(**name)) {
        faults.push(format!(
            "{name}: a page shows it; commit it by `git add --force`"
        ));
    }
    let pages = [CLAIMS, hashes::FILE].map(|name| format!("figures/{name}"));
    let pictures = tracked.iter().filter(|name| name.starts_with("figures/"));
    for name in pictures.filter(|name| !pages.contains(*name) && !shown.contains(name)) {
        let size = fs::metadata(crate::root().join(name)).map_or(0, |file| file.len());
        if !name.ends_with(".csv") || size >= LARGEST_TABLE {
            faults.push(format!(
                "{name}: committed are pictures that pages show, and tables below {LARGEST_TABLE} bytes, this has {size}; remove it by \
                 `git rm --cached`, then `make hashes`"
            ));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
