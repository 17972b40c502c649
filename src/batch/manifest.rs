//! manifest.json: where results come from, and which files of a folder are a run's own.
//!
//! While a run writes, its manifest names what it may leave too, so that nothing of a killed run stays for good.

use super::key::SOLVER_VERSION;
use super::whole::whole;
use crate::error::Error;
use crate::study::{STDIN, Setting, Study};
use serde_json::{Map, Value, json};
use std::collections::BTreeSet;
use std::fs;
use std::io::{self, ErrorKind, Write};
use std::path::Path;
use std::process::Command;

/// Name of the file.
pub(super) const MANIFEST: &str = "manifest.json";

/// Folder of the histories, each `CASE.csv`.
pub(super) const HISTORIES: &str = "histories";

/// Name of a case's history.
pub fn history(case: u64) -> String {
    format!("{HISTORIES}/{case}.csv")
}

/// Whether a file is the manifest of a folder of results, and so no study: by what it holds, since a study may have its
/// name.
pub fn is_manifest(file: &Path) -> bool {
    let ours = || {
        let manifest = json_of(file)?;
        let own = manifest["program"] == env!("CARGO_PKG_NAME");
        Some(own && manifest["study_sha256"].is_string())
    };
    file.file_name().is_some_and(|name| name == MANIFEST) && ours().unwrap_or(false)
}

/// Whether a folder has a table of results that is of an earlier form of the study, by the hash in its manifest.
pub fn outdated(results: &Path, study: &Study) -> bool {
    let former = || {
        let manifest = json_of(&results.join(MANIFEST))?;
        Some(manifest["study_sha256"].as_str()? != study.sha256)
    };
    results.join(super::output::RESULTS).is_file() && former().unwrap_or(false)
}

/// Name of the problem in the manifest of a folder; `None` without a manifest, or in one of an earlier version.
pub fn problem_of(folder: &Path) -> Option<String> {
    let manifest = json_of(&folder.join(MANIFEST))?;
    Some(manifest["problem"].as_str()?.to_owned())
}

/// What a file holds, if it can be read and is JSON.
fn json_of(file: &Path) -> Option<Value> {
    serde_json::from_slice(&fs::read(file).ok()?).ok()
}

/// What the manifest of a folder says.
#[derive(Debug, Default)]
pub(super) struct Manifest {
    /// All of it; empty where there is none.
    said: Map<String, Value>,
    /// Files that are a run's own.
    files: BTreeSet<String>,
    /// What a run that did not end may have written too.
    unfinished: Unfinished,
}

/// Histories of a run that did not end: those of the first cases, but for files that were there before it.
#[derive(Debug, Default, Clone)]
struct Unfinished {
    cases: u64,
    others: BTreeSet<String>,
}

impl Manifest {
    /// Reads the manifest of a folder, if there is one.
    ///
    /// # Errors
    /// One that does not say which files are a run's own: they could not be told from others.
    pub fn read(folder: &Path) -> Result<Manifest, Error> {
        let path = folder.join(MANIFEST);
        let bytes = match fs::read(&path) {
            Err(e) if e.kind() == ErrorKind::NotFound => return Ok(Manifest::default()),
            read => read.map_err(Error::io("cannot read", &path))?,
        };
        let unread = || {
            let why = "it does not list the files that former runs wrote; remove it, and remove the files that are out of date";
            Error::io("cannot read", path)(io::Error::other(why))
        };
        parsed(&bytes).ok_or_else(unread)
    }

    /// Files that are a run's own, as far as they may be there.
    pub fn owned(&self, folder: &Path) -> BTreeSet<String> {
        let mut owned = self.files.clone();
        if self.unfinished.cases > 0 {
            let histories = histories(folder, self.unfinished.cases);
            owned.extend(histories.filter(|name| !self.unfinished.others.contains(name)));
        }
        owned
    }

    /// Writes what a run that begins may leave in the folder: `names`, and histories of the first `cases`.
    pub fn begin(
        mut self,
        folder: &Path,
        study: &Study,
        file: &Path,
        names: Vec<String>,
        cases: u64,
    ) -> Result<(), Error> {
        let owned = self.owned(folder);
        // What is there and no run's own is the user's.
        let others = |name: &String| !owned.contains(name);
        if cases > 0 {
            let here = histories(folder, cases.max(self.unfinished.cases));
            self.unfinished.others = here.filter(others).collect();
            self.unfinished.cases = self.unfinished.cases.max(cases);
        }
        let new = names
            .into_iter()
            .filter(|name| fs::symlink_metadata(folder.join(name)).is_err());
        self.files.extend(new);
        // Until it has results of its own, the folder has those of the former run.
        let mut said = match self.said.is_empty() {
            true => about(study, file),
            false => self.said,
        };
        said.insert("files".into(), json!(self.files));
        let Unfinished { cases, others } = self.unfinished;
        said.insert(
            "unfinished".into(),
            json!({ "cases": cases, "others": others }),
        );
        write(folder, &said)
    }

    /// Writes what a run that has ended left in the folder, with the number of cases in which no contact happens.
    pub fn end(
        folder: &Path,
        study: &Study,
        file: &Path,
        files: &[String],
        untouched: u64,
    ) -> Result<(), Error> {
        let mut said = about(study, file);
        said.insert("files".into(), json!(files));
        if study.problem.schema().contact_metric.is_some() {
            said.insert("cases_without_contact".into(), json!(untouched));
        }
        write(folder, &said)
    }
}

fn parsed(bytes: &[u8]) -> Option<Manifest> {
    let said: Map<String, Value> = serde_json::from_slice(bytes).ok()?;
    let names = |list: &Value| -> Option<BTreeSet<String>> {
        let names = list.as_array()?.iter();
        names.map(|name| Some(name.as_str()?.to_owned())).collect()
    };
    let files = names(said.get("files")?)?;
    let unfinished = match said.get("unfinished") {
        None => Unfinished::default(),
        Some(run) => Unfinished {
            cases: run.get("cases")?.as_u64()?,
            others: names(run.get("others")?)?,
        },
    };
    Some(Manifest {
        said,
        files,
        unfinished,
    })
}

/// The histories of the first cases that are in the folder.
fn histories(folder: &Path, cases: u64) -> impl Iterator<Item = String> {
    let entries = fs::read_dir(folder.join(HISTORIES)).into_iter().flatten();
    entries.flatten().filter_map(move |entry| {
        let name = entry.file_name();
        let case = name.to_str()?.strip_suffix(".csv")?.parse().ok()?;
        let own = case < cases && name.to_str() == Some(&format!("{case}.csv"));
        own.then(|| history(case))
    })
}

/// Where results come from.
fn about(study: &Study, file: &Path) -> Map<String, Value> {
    let mut about = json!({
        "study": file.file_name().map(|name| name.to_string_lossy()),
        "study_sha256": study.sha256,
        "problem": study.problem.name(),
        "program": env!("CARGO_PKG_NAME"),
        "program_version": env!("CARGO_PKG_VERSION"),
        "solver_version": SOLVER_VERSION,
        "git_commit": commit_of(file),
    });
    if !study.settings.is_empty() {
        let settings = study.settings.iter().map(Setting::text);
        about["set"] = settings.collect();
    }
    match about {
        Value::Object(about) => about,
        _ => Map::new(),
    }
}

fn write(folder: &Path, said: &Map<String, Value>) -> Result<(), Error> {
    let said = Value::Object(said.clone());
    whole(&folder.join(MANIFEST), |out| {
        writeln!(out, "{said:#}")?;
        // A manifest that the power took would leave files that no run knows as its own.
        out.sync()
    })
}

/// The commit of the repository that holds the study, if it stands in one and git is there to ask.
fn commit_of(file: &Path) -> Option<String> {
    if file == Path::new(STDIN) {
        return None;
    }
    let folder = file
        .parent()
        .filter(|parent| !parent.as_os_str().is_empty())
        .unwrap_or(Path::new("."));
    let output = Command::new("git")
        .arg("-C")
        .arg(folder)
        .args(["rev-parse", "HEAD"])
        .output()
        .ok()
        .filter(|output| output.status.success())?;
    Some(String::from_utf8_lossy(&output.stdout).trim().to_owned())
}
