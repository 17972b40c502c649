//! The program: its output, its files and its exit codes, for valid and invalid studies.

mod bad;
mod files;
mod programs;
mod results;
mod settings;
mod stores;
mod verbs;
mod warnings;

// What reads a report, of which only a part is used here.
#[allow(dead_code)]
#[path = "../report/data.rs"]
mod data;
#[allow(dead_code)]
#[path = "../report/packed.rs"]
mod packed;

#[path = "../common/bench.rs"]
mod bench;

pub(crate) use bench::{Bench, Done};
use std::fs;
use std::path::Path;

impl Bench {
    /// The text of a file.
    #[track_caller]
    pub(crate) fn text(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }

    /// Runs the program and tests its exit code.
    #[track_caller]
    pub(crate) fn expect(&self, code: i32, args: &[&str]) -> Done {
        let done = self.run(args);
        assert_eq!(done.code, Some(code), "{args:?}: {done:?}");
        done
    }

    /// The relative paths of the files in `folder` and its sub-folders, sorted, without those of stores.
    pub(crate) fn tree(&self, folder: &str) -> Vec<String> {
        let mut names = self.everything(folder);
        names.retain(|name| !name.split('/').any(|part| part == "store"));
        names
    }

    /// The relative paths of the files in `folder` and its sub-folders, sorted.
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
    format!("{}/studies", env!("SLIPGAP_ROOT"))
}
