//! manifest.json: the origin of the results, and the list of the files that runs wrote.
//!
//! During a run the manifest also lists the files that the run may write. The next run removes those of a killed run.

use super::names::{HISTORIES, MANIFEST, PROGRAM, history_name};
use super::origin::{json_of, origin};
use crate::WarnedCases;
use crate::files::atomic::write_atomically;
use crate::files::place::{Entry, entries, is_object, read_file};
use serde_json::{Map, Value, json};
use slipgap_study::Study;
use slipgap_study::error::Error;
use std::collections::BTreeSet;
use std::io::{self, ErrorKind, Write};
use std::path::Path;

/// Whether a file is the manifest of a folder of results and not a study. The content decides, because a study may have
/// the same name.
pub fn is_manifest(file: &Path) -> bool {
    let content = || {
        let manifest = json_of(file)?;
        let program = manifest["program"] == PROGRAM;
        Some(program && manifest["study_sha256"].is_string())
    };
    file.file_name().is_some_and(|name| name == MANIFEST) && content().unwrap_or(false)
}

/// Name of the problem in the manifest of a folder; `None` without a manifest, or in one of an earlier version.
pub fn problem_of(folder: &Path) -> Option<String> {
    let manifest = json_of(&folder.join(MANIFEST))?;
    Some(manifest["problem"].as_str()?.to_owned())
}

/// The manifest of a folder.
#[derive(Debug, Default)]
pub(super) struct Manifest {
    /// All entries; empty if the folder has no manifest.
    entries: Map<String, Value>,
    /// Files that runs wrote.
    files: BTreeSet<String>,
    /// Further files that an interrupted run may have written.
    unfinished: Unfinished,
}

/// Histories of an interrupted run: those of the first `cases`, except files that existed before.
#[derive(Debug, Default, Clone)]
struct Unfinished {
    cases: u64,
    others: BTreeSet<String>,
}

impl Manifest {
    /// Reads the manifest of a folder, if there is one.
    ///
    /// # Errors
    /// The manifest does not list the files that runs wrote.
    pub fn read(folder: &Path) -> Result<Manifest, Error> {
        let path = folder.join(MANIFEST);
        let bytes = match read_file(&path) {
            Err(e) if e.kind() == ErrorKind::NotFound => return Ok(Manifest::default()),
            read => read.map_err(Error::io("cannot read", &path))?,
        };
        let unread = || {
            let why = match is_object(&path) {
                // A network that asks for a password answers every request with its page.
                true => {
                    "the answer is no manifest of slipgap: damaged, a page of the network, or of another program"
                }
                false => {
                    "it does not list the files that former runs wrote; remove it, and remove the files that are out of date"
                }
            };
            Error::io("cannot read", path)(io::Error::other(why))
        };
        parse(&bytes).ok_or_else(unread)
    }

    /// Files that runs wrote or may have written.
    pub fn owned(&self, folder: &Path) -> BTreeSet<String> {
        let mut owned = self.files.clone();
        if self.unfinished.cases > 0 {
            let histories = histories(folder, self.unfinished.cases);
            owned.extend(histories.filter(|name| !self.unfinished.others.contains(name)));
        }
        owned
    }

    /// Writes the manifest of a run that begins. The run may write `names`, and histories of the first `cases`.
    pub fn begin(
        mut self,
        folder: &Path,
        origin: &Map<String, Value>,
        names: Vec<String>,
        cases: u64,
    ) -> Result<(), Error> {
        let owned = self.owned(folder);
        // Other files in the folder are the user's.
        let others = |name: &String| !owned.contains(name);
        if cases > 0 {
            let present = histories(folder, cases.max(self.unfinished.cases));
            self.unfinished.others = present.filter(others).collect();
            self.unfinished.cases = self.unfinished.cases.max(cases);
        }
        let listed = entries(folder).map_err(Error::io("cannot read", folder))?;
        let present: BTreeSet<String> = listed.into_iter().map(|entry| entry.name).collect();
        let new = names.into_iter().filter(|name| !present.contains(name));
        self.files.extend(new);
        // The origin of a former run is kept, because its results are still in the folder.
        let mut entries = match self.entries.is_empty() {
            true => origin.clone(),
            false => self.entries,
        };
        entries.insert("files".into(), json!(self.files));
        let Unfinished { cases, others } = self.unfinished;
        entries.insert(
            "unfinished".into(),
            json!({ "cases": cases, "others": others }),
        );
        write(folder, &entries)
    }

    /// Writes the manifest of a run that has ended, with the number of cases without contact and the warnings.
    pub fn end(
        folder: &Path,
        origin: Map<String, Value>,
        study: &Study,
        files: &[String],
        cases_without_contact: u64,
        warnings: &[WarnedCases],
    ) -> Result<(), Error> {
        let entries = ended(origin, study, files, cases_without_contact, warnings);
        write(folder, &entries)
    }
}

/// The manifest of a run that has ended and wrote these files.
pub fn manifest(
    study: &Study,
    file: &Path,
    files: &[String],
    cases_without_contact: u64,
    warnings: &[WarnedCases],
) -> Map<String, Value> {
    ended(
        origin(study, file),
        study,
        files,
        cases_without_contact,
        warnings,
    )
}

fn ended(
    origin: Map<String, Value>,
    study: &Study,
    files: &[String],
    cases_without_contact: u64,
    warnings: &[WarnedCases],
) -> Map<String, Value> {
    let mut entries = origin;
    entries.insert("files".into(), json!(files));
    if study.problem.schema().contact_metric.is_some() {
        entries.insert("cases_without_contact".into(), json!(cases_without_contact));
    }
    let warnings = warnings.iter().map(WarnedCases::json);
    entries.insert("warnings".into(), warnings.collect());
    entries
}

fn parse(bytes: &[u8]) -> Option<Manifest> {
    let entries: Map<String, Value> = serde_json::from_slice(bytes).ok()?;
    let names = |list: &Value| -> Option<BTreeSet<String>> {
        let names = list.as_array()?.iter();
        names.map(|name| Some(name.as_str()?.to_owned())).collect()
    };
    let files = names(entries.get("files")?)?;
    let unfinished = match entries.get("unfinished") {
        None => Unfinished::default(),
        Some(run) => Unfinished {
            cases: run.get("cases")?.as_u64()?,
            others: names(run.get("others")?)?,
        },
    };
    Some(Manifest {
        entries,
        files,
        unfinished,
    })
}

/// The histories of the first cases in the folder.
fn histories(folder: &Path, cases: u64) -> impl Iterator<Item = String> {
    let entries = entries(&folder.join(HISTORIES)).into_iter().flatten();
    entries.filter_map(move |Entry { name, .. }| {
        let case = name.strip_suffix(".csv")?.parse().ok()?;
        let matches = case < cases && name == format!("{case}.csv");
        matches.then(|| history_name(case))
    })
}

fn write(folder: &Path, entries: &Map<String, Value>) -> Result<(), Error> {
    let entries = Value::Object(entries.clone());
    write_atomically(&folder.join(MANIFEST), |out| {
        writeln!(out, "{entries:#}")?;
        // After a power failure without the manifest, no run would remove the files.
        out.sync()
    })
}
