//! The folder of one study's results: whole files only, and nothing left over from a former run.

use super::chunk::SOLVER_VERSION;
use super::whole::whole;
use crate::error::Error;
use crate::study::Study;
use serde_json::{Value, json};
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Name of the table of results.
pub const RESULTS: &str = "results.csv";

const MANIFEST: &str = "manifest.json";

/// Whether a file is the manifest of a folder of results, and so no study: by what it holds, since a study may have its
/// name.
pub fn is_manifest(file: &Path) -> bool {
    let ours = || {
        let manifest: Value = serde_json::from_slice(&fs::read(file).ok()?).ok()?;
        let own = manifest["program"] == env!("CARGO_PKG_NAME");
        Some(own && manifest["study_sha256"].is_string())
    };
    file.file_name().is_some_and(|name| name == MANIFEST) && ours().unwrap_or(false)
}

/// A folder that results go to, and what this run has put there.
#[derive(Debug)]
pub struct Folder {
    path: PathBuf,
    written: Vec<String>,
}

impl Folder {
    /// Makes the folder and tries to write in it, so that an answer comes before any computing.
    pub fn open(path: &Path) -> Result<Folder, Error> {
        fs::create_dir_all(path).map_err(Error::io("cannot make folder", path))?;
        let probe = path.join(".slipgap-probe");
        fs::write(&probe, b"").map_err(Error::io("cannot write in folder", path))?;
        fs::remove_file(&probe).map_err(Error::io("cannot write in folder", path))?;
        Ok(Folder {
            path: path.to_owned(),
            written: Vec::new(),
        })
    }

    /// Writes `name`, as in `histories/3.csv`, and gives its path.
    pub fn write(&mut self, name: &str, bytes: &[u8]) -> Result<PathBuf, Error> {
        self.written.push(name.to_owned());
        self.put(name, |out| out.write_all(bytes))
    }

    /// Writes one of many files of a sub-folder, piece by piece, without noting it; see [`Folder::note`].
    pub fn put(
        &self,
        name: &str,
        write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
    ) -> Result<PathBuf, Error> {
        let path = self.path.join(name);
        if let Some(parent) = path.parent() {
            fs::create_dir_all(parent).map_err(Error::io("cannot make folder", parent))?;
        }
        whole(&path, write)?;
        Ok(path)
    }

    /// Takes a file written elsewhere on the same disk as `name`, and gives its path.
    pub fn take(&mut self, from: &Path, name: &str) -> Result<PathBuf, Error> {
        let path = self.path.join(name);
        fs::rename(from, &path).map_err(Error::io("cannot write", &path))?;
        self.written.push(name.to_owned());
        Ok(path)
    }

    /// Notes files that [`Folder::put`] wrote.
    pub fn note(&mut self, names: impl Iterator<Item = String>) {
        self.written.extend(names);
    }

    /// Removes what a former run wrote and this one did not, then writes the manifest, with the number of cases in which
    /// no contact happens.
    pub fn close(mut self, study: &Study, file: &Path, untouched: u64) -> Result<(), Error> {
        self.written.sort();
        for name in self.former() {
            // Only names inside the folder: a manifest edited by hand must not reach further.
            let inside = Path::new(&name)
                .components()
                .all(|part| matches!(part, std::path::Component::Normal(_)));
            if inside && self.written.binary_search(&name).is_err() {
                let path = self.path.join(&name);
                // A folder in its place is not what the run wrote.
                if path.is_dir() {
                    continue;
                }
                match fs::remove_file(&path) {
                    Err(e) if e.kind() != std::io::ErrorKind::NotFound => {
                        return Err(Error::io("cannot remove", path)(e));
                    }
                    _ => {}
                }
                // A sub-folder goes with its last file; one that still holds something stays.
                if let Some(parent) = path.parent().filter(|parent| *parent != self.path) {
                    let _ = fs::remove_dir(parent);
                }
            }
        }
        let mut manifest = json!({
            "study": file.file_name().map(|name| name.to_string_lossy()),
            "study_sha256": study.sha256,
            "program": env!("CARGO_PKG_NAME"),
            "program_version": env!("CARGO_PKG_VERSION"),
            "solver_version": SOLVER_VERSION,
            "git_commit": commit_of(file),
            "files": self.written,
        });
        if study.problem.contact().is_some() {
            manifest["cases_without_contact"] = untouched.into();
        }
        whole(&self.path.join(MANIFEST), |out| {
            writeln!(out, "{manifest:#}")
        })
    }

    /// Files that a former run's manifest names.
    fn former(&self) -> Vec<String> {
        let manifest = fs::read(self.path.join(MANIFEST)).unwrap_or_default();
        let manifest: Value = serde_json::from_slice(&manifest).unwrap_or_default();
        let files = manifest["files"].as_array().into_iter().flatten();
        files
            .filter_map(|name| Some(name.as_str()?.to_owned()))
            .collect()
    }
}

/// The commit of the repository that holds the study, if it stands in one and git is there to ask.
fn commit_of(file: &Path) -> Option<String> {
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
