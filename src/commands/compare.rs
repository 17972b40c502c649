//! `slipgap compare`: the differences of two folders of results.

use super::NOT_MET;
use super::sources::files;
use super::terminal::{note, print, table};
use slipgap::batch::output::{RESULTS, problem_of};
use slipgap::batch::store::{self, STORE};
use slipgap::compare::{Rows, compare as compare_rows, parameters, problem_of_columns};
use slipgap::error::Error;
use slipgap::problem::parameter::shortest;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use walkdir::DirEntry;

/// Compares the studies in the folders `a` and `b`, or these studies themselves; returns the exit code.
pub fn compare(a: &Path, b: &Path, tolerance: f64) -> Result<u8, Error> {
    let (left, right) = (results(a)?, results(b)?);
    let mut rows = vec![
        [
            "study", "metric", "cases", "largest", "at case", "first", "second",
        ]
        .map(String::from)
        .to_vec(),
    ];
    let (mut same, mut differing) = (0, 0);
    let report = |name: &str, why: String| {
        note(&format!("{}: {why}", display_name(name)));
        1
    };
    for name in right.keys().filter(|name| !left.contains_key(*name)) {
        differing += report(name, format!("only in {}", b.display()));
    }
    for (name, path) in &left {
        let Some(other) = right.get(name) else {
            differing += report(name, format!("only in {}", a.display()));
            continue;
        };
        let (first, second) = (read(path)?, read(other)?);
        let names = [(path, &first), (other, &second)].map(|(path, rows)| problem(path, rows));
        let known = match &names {
            [Some(problem), Some(other)] if problem == other => {
                parameters(problem, &first, &second)
            }
            [Some(_), Some(_)] | [None, _] | [_, None] => None,
        };
        let Some(parameters) = known else {
            differing += report(name, "the two results are of different problems".into());
            continue;
        };
        let comparison = compare_rows(&parameters, &first, &second, tolerance);
        if comparison.same() {
            same += 1;
            continue;
        }
        let sides = comparison.alone.iter().zip(&comparison.columns);
        let sides = sides.zip([a, b]);
        for ((cases, metrics), side) in sides {
            let side = side.display();
            if *cases > 0 {
                note(&format!(
                    "{}: {cases} cases only in {side}",
                    display_name(name)
                ));
            }
            if !metrics.is_empty() {
                note(&format!(
                    "{}: {} only in {side}",
                    display_name(name),
                    metrics.join(", ")
                ));
            }
        }
        differing += 1;
        for change in comparison.changes {
            let [first, second] = change.cells;
            rows.push(vec![
                display_name(name).to_owned(),
                change.metric,
                format!("{} of {}", change.cases, comparison.common),
                shortest((change.largest * 1e6).round() / 1e6),
                change.case,
                first,
                second,
            ]);
        }
    }
    if rows.len() > 1 {
        print(&table(&rows))?;
    }
    note(&format!("{same} studies equal, {differing} different"));
    Ok(if differing > 0 { NOT_MET } else { 0 })
}

/// The name of a study; a point for the folder of the command itself.
fn display_name(name: &str) -> &str {
    if name.is_empty() { "." } else { name }
}

/// The folders with results in `path`, by relative path, which is empty for `path` itself.
fn results(path: &Path) -> Result<BTreeMap<String, PathBuf>, Error> {
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

/// The results in a folder.
fn read(folder: &Path) -> Result<Rows, Error> {
    let file = folder.join(RESULTS);
    if !file.is_file() {
        return store::rows(folder);
    }
    let unread = |error: csv::Error| Error::io("cannot read", &file)(error.into());
    let mut reader = csv::Reader::from_path(&file).map_err(unread)?;
    let cells = |record: &csv::StringRecord| record.iter().map(String::from).collect();
    let columns = cells(reader.headers().map_err(unread)?);
    let rows = reader
        .records()
        .map(|record| record.map(|r| cells(&r)).map_err(unread));
    let rows = rows.collect::<Result<Vec<Vec<String>>, Error>>()?;
    Ok(Rows { columns, rows })
}
