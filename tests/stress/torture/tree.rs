//! Folders as trees of bytes, and programs that disturb a run.

use crate::Bench;
use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

/// The content of every file in a folder by relative path. The path of a sub-folder ends with `/`.
pub(crate) type Tree = BTreeMap<String, Vec<u8>>;

impl Bench {
    /// The content of a folder; empty if it does not exist.
    pub(crate) fn tree(&self, folder: &str) -> Tree {
        let root = self.path(folder);
        let entries = walkdir::WalkDir::new(&root).min_depth(1).into_iter();
        let entry = |entry: walkdir::DirEntry| {
            let relative = entry.path().strip_prefix(&root).unwrap();
            let name = relative.display().to_string();
            match entry.file_type().is_dir() {
                true => (name + "/", Vec::new()),
                false => (name, fs::read(entry.path()).unwrap()),
            }
        };
        entries.filter_map(Result::ok).map(entry).collect()
    }

    /// Replaces the content of a folder.
    pub(crate) fn put(&self, folder: &str, tree: &Tree) {
        let _ = fs::remove_dir_all(self.path(folder));
        for (name, bytes) in tree {
            match name.ends_with('/') {
                true => fs::create_dir_all(self.path(folder).join(name)).unwrap(),
                false => self.file(&format!("{folder}/{name}"), bytes),
            }
        }
    }
}

/// The path of a program, if it is installed.
pub(crate) fn program(name: &str) -> Option<PathBuf> {
    if name == "slipgap" {
        return Some(env!("CARGO_BIN_EXE_slipgap-tested").into());
    }
    let folders = std::env::var_os("PATH")?;
    let mut paths = std::env::split_paths(&folders).map(|folder| folder.join(name));
    paths.find(|path| path.is_file())
}

/// The differences of two trees, one line for each path.
pub(crate) fn differences(found: &Tree, wanted: &Tree) -> String {
    let mut lines = String::new();
    for (name, bytes) in wanted {
        match found.get(name) {
            None => lines += &format!("missing: {name}\n"),
            Some(other) if other != bytes => lines += &format!("other bytes: {name}\n"),
            Some(_) => {}
        }
    }
    for name in found.keys().filter(|name| !wanted.contains_key(*name)) {
        lines += &format!("left over: {name}\n");
    }
    lines
}
