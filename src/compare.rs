//! Comparison of two folders of results, study by study.

pub use crate::batch::compare::{Change, Comparison};
use crate::batch::compare::{compare, parameters, problem_of_columns, read};
use crate::batch::files::place::is_object;
use crate::batch::output::{RESULTS, differences_between, problem_of};
use crate::batch::store::{Rows, STORE};
use crate::run::files;
use slipgap_study::error::Error;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use walkdir::DirEntry;

/// The comparison of one study.
#[derive(Debug, Clone, PartialEq)]
pub enum Finding {
    /// Only one of the two folders has it: 0 is the first, 1 the second.
    OnlyIn(usize),
    /// The two results are of different problems.
    OtherProblem,
    /// Both have it.
    Compared(Comparison),
}

impl Finding {
    /// Whether nothing differs beyond the tolerance.
    pub fn same(&self) -> bool {
        match self {
            Finding::Compared(comparison) => comparison.same(),
            Finding::OnlyIn(_) | Finding::OtherProblem => false,
        }
    }
}

/// Compares the studies in the folders `a` and `b`, or these studies themselves. The name of a study is its path in the
/// folder, which is empty for the folder itself. Those that only the second folder has come first.
///
/// # Errors
/// A folder that cannot be read or has no results.
pub fn compare_folders(
    a: &Path,
    b: &Path,
    tolerance: f64,
) -> Result<Vec<(String, Finding)>, Error> {
    let (left, right) = (results(a)?, results(b)?);
    let only = right.keys().filter(|name| !left.contains_key(*name));
    let mut findings: Vec<(String, Finding)> = only
        .map(|name| (name.clone(), Finding::OnlyIn(1)))
        .collect();
    for (name, path) in &left {
        let finding = match right.get(name) {
            None => Finding::OnlyIn(0),
            Some(other) => compare_studies(path, other, tolerance)?,
        };
        findings.push((name.clone(), finding));
    }
    Ok(findings)
}

/// Compares the results of a study in two folders.
fn compare_studies(a: &Path, b: &Path, tolerance: f64) -> Result<Finding, Error> {
    let (first, second) = (read(a)?, read(b)?);
    let names = [(a, &first), (b, &second)].map(|(path, rows)| problem(path, rows));
    let known = match &names {
        [Some(problem), Some(other)] if problem == other => parameters(problem, &first, &second),
        [Some(_), Some(_)] | [None, _] | [_, None] => None,
    };
    Ok(match known {
        Some(parameters) => Finding::Compared(Comparison {
            origins: differences_between([a, b]),
            ..compare(&parameters, &first, &second, tolerance)
        }),
        None => Finding::OtherProblem,
    })
}

/// The folders with results in `path`, by relative path, which is empty for `path` itself.
fn results(path: &Path) -> Result<BTreeMap<String, PathBuf>, Error> {
    if is_object(path) {
        let why =
            "only folders are compared; copy the objects into one, for example by `aws s3 sync`";
        return Err(Error::Usage(format!("{}: {why}", path.display())));
    }
    std::fs::metadata(path).map_err(Error::io("cannot read", path))?;
    let wanted = |entry: &DirEntry| {
        let folder = entry.path();
        folder.join(RESULTS).is_file() || folder.join(STORE).is_dir()
    };
    let what = format!("results ({RESULTS} or {STORE})");
    let folders = files::find(path, &what, wanted)?.into_iter();
    let named = folders.map(|folder| {
        let name = folder.strip_prefix(path).unwrap_or(&folder);
        (name.display().to_string(), folder)
    });
    Ok(named.collect())
}

/// The name of the problem of a folder: the one in its manifest. If the manifest names none, the columns decide.
fn problem(folder: &Path, rows: &Rows) -> Option<String> {
    let of_columns = || problem_of_columns(&rows.columns).map(|p| p.name().to_owned());
    problem_of(folder).or_else(of_columns)
}
