//! The origin of results: the study, the files that it reads, the versions; and what of it has changed.

use super::names::{MANIFEST, PROGRAM, RESULTS};
use crate::files::place::{is_file, read_file};
use crate::store::key::SOLVER_VERSION;
use serde_json::{Map, Value, json};
use slipgap_study::{ReadFile, Setting, Study};
use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

/// The key of the files that were read with the study: records, matrices, tables, measurements.
const INPUTS: &str = "inputs";

/// Most files that a note lists.
const MOST: usize = 5;

/// Digits of a hash in a note.
const DIGITS: usize = 12;

/// The origin of results: study, versions, commit, settings and files read. It asks git, which takes as long as thousands of cases.
pub fn origin(study: &Study, file: &Path) -> Map<String, Value> {
    let mut entries = json!({
        "study": file.file_name().map(|name| name.to_string_lossy()),
        "study_sha256": study.sha256,
        "problem": study.problem.name(),
        "program": PROGRAM,
        "program_version": env!("CARGO_PKG_VERSION"),
        "solver_version": SOLVER_VERSION,
        "git_commit": commit_of(file),
    });
    if !study.settings.is_empty() {
        let settings = study.settings.iter().map(Setting::text);
        entries["set"] = settings.collect();
    }
    if !study.read.is_empty() {
        let one = |file: &ReadFile| json!({ "name": file.name, "size": file.size, "sha256": file.sha256 });
        entries[INPUTS] = study.read.iter().map(one).collect();
    }
    let Value::Object(entries) = entries else {
        return Map::new();
    };
    entries
}

/// What the results in a folder are of that is not the study as it is now: another version of it, of its files, or of the program.
/// Empty without results.
pub fn differences(results: &Path, study: &Study) -> Vec<String> {
    let Some(manifest) = json_of(&results.join(MANIFEST)) else {
        return Vec::new();
    };
    let mut found = Vec::new();
    if manifest["study_sha256"].as_str() != Some(&study.sha256) {
        found.push("an earlier version of the study".to_owned());
    }
    let read_files = study.read.iter().map(|file| (&*file.name, &*file.sha256));
    let now: BTreeMap<&str, &str> = read_files.collect();
    match inputs(&manifest) {
        None if !now.is_empty() => {
            found.push("files of which manifest.json has no hashes".to_owned());
        }
        read => {
            let read = read.unwrap_or_default();
            let names = joined(&read, &now);
            let one = |name: &&str| match (read.get(name), now.get(name)) {
                (Some(then), Some(now)) if then != now => {
                    Some(format!("another {name}{}", hashes(then, now)))
                }
                (Some(_), None) => Some(format!("{name}, which the study does not read")),
                (None, Some(_)) => Some(format!("the study without {name}")),
                (Some(_), Some(_)) | (None, None) => None,
            };
            found.extend(few(names.iter().filter_map(one).collect()));
        }
    }
    found.extend(version(&manifest, &versions()));
    found
}

/// Of what else than the study as it is now the results.csv of a folder is; empty without one.
pub fn outdated(results: &Path, study: &Study) -> Vec<String> {
    match is_file(&results.join(RESULTS)) {
        true => differences(results, study),
        false => Vec::new(),
    }
}

/// The sentence about these differences of the results in a folder.
pub fn of_others(results: &Path, differences: &[String]) -> String {
    let (results, what) = (results.display(), differences.join("; "));
    format!("the results in {results} are of {what}")
}

/// In what the origins of two folders of results differ, besides the study.
pub fn differences_between(folders: [&Path; 2]) -> Vec<String> {
    let [Some(a), Some(b)] = folders.map(|folder| json_of(&folder.join(MANIFEST))) else {
        return Vec::new();
    };
    let mut found = Vec::new();
    if let (Some(first), Some(second)) = (inputs(&a), inputs(&b)) {
        let names = joined(&first, &second);
        let one = |name: &&str| match (first.get(name), second.get(name)) {
            (Some(one), Some(other)) if one != other => {
                Some(format!("{name} differs{}", hashes(one, other)))
            }
            (Some(_), None) => Some(format!("{name} was read only for the first")),
            (None, Some(_)) => Some(format!("{name} was read only for the second")),
            (Some(_), Some(_)) | (None, None) => None,
        };
        found.extend(few(names.iter().filter_map(one).collect()));
    }
    if let Some(other) = version(&b, &a) {
        let first = version(&a, &b).unwrap_or_default();
        found.push(format!("the first is of {first}, the second of {other}"));
    }
    found
}

/// The JSON in a file, if there is any.
pub(super) fn json_of(file: &Path) -> Option<Value> {
    serde_json::from_slice(&read_file(file).ok()?).ok()
}

/// The files of a manifest with their hashes; `None` for a manifest that lists none.
fn inputs(manifest: &Value) -> Option<BTreeMap<&str, &str>> {
    let files = manifest.get(INPUTS)?.as_array()?;
    let mut found = BTreeMap::new();
    for file in files {
        found.insert(file.get("name")?.as_str()?, file.get("sha256")?.as_str()?);
    }
    Some(found)
}

/// The names of both.
fn joined<'a>(a: &BTreeMap<&'a str, &str>, b: &BTreeMap<&'a str, &str>) -> Vec<&'a str> {
    let mut names: Vec<&str> = a.keys().chain(b.keys()).copied().collect();
    names.sort_unstable();
    names.dedup();
    names
}

/// The first of several, and how many more there are.
fn few(mut found: Vec<String>) -> Vec<String> {
    if found.len() > MOST {
        let more = found.len() - MOST;
        found.truncate(MOST);
        found.push(format!("{more} more files"));
    }
    found
}

/// The first digits of two hashes, in brackets.
fn hashes(one: &str, other: &str) -> String {
    let [one, other] = [one, other].map(|hash| hash.get(..DIGITS).unwrap_or(hash));
    format!(" (sha256 {one} and {other})")
}

/// The versions of this program.
fn versions() -> Value {
    json!({ "program_version": env!("CARGO_PKG_VERSION"), "solver_version": SOLVER_VERSION })
}

/// The version of the program that a manifest has, if it is not that of the other one.
fn version(manifest: &Value, other: &Value) -> Option<String> {
    let same = |key: &str| manifest[key] == other[key];
    let shown = |key: &str| {
        let value = &manifest[key];
        value
            .as_str()
            .map_or_else(|| value.to_string(), str::to_owned)
    };
    let differs = !["program_version", "solver_version"].into_iter().all(same);
    let [program, solver] = ["program_version", "solver_version"].map(shown);
    differs.then(|| format!("version {program} of the program, with solver {solver}"))
}

/// The commit of the repository of the study, if it is a file in a repository and git is installed.
fn commit_of(file: &Path) -> Option<String> {
    if !file.is_file() {
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
