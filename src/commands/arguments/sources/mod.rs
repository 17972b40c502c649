//! Reads the studies of a command. Each has the name of its folder of results.

use crate::batch::output;
use crate::commands::terminal::note;
use crate::error::Error;
pub use crate::run::Source;
use crate::run::{check_printable, file_name, files, found};
use crate::study::{self, Input, Setting};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use walkdir::DirEntry;

/// Reads the studies in files and folders, in order, with the settings and at most `limit` raw combinations each. All
/// faults of all files are reported. `-` is standard input.
pub fn read(paths: &[PathBuf], settings: &[Setting], limit: u64) -> Result<Vec<Source>, Error> {
    let mut files = Vec::new();
    for path in paths {
        files.extend(find(path)?);
    }
    let files = distinct(files)?;
    let several = files.len() > 1;
    let inputs = files::read_all(files, |(file, name)| {
        let (file, input) = match file == Path::new(DASH) {
            true => (PathBuf::from(study::STDIN), Input::of_stdin()?),
            false => {
                let input = Input::of_file(&file)?;
                (file, input)
            }
        };
        Ok((file, name, input.with(settings)))
    })?;
    let left_out = |input: &Input| several && !input.uses_settings();
    let some = inputs.iter().any(|(_, _, input)| !left_out(input));
    let (without, inputs): (Vec<_>, Vec<_>) = inputs
        .into_iter()
        .partition(|(_, _, input)| some && left_out(input));
    for (file, ..) in &without {
        note(&format!(
            "{}: left out: it has no parameter record, and no synthetic motions with a list of seeds that records could replace",
            file.display()
        ));
    }
    files::read_all(inputs, |(file, name, input)| {
        let source = Source::of_input(file.clone(), name, input, limit);
        source.map_err(|error| match several {
            true => with_file_name(error, &file),
            false => error,
        })
    })
}

/// Where studies are if the command line names none.
pub const STUDIES: &str = "studies";

/// The name of standard input on the command line.
pub const DASH: &str = "-";

/// Adds the name of the study to faults of settings, which are the same for several studies.
fn with_file_name(mut error: Error, file: &Path) -> Error {
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

/// The study files in `path`, sorted, each with its relative path without `.json`.
fn find(path: &Path) -> Result<Vec<(PathBuf, String)>, Error> {
    if path == Path::new(DASH) {
        return Ok(vec![(path.to_owned(), "stdin".into())]);
    }
    let files = find_named(path)?;
    for (file, _) in &files {
        check_printable(file)?;
    }
    Ok(files)
}

fn find_named(path: &Path) -> Result<Vec<(PathBuf, String)>, Error> {
    if path == Path::new(STUDIES) && !path.exists() {
        let message = "no folder studies here; name a study file or a folder, or write a first study by `slipgap init`";
        return Err(Error::Usage(message.into()));
    }
    let path = &found(path);
    if !path.is_dir() {
        return Ok(vec![(path.to_owned(), file_name(path)?)]);
    }
    let wanted = |entry: &DirEntry| {
        let hidden = entry.file_name().to_string_lossy().starts_with('.');
        // The folder may contain results too.
        files::is_json(entry) && !hidden && !output::is_manifest(entry.path())
    };
    let files = files::find(path, "studies (*.json)", wanted)?.into_iter();
    let named = files.map(|file| {
        let relative = file.strip_prefix(path).unwrap_or(&file).with_extension("");
        let name = name(&relative);
        (file, name)
    });
    Ok(named.collect())
}

/// Removes repeated files. Two files with the same folder of results are an error.
fn distinct(files: Vec<(PathBuf, String)>) -> Result<Vec<(PathBuf, String)>, Error> {
    let mut by_name: BTreeMap<String, PathBuf> = BTreeMap::new();
    let mut distinct = Vec::new();
    for (file, name) in files {
        match by_name.get(&name) {
            None => {
                by_name.insert(name.clone(), file.clone());
                distinct.push((file, name));
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
    Ok(distinct)
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
