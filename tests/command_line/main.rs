//! The command line as a program: what it prints, writes and answers, on good studies and on bad ones.

mod bad_files;
mod bad_impact;
mod begin;
mod checks;
mod claims;
mod compare;
mod designs;
#[cfg(unix)]
mod ended;
mod files;
#[cfg(unix)]
mod interrupted;
mod kept;
mod pictures;
mod same_bytes;
mod settings;
mod store;
mod units;
mod untouched;
mod verbs;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tempfile::TempDir;

/// A folder of its own for each test, which the program runs in.
pub(crate) struct Bench(TempDir);

/// How a run of the program ended.
#[derive(Debug)]
pub(crate) struct Done {
    pub(crate) code: Option<i32>,
    pub(crate) out: String,
    pub(crate) err: String,
}

impl Bench {
    pub(crate) fn new() -> Bench {
        Bench(tempfile::tempdir().unwrap())
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// Writes a file, with the folders it stands in.
    pub(crate) fn file(&self, name: &str, bytes: impl AsRef<[u8]>) {
        let path = self.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, bytes).unwrap();
    }

    /// The text of a file that is there.
    #[track_caller]
    pub(crate) fn text(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }

    pub(crate) fn command(&self) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_slipgap"));
        command.current_dir(self.0.path());
        command
    }

    /// Runs the program; a panic or a signal is a failure of any test.
    #[track_caller]
    pub(crate) fn run(&self, words: &[&str]) -> Done {
        let done: Done = self.command().args(words).output().unwrap().into();
        assert!(!done.err.contains("panicked"), "{words:?}: {done:?}");
        assert!(done.code.is_some(), "{words:?}: {done:?}");
        done
    }

    /// Runs the program and asks for an exit code.
    #[track_caller]
    pub(crate) fn expect(&self, code: i32, words: &[&str]) -> Done {
        let done = self.run(words);
        assert_eq!(done.code, Some(code), "{words:?}: {done:?}");
        done
    }

    /// Every file under `folder` but those of stores, by its path from there, in order.
    pub(crate) fn tree(&self, folder: &str) -> Vec<String> {
        let mut names = self.everything(folder);
        names.retain(|name| !name.split('/').any(|part| part == "store"));
        names
    }

    /// Every file under `folder`, by its path from there, in order.
    pub(crate) fn everything(&self, folder: &str) -> Vec<String> {
        let root = self.path(folder);
        let entries = walkdir::WalkDir::new(&root).into_iter();
        let files = entries.map(Result::unwrap).filter(|e| e.path().is_file());
        let name = |path: &Path| path.strip_prefix(&root).unwrap().display().to_string();
        let mut names: Vec<String> = files.map(|e| name(e.path())).collect();
        names.sort();
        names
    }
}

impl From<Output> for Done {
    fn from(output: Output) -> Done {
        Done {
            code: output.status.code(),
            out: String::from_utf8_lossy(&output.stdout).into_owned(),
            err: String::from_utf8_lossy(&output.stderr).into_owned(),
        }
    }
}

/// A friction study with these parameters and further keys.
pub(crate) fn friction(parameters: &str, more: &str) -> String {
    format!(
        "{{ \"problem\": \"friction-oscillator\", \"parameters\": {{ {parameters} }}{more} }}\n"
    )
}

/// A bar impact study with these parameters and further keys.
pub(crate) fn bars(parameters: &str, more: &str) -> String {
    format!("{{ \"problem\": \"bar-impact\",\n  \"parameters\": {{ {parameters} }}{more} }}\n")
}

/// Two cases of friction with displacement-control.
pub(crate) const TWO: &str =
    r#""law": "displacement-control", "alpha": [0.1, 1], "dT": "pi/10", "duration": "8*pi""#;

/// One case of friction with velocity-control.
pub(crate) const ONE: &str = r#""law": "velocity-control", "beta": 1, "dT": 0.5, "duration": 3"#;

/// The folder of the studies that the project ships.
pub(crate) fn shipped() -> String {
    format!("{}/studies", env!("CARGO_MANIFEST_DIR"))
}
