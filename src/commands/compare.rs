//! `slipgap compare`: what two folders of results differ in.

use super::{NOT_MET, columns, files, note, say};
use slipgap::batch::output::{RESULTS, problem_of};
use slipgap::batch::store::{self, STORE};
use slipgap::compare::{Rows, compare as compare_tables, problem_of_columns};
use slipgap::error::Error;
use slipgap::problem::parameter::shortest;
use slipgap::problem::{Problem, find};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use walkdir::DirEntry;

/// Compares the studies that `a` and `b` hold, or are; gives the exit code.
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
    let apart = |name: &str, why: String| {
        note(&format!("{}: {why}", shown(name)));
        1
    };
    for name in right.keys().filter(|name| !left.contains_key(*name)) {
        differing += apart(name, format!("only in {}", b.display()));
    }
    for (name, path) in &left {
        let Some(other) = right.get(name) else {
            differing += apart(name, format!("only in {}", a.display()));
            continue;
        };
        let (first, second) = (read(path)?, read(other)?);
        let problems = [(path, &first), (other, &second)].map(|(path, rows)| problem(path, rows));
        let problem = match problems {
            [Some(problem), Some(second)] if problem.name() == second.name() => problem,
            [Some(_), Some(_)] | [None, _] | [_, None] => {
                differing += apart(name, "the two results are of different problems".into());
                continue;
            }
        };
        let found = compare_tables(&*problem, &first, &second, tolerance);
        if found.same() {
            same += 1;
            continue;
        }
        let sides = found.alone.iter().zip(&found.columns).zip([a, b]);
        for ((cases, metrics), side) in sides {
            let side = side.display();
            if *cases > 0 {
                note(&format!("{}: {cases} cases only in {side}", shown(name)));
            }
            if !metrics.is_empty() {
                note(&format!(
                    "{}: {} only in {side}",
                    shown(name),
                    metrics.join(", ")
                ));
            }
        }
        differing += 1;
        for change in found.changes {
            let [first, second] = change.cells;
            rows.push(vec![
                shown(name).to_owned(),
                change.metric,
                format!("{} of {}", change.cases, found.common),
                shortest((change.largest * 1e6).round() / 1e6),
                change.case,
                first,
                second,
            ]);
        }
    }
    if rows.len() > 1 {
        say(&columns(&rows))?;
    }
    note(&format!("{same} studies equal, {differing} different"));
    Ok(if differing > 0 { NOT_MET } else { 0 })
}

/// What a folder is called that is itself one study's.
fn shown(name: &str) -> &str {
    if name.is_empty() { "." } else { name }
}

/// The folders with results under `path`, by their way from it; its own is called nothing.
fn results(path: &Path) -> Result<BTreeMap<String, PathBuf>, Error> {
    std::fs::metadata(path).map_err(Error::io("cannot read", path))?;
    let wanted = |entry: &DirEntry| {
        let folder = entry.path();
        folder.join(RESULTS).is_file() || folder.join(STORE).is_dir()
    };
    let what = format!("results ({RESULTS} or {STORE})");
    let found = files::under(path, &what, wanted)?.into_iter();
    let named = found.map(|folder| {
        let name = folder.strip_prefix(path).unwrap_or(&folder);
        (name.display().to_string(), folder)
    });
    Ok(named.collect())
}

/// The problem of a folder: the one in its manifest. If the manifest names none, the columns decide.
fn problem(folder: &Path, rows: &Rows) -> Option<Arc<dyn Problem>> {
    match problem_of(folder) {
        Some(name) => find(&name),
        None => problem_of_columns(&rows.columns),
    }
}

/// The table of one folder.
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
