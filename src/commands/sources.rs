//! From what the user named to the studies that are meant, each with the folder its results go to.

use super::files;
use slipgap::batch::output;
use slipgap::error::Error;
use slipgap::study::{self, Input, Setting, Study};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use walkdir::DirEntry;

/// A study and where it came from.
pub struct Source {
    /// The file as the user named it, or the name of standard input.
    pub file: PathBuf,
    /// Its folder under the output folder, as in `claims/friction`.
    pub name: String,
    /// Its text, as it was read.
    pub text: String,
    /// The study.
    pub study: Study,
}

impl Source {
    /// What the study was read from: the file, and what the command line set.
    pub fn origin(&self) -> String {
        let mut origin = self.file.display().to_string();
        for setting in &self.study.settings {
            origin += &format!(" --set '{}'", setting.text());
        }
        origin
    }
}

/// Reads every study of the files and folders named, in order, each of at most `limit` raw combinations and with
/// parameters set; every fault of every file is reported. `-` is standard input.
pub fn read(named: &[PathBuf], settings: &[Setting], limit: u64) -> Result<Vec<Source>, Error> {
    let mut files = Vec::new();
    for path in named {
        files.extend(find(path)?);
    }
    let files = distinct(files)?;
    let several = files.len() > 1;
    files::each(files, |(file, name)| {
        let (file, input) = match file == Path::new(DASH) {
            true => (PathBuf::from(study::STDIN), Input::of_stdin()?),
            false => {
                let input = Input::of_file(&file)?;
                (file, input)
            }
        };
        let input = input.with(settings);
        let study = input.study(limit);
        let study = study.map_err(|error| if several { naming(error, &file) } else { error })?;
        let text = input.into_text();
        Ok(Source {
            file,
            name,
            text,
            study,
        })
    })
}

/// How standard input is named on the command line.
pub const DASH: &str = "-";

/// Names the study in faults of settings, which are the same for several studies.
fn naming(mut error: Error, file: &Path) -> Error {
    if let Error::Faults(faults) = &mut error {
        for fault in faults
            .iter_mut()
            .filter(|fault| fault.file != file.display().to_string())
        {
            fault.message += &format!(" (in {})", file.display());
        }
    }
    error
}

/// The study files under `path`, by name, each with its path relative to it and without `.json`.
fn find(path: &Path) -> Result<Vec<(PathBuf, String)>, Error> {
    if path == Path::new(DASH) {
        return Ok(vec![(path.to_owned(), "stdin".into())]);
    }
    let found = named(path)?;
    // Names go into messages, tables, pictures and pages.
    for (file, _) in &found {
        let shown = file.to_string_lossy();
        if let Some(c) = study::unprintable(&shown) {
            let name = study::printable(&shown)
                .replace('\n', "\\n")
                .replace('\t', "\\t");
            let what = format!("{name}: the name of a study cannot contain {c}; rename it");
            return Err(Error::Usage(what));
        }
    }
    Ok(found)
}

fn named(path: &Path) -> Result<Vec<(PathBuf, String)>, Error> {
    if !path.is_dir() {
        let stem = path.file_stem().unwrap_or(path.as_os_str());
        // `...json` without its ending is a way out of the output folder.
        if stem == "." || stem == ".." {
            let what = format!(
                "{} gives no valid name for a folder; rename it",
                path.display()
            );
            return Err(Error::Usage(what));
        }
        return Ok(vec![(path.to_owned(), name(Path::new(stem)))]);
    }
    let wanted = |entry: &DirEntry| {
        let hidden = entry.file_name().to_string_lossy().starts_with('.');
        // Results may stand in the folder that is read.
        files::is_json(entry) && !hidden && !output::is_manifest(entry.path())
    };
    let found = files::under(path, "studies (*.json)", wanted)?.into_iter();
    let named = found.map(|file| {
        let relative = file.strip_prefix(path).unwrap_or(&file).with_extension("");
        let name = name(&relative);
        (file, name)
    });
    Ok(named.collect())
}

/// Drops a file named twice; refuses two files whose results would share a folder.
fn distinct(files: Vec<(PathBuf, String)>) -> Result<Vec<(PathBuf, String)>, Error> {
    let mut taken: BTreeMap<String, PathBuf> = BTreeMap::new();
    let mut kept = Vec::new();
    for (file, name) in files {
        match taken.get(&name) {
            None => {
                taken.insert(name.clone(), file.clone());
                kept.push((file, name));
            }
            Some(first) if same(first, &file) => {}
            Some(first) => {
                return Err(Error::Usage(format!(
                    "{} and {} would both write to folder {name}; rename one or run them separately",
                    first.display(),
                    file.display()
                )));
            }
        }
    }
    Ok(kept)
}

fn same(a: &Path, b: &Path) -> bool {
    match (a.canonicalize(), b.canonicalize()) {
        (Ok(a), Ok(b)) => a == b,
        _ => a == b,
    }
}

/// A relative path with `/` on every system.
fn name(path: &Path) -> String {
    let parts: Vec<_> = path.iter().map(|part| part.to_string_lossy()).collect();
    parts.join("/")
}
