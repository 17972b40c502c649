//! A folder in which the program runs, and all that stands in it.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tempfile::TempDir;

/// Every file under a folder by its path from there; folders end in `/` and hold nothing.
pub(crate) type Tree = BTreeMap<String, Vec<u8>>;

/// How a program ended: without a code where a signal ended it.
#[derive(Debug)]
pub(crate) struct Done {
    pub(crate) code: Option<i32>,
    pub(crate) err: String,
}

/// A folder of its own for a loop.
pub(crate) struct Bench(TempDir);

impl Bench {
    pub(crate) fn new() -> Bench {
        Bench(tempfile::tempdir().unwrap())
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// Writes a file, with the folders above it.
    pub(crate) fn file(&self, name: &str, bytes: impl AsRef<[u8]>) {
        let path = self.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, bytes).unwrap();
    }

    /// A command that runs in the folder. Without git, whose commit is no matter here.
    pub(crate) fn command(&self, program: impl AsRef<Path>) -> Command {
        let mut command = Command::new(program.as_ref());
        command
            .current_dir(self.0.path())
            .env("PATH", "/nonexistent");
        command
    }

    /// Runs slipgap to its end.
    #[track_caller]
    pub(crate) fn run(&self, words: &[&str]) -> Done {
        let mut command = self.command(program("slipgap").unwrap());
        let done: Done = command.args(words).output().unwrap().into();
        assert!(!done.err.contains("panicked"), "{words:?}: {done:?}");
        done
    }

    /// All that stands under a folder; nothing where it is not there.
    pub(crate) fn tree(&self, folder: &str) -> Tree {
        let root = self.path(folder);
        let entries = walkdir::WalkDir::new(&root).min_depth(1).into_iter();
        let entry = |entry: walkdir::DirEntry| {
            let name = entry.path().strip_prefix(&root).unwrap();
            let name = name.display().to_string();
            match entry.file_type().is_dir() {
                true => (name + "/", Vec::new()),
                false => (name, fs::read(entry.path()).unwrap()),
            }
        };
        entries.filter_map(Result::ok).map(entry).collect()
    }

    /// Makes a folder hold exactly this.
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

impl From<Output> for Done {
    fn from(output: Output) -> Done {
        Done {
            code: output.status.code(),
            err: String::from_utf8_lossy(&output.stderr).into_owned(),
        }
    }
}

/// The path of a program, if it is installed.
pub(crate) fn program(name: &str) -> Option<PathBuf> {
    if name == "slipgap" {
        return Some(env!("CARGO_BIN_EXE_slipgap").into());
    }
    let folders = std::env::var_os("PATH")?;
    let mut paths = std::env::split_paths(&folders).map(|folder| folder.join(name));
    paths.find(|path| path.is_file())
}

/// What two trees differ in, one line a name.
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
