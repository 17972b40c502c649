//! A temporary folder in which the program runs.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tempfile::TempDir;

/// A temporary folder for one test.
pub(crate) struct Bench(TempDir);

/// How a run of a program ended.
#[derive(Debug)]
pub(crate) struct Done {
    /// `None` after a signal.
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

    /// Writes a file, and makes its folders.
    pub(crate) fn file(&self, name: &str, bytes: impl AsRef<[u8]>) {
        let path = self.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, bytes).unwrap();
    }

    /// A command that runs in the folder, without git: the folder is not in a repository.
    pub(crate) fn command_of(&self, program: impl AsRef<Path>) -> Command {
        let mut command = Command::new(program.as_ref());
        let folder = self.0.path();
        command.current_dir(folder).env("PATH", "/nonexistent");
        command
    }

    /// The program, to be run in the folder.
    pub(crate) fn command(&self) -> Command {
        self.command_of(env!("CARGO_BIN_EXE_slipgap-tested"))
    }

    /// Runs the program. A panic or a signal fails the test.
    #[track_caller]
    pub(crate) fn run(&self, args: &[&str]) -> Done {
        let done: Done = self.command().args(args).output().unwrap().into();
        assert!(!done.err.contains("panicked"), "{args:?}: {done:?}");
        assert!(done.code.is_some(), "{args:?}: {done:?}");
        done
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
