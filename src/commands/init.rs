//! `slipgap init`: writes a small study as a start.

use super::terminal::print;
use slipgap::error::Error;
use slipgap::problem;
use slipgap::study;
use std::fs;
use std::path::{Path, PathBuf};

/// Folder of studies, and path of the schema.
const STUDIES: &str = "studies";
const SCHEMA: &str = "schema/study.json";

/// The problem of a name on the command line.
pub fn problem(name: &str) -> Result<&'static str, String> {
    problem::names()
        .find(|known| *known == name)
        .ok_or_else(|| {
            let names: Vec<&str> = problem::names().collect();
            format!("must be one of {}", names.join(", "))
        })
}

/// The name of a study without extension: a file name, also in sub-folders.
pub fn name(text: &str) -> Result<String, String> {
    let text = text.strip_suffix(".json").unwrap_or(text);
    let text = text.strip_prefix("studies/").unwrap_or(text);
    let good = |part: &str| {
        let plain = |c: char| c.is_ascii_alphanumeric() || "_-.".contains(c);
        !part.is_empty() && part.chars().all(plain) && !part.starts_with(['.', '-'])
    };
    if text.split('/').all(good) {
        return Ok(text.to_owned());
    }
    Err("must be letters, digits, _, - and . that do not begin with . or -".into())
}

/// Writes the study, and the schema for editors unless it exists; returns the exit code.
pub fn init(name: &str, problem: &str) -> Result<u8, Error> {
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
    fs::write(path, text).map_err(Error::io("cannot write", path))
}
