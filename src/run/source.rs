//! A study and where it comes from.

use slipgap_study::error::Error;
use slipgap_study::search::{named, slashes};
use slipgap_study::{Input, Setting, Study, printable, unprintable};
use std::path::{Path, PathBuf};

/// A study and its origin.
#[derive(Debug)]
pub struct Source {
    /// The file as in the command, or the name of standard input.
    pub file: PathBuf,
    /// Its folder in the output folder, as in `claims/friction`.
    pub name: String,
    /// The text of the file.
    pub text: String,
    /// The study.
    pub study: Study,
}

impl Source {
    /// Reads one study file with these parameters set. Its results go to the folder of [`results_name`].
    ///
    /// # Errors
    /// A name that several files have or that no folder can have, a file that cannot be read, and all faults of the study.
    pub fn read(file: &Path, settings: &[Setting], limit: u64) -> Result<Source, Error> {
        let file = &found(file)?;
        let name = results_name(file)?;
        check_printable(file)?;
        let input = Input::of_file(file)?.with(settings);
        Source::of_input(file.to_owned(), name, input, limit)
    }

    /// The study in a text that has been read, of at most `limit` raw combinations.
    ///
    /// # Errors
    /// All faults of the study.
    pub fn of_input(
        file: PathBuf,
        name: String,
        input: Input,
        limit: u64,
    ) -> Result<Source, Error> {
        let study = input.study(limit)?;
        let text = input.into_text();
        Ok(Source {
            file,
            name,
            text,
            study,
        })
    }

    /// The text of the file and the settings of the command line.
    pub fn input(&self) -> Input {
        let programs = self.study.programs();
        Input::new(&self.file.display().to_string(), &self.text)
            .with(&self.study.settings)
            .with_programs(programs.and_then(|programs| programs.runner().cloned()))
    }

    /// The file and the settings of the command line.
    pub fn origin(&self) -> String {
        let mut origin = self.file.display().to_string();
        for setting in &self.study.settings {
            origin += &format!(" --set '{}'", setting.text());
        }
        origin
    }

    /// A line about the study that begins with its file.
    pub fn line(&self, what: &str) -> String {
        format!("{}: {what}", self.file.display())
    }
}

/// Where studies are if the command line names none.
pub const STUDIES: &str = "studies";

/// The file that a person means by `slide`: this one, `slide.json`, or the one of this name in the folder studies and its sub-folders.
///
/// # Errors
/// Several files in the folder studies have the name, or a folder in it cannot be read.
pub fn found(file: &Path) -> Result<PathBuf, Error> {
    let with_ending = match file.extension() {
        Some(ending) if ending == "json" => file.to_owned(),
        Some(_) | None => PathBuf::from(format!("{}.json", file.display())),
    };
    if let Some(path) = [file, &with_ending].into_iter().find(|path| path.exists()) {
        return Ok(path.to_owned());
    }
    match &named(Path::new(STUDIES), &with_ending)?[..] {
        [] => Ok(file.to_owned()),
        [one] => Ok(one.clone()),
        several => {
            let paths: Vec<String> = several
                .iter()
                .map(|path| path.display().to_string())
                .collect();
            Err(Error::Usage(format!(
                "{}: {} files have this name: {}; name one by its path",
                file.display(),
                several.len(),
                paths.join(", ")
            )))
        }
    }
}

/// The name of the folder of results of a study file: its path in the folder studies without `.json`, as in `bridges/slide`; elsewhere
/// its own name.
///
/// # Errors
/// `...json` without its ending is a path outside the output folder.
pub fn results_name(file: &Path) -> Result<String, Error> {
    let name = file_name(file)?;
    let folder = match file.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        Some(_) | None => Path::new("."),
    };
    Ok(match place_in_studies(folder) {
        Some(folder) if !folder.is_empty() => format!("{folder}/{name}"),
        Some(_) | None => name,
    })
}

/// The path of a folder in the folder studies, with `/` on every system and empty for itself; `None` elsewhere.
pub fn place_in_studies(folder: &Path) -> Option<String> {
    let studies = Path::new(STUDIES).canonicalize().ok()?;
    let folder = folder.canonicalize().ok()?;
    folder.strip_prefix(studies).ok().map(slashes)
}

/// The name of a study file without `.json`.
///
/// # Errors
/// `...json` without its ending is a path outside the output folder.
pub fn file_name(file: &Path) -> Result<String, Error> {
    let stem = file.file_stem().unwrap_or(file.as_os_str());
    match stem == "." || stem == ".." {
        true => {
            let file = file.display();
            let what = format!("{file} gives no valid name for a folder; rename it");
            Err(Error::Usage(what))
        }
        false => Ok(stem.to_string_lossy().into_owned()),
    }
}

/// Refuses the name of a study with characters that cannot be written to messages, tables, pictures and pages.
///
/// # Errors
/// There is such a character.
pub fn check_printable(file: &Path) -> Result<(), Error> {
    let shown = file.to_string_lossy();
    let Some(c) = unprintable(&shown) else {
        return Ok(());
    };
    let name = printable(&shown).replace('\n', "\\n").replace('\t', "\\t");
    let what = format!("{name}: the name of a study cannot contain {c}; rename it");
    Err(Error::Usage(what))
}
