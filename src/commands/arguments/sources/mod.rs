//! Reads the studies of a command. Each has the name of its folder of results.

use crate::batch::output;
use crate::batch::solve::cost;
use crate::commands::terminal::{note, progress};
use crate::error::Error;
pub use crate::run::STUDIES;
pub use crate::run::Source;
use crate::run::{check_printable, files, found, place_in_studies, results_name};
use crate::study::search::slashes;
use crate::study::{self, Input, Setting};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use walkdir::DirEntry;

/// Reads the studies in files and folders, in order, with the settings and at most `limit` raw combinations each. All
/// faults of all files are reported. `-` is standard input.
pub fn read(paths: &[PathBuf], settings: &[Setting], limit: u64) -> Result<Vec<Source>, Error> {
    let read = read_arguments(paths, settings, limit)?.into_iter();
    Ok(read.map(|(_, source)| source).collect())
}

/// The same, with the studies of each folder in the order of their cost, cheapest first: the first results come early.
pub fn read_cheapest_first(
    paths: &[PathBuf],
    settings: &[Setting],
    limit: u64,
) -> Result<Vec<Source>, Error> {
    let read = read_arguments(paths, settings, limit)?;
    // A cost takes as long as many cases: it is found only where there is an order to find.
    let mut counts = vec![0_usize; paths.len()];
    for (argument, _) in &read {
        counts[*argument] += 1;
    }
    let cost = |argument: usize, source: &Source| match counts[argument] {
        0 | 1 => 0.0,
        2.. => cost::total(&source.study),
    };
    let mut sources: Vec<(usize, f64, Source)> = read
        .into_iter()
        .map(|(argument, source)| (argument, cost(argument, &source), source))
        .collect();
    sources.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    Ok(sources.into_iter().map(|(.., source)| source).collect())
}

/// A study file.
struct StudyFile {
    /// Its path, or [`DASH`].
    file: PathBuf,
    /// The name of its folder of results.
    name: String,
    /// The number of the argument that names it or its folder.
    argument: usize,
}

/// The studies, each with the number of its argument.
fn read_arguments(
    paths: &[PathBuf],
    settings: &[Setting],
    limit: u64,
) -> Result<Vec<(usize, Source)>, Error> {
    let bar = progress::reading();
    let mut files = Vec::new();
    for (argument, path) in paths.iter().enumerate() {
        let found = find(path)?.into_iter();
        files.extend(found.map(|(file, name)| StudyFile {
            file,
            name,
            argument,
        }));
    }
    let files = distinct(files)?;
    let several = files.len() > 1;
    let inputs = files::read_all(files, |study_file| {
        let (file, input) = match study_file.file == Path::new(DASH) {
            true => (PathBuf::from(study::STDIN), Input::of_stdin()?),
            false => {
                let input = Input::of_file(&study_file.file)?;
                (study_file.file, input)
            }
        };
        let study_file = StudyFile { file, ..study_file };
        Ok((study_file, input.with(settings)))
    })?;
    let left_out = |input: &Input| several && !input.uses_settings();
    let some = inputs.iter().any(|(_, input)| !left_out(input));
    let (without, inputs): (Vec<_>, Vec<_>) = inputs
        .into_iter()
        .partition(|(_, input)| some && left_out(input));
    for (study_file, _) in &without {
        let text = format!(
            "{}: left out: it has no parameter record, and no synthetic motions with a list of seeds that records could replace",
            study_file.file.display()
        );
        bar.suspend(|| note(&text));
    }
    let sources = files::read_all(inputs, |(study_file, input)| {
        let source = Source::of_input(study_file.file.clone(), study_file.name, input, limit)
            .map_err(|error| match several {
                true => with_file_name(error, &study_file.file),
                false => error,
            })?;
        Ok((study_file.argument, source))
    });
    bar.finish_and_clear();
    sources
}

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
    let path = &found(path)?;
    if !path.is_dir() {
        return Ok(vec![(path.to_owned(), results_name(path)?)]);
    }
    let wanted = |entry: &DirEntry| {
        let hidden = entry.file_name().to_string_lossy().starts_with('.');
        // The folder may contain results too.
        files::is_json(entry) && !hidden && !output::is_manifest(entry.path())
    };
    let files = files::find(path, "studies (*.json)", wanted)?.into_iter();
    let folder = place_in_studies(path).unwrap_or_default();
    let named = files.map(|file| {
        let relative = file.strip_prefix(path).unwrap_or(&file).with_extension("");
        let name = slashes(&Path::new(&folder).join(relative));
        (file, name)
    });
    Ok(named.collect())
}

/// Removes repeated files. Two files with the same folder of results are an error.
fn distinct(files: Vec<StudyFile>) -> Result<Vec<StudyFile>, Error> {
    let mut by_name: BTreeMap<String, PathBuf> = BTreeMap::new();
    let mut distinct = Vec::new();
    for study_file in files {
        match by_name.get(&study_file.name) {
            None => {
                by_name.insert(study_file.name.clone(), study_file.file.clone());
                distinct.push(study_file);
            }
            Some(first) if same(first, &study_file.file) => {}
            Some(first) => {
                return Err(Error::Usage(format!(
                    "{} and {} would both write to folder {}; rename one or run them separately",
                    first.display(),
                    study_file.file.display(),
                    study_file.name
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
