//! `slipgap init`: writes a small study as a start.

use super::arguments::Expected;
use super::terminal::print;
use crate::batch::files::atomic::write_file;
use crate::error::Error;
use crate::problem;
use crate::study;
use clap::Args;
use clap::builder::PossibleValuesParser;
use std::fs;
use std::path::{Path, PathBuf};

/// Folder of studies, and path of the schema.
const STUDIES: &str = "studies";
const SCHEMA: &str = "schema/study.json";

/// The arguments of `slipgap init`.
#[derive(Args)]
pub struct InitArgs {
    /// Name of the study, without .json
    #[arg(value_parser = name)]
    name: String,
    /// Problem of the study
    #[arg(long, value_parser = PossibleValuesParser::new(problem::names()))]
    problem: Option<String>,
}

impl InitArgs {
    /// Writes the study; returns the exit code.
    pub fn execute(self) -> Result<u8, Error> {
        let problem = self.problem.ok_or_else(|| {
            let names: Vec<&str> = problem::names().collect();
            Error::Usage(format!("missing: --problem; one of {}", names.join(", ")))
        })?;
        init(&self.name, &problem)
    }
}

/// The name of a study without extension: a file name, also in sub-folders.
fn name(text: &str) -> Result<String, Expected> {
    let stem = text.strip_suffix(".json").unwrap_or(text);
    let text = stem.strip_prefix("studies/").unwrap_or(stem);
    let good = |part: &str| {
        let plain = |c: char| c.is_ascii_alphanumeric() || "_-.".contains(c);
        !part.is_empty() && part.chars().all(plain) && !part.starts_with(['.', '-'])
    };
    if text.split('/').all(good) {
        return Ok(text.to_owned());
    }
    Err(Expected(
        "letters, digits, _, - and . that do not begin with . or -".into(),
    ))
}

/// Writes the study, and the schema for editors unless it exists; returns the exit code.
fn init(name: &str, problem: &str) -> Result<u8, Error> {
    let path = Path::new(STUDIES).join(format!("{name}.json"));
    if path.exists() {
        let what = format!("{} exists already; choose another name", path.display());
        return Err(Error::Usage(what));
    }
    let up = "../".repeat(name.split('/').count());
    let none = || Error::Usage(format!("{problem} has no example study"));
    let text = study::start(problem)
        .ok_or_else(none)?
        .replace("SCHEMA", &format!("{up}{SCHEMA}"))
        .replace("NAME", name);
    write(&path, &text)?;
    let mut lines = format!("{}\n", path.display());
    let schema = PathBuf::from(SCHEMA);
    if !schema.exists() {
        write(&schema, &study::schema())?;
        lines += &format!("{SCHEMA}\n");
    }
    print(&lines)
}

fn write(path: &Path, text: &str) -> Result<(), Error> {
    if let Some(parent) = path.parent() {
        fs::create_dir_all(parent).map_err(Error::io("cannot make folder", parent))?;
    }
    write_file(path, text.as_bytes())
}
