//! Comparison of two tables of results, case by case and metric by metric.

use crate::output::RESULTS;
use crate::store::{self, Rows};
use std::borrow::Cow;
use std::collections::HashMap;
use std::path::Path;
use std::sync::Arc;

use slipgap_problem::problem::numbers::parameter::{self, ColumnRule, Parameter};
use slipgap_problem::problem::structure::metrics::metric::{OF_PROGRAMS, looks_like_metric};
use slipgap_problem::problem::structure::tables::schema::{NAME, named};
use slipgap_problem::problem::{PROBLEMS, Problem, find};
use slipgap_study::error::Error;
use slipgap_study::units::scaled;

/// The differences of one metric.
#[derive(Debug, Clone, PartialEq)]
pub struct Change {
    /// The column.
    pub metric: String,
    /// Number of cases that differ by more than the tolerance, or have a value on one side only.
    pub cases: usize,
    /// The largest difference, relative to the larger magnitude; infinite if one side has no value.
    pub largest: f64,
    /// Number of its case on the first side.
    pub case: String,
    /// The two cells.
    pub cells: [String; 2],
}

/// The differences of two tables.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Comparison {
    /// Metrics that changed beyond the tolerance, the largest difference first.
    pub changes: Vec<Change>,
    /// Cases that both have.
    pub common: usize,
    /// Cases on the first side only, and on the second.
    pub alone: [usize; 2],
    /// Metrics on the first side only, and on the second; those in the units of a study are not counted.
    pub columns: [Vec<String>; 2],
    /// In what the files and the program differ that the results are of.
    pub origins: Vec<String>,
}

impl Comparison {
    /// Whether nothing differs beyond the tolerance.
    pub fn same(&self) -> bool {
        self.changes.is_empty() && self.alone == [0, 0] && self.columns.iter().all(Vec::is_empty)
    }
}

/// The parameters of the problem called `name`, as columns of two tables; those of structures have the names that the tables give
/// them. `None` if there is no such problem.
pub fn parameters(name: &str, a: &Rows, b: &Rows) -> Option<Vec<Parameter>> {
    if name != NAME {
        return Some(find(name)?.parameters().to_vec());
    }
    let mut names: Vec<&String> = Vec::new();
    for column in a.columns.iter().chain(&b.columns) {
        if column != "case" && !looks_like_metric(column) && !names.contains(&column) {
            names.push(column);
        }
    }
    Some(names.into_iter().map(|name| named(name)).collect())
}

/// The results in a folder, as its table or its store has them.
///
/// # Errors
/// A file that cannot be read.
pub fn read(folder: &Path) -> Result<Rows, Error> {
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
        .map(|record| record.map(|r| cells(&r)).map_err(unread))
        .collect::<Result<Vec<Vec<String>>, Error>>()?;
    Ok(Rows { columns, rows })
}

/// The metric that is not compared.
const WALL: &str = OF_PROGRAMS[1];

/// The problem whose parameters are columns of a table: a guess for folders without a problem in the manifest.
pub fn problem_of_columns(columns: &[String]) -> Option<Arc<dyn Problem>> {
    let has_all = |problem: &&Arc<dyn Problem>| {
        let mut table = problem.parameters().iter();
        table.all(|p| {
            p.column == ColumnRule::IfGiven || columns.iter().any(|c| *c == p.column_name())
        })
    };
    PROBLEMS.iter().find(has_all).cloned()
}

/// Compares two tables of a problem with these parameters. Cases are the same if all their parameters are the same; their numbers may differ. A
/// parameter without a column has its default in every case.
pub fn compare(parameters: &[Parameter], a: &Rows, b: &Rows, tolerance: f64) -> Comparison {
    let has = |rows: &Rows, name: &str| rows.columns.iter().any(|column| column == name);
    let is_metric =
        |name: &&String| **name != "case" && parameters.iter().all(|p| p.column_name() != **name);
    let metrics =
        |rows: &Rows| -> Vec<String> { rows.columns.iter().filter(is_metric).cloned().collect() };
    let only = |one: &Rows, other: &Rows| {
        let mut only = metrics(one);
        // A column in units follows from another column.
        only.retain(|name| !has(other, name) && scaled(name).is_none());
        only
    };
    let (keys_a, keys_b) = (keys(parameters, a), keys(parameters, b));
    let mut unmatched: HashMap<&[Cow<str>], Vec<usize>> = HashMap::new();
    for (row, key) in keys_b.iter().enumerate().rev() {
        unmatched.entry(key).or_default().push(row);
    }
    let mut partners: Vec<Option<usize>> = Vec::new();
    for key in &keys_a {
        partners.push(unmatched.get_mut(key.as_slice()).and_then(Vec::pop));
    }
    let common = partners.iter().flatten().count();
    let mut comparison = Comparison {
        common,
        alone: [a.rows.len() - common, b.rows.len() - common],
        columns: [only(a, b), only(b, a)],
        ..Comparison::default()
    };
    // Seconds are others in each run.
    let compared = |name: &String| name != WALL && has(b, name);
    for metric in metrics(a).into_iter().filter(compared) {
        let places = [a, b].map(|rows| rows.columns.iter().position(|c| *c == metric));
        let [Some(left), Some(right)] = places else {
            continue;
        };
        let mut change = Change {
            metric,
            cases: 0,
            largest: 0.0,
            case: String::new(),
            cells: Default::default(),
        };
        for (row, partner) in a.rows.iter().zip(&partners) {
            let Some(partner) = partner else { continue };
            let cells = [&row[left], &b.rows[*partner][right]];
            let difference = difference(cells);
            if difference > tolerance {
                change.cases += 1;
            }
            if difference > change.largest {
                change.largest = difference;
                change.case = row[0].clone();
                change.cells = cells.map(String::clone);
            }
        }
        if change.cases > 0 {
            comparison.changes.push(change);
        }
    }
    let by_size = |x: &Change, y: &Change| y.largest.total_cmp(&x.largest);
    comparison.changes.sort_by(by_size);
    comparison
}

/// The values of the parameters in each row, as text: numbers with 15 digits, so that `1` is `1.0` and 1.9999999999999998 is 2.
fn keys<'a>(parameters: &[Parameter], rows: &'a Rows) -> Vec<Vec<Cow<'a, str>>> {
    let column_of = |name: &str| rows.columns.iter().position(|column| column == name);
    let table = parameters.iter();
    let places: Vec<(&Parameter, Option<usize>)> =
        table.map(|p| (p, column_of(p.column_name()))).collect();
    let key = |row: &'a Vec<String>| {
        let mut key: Vec<Cow<str>> = Vec::new();
        for (parameter, index) in &places {
            key.push(match index {
                Some(index) => digits_15(Cow::Borrowed(&row[*index])),
                None => digits_15(Cow::Owned(default_of(parameter, &key, &places))),
            });
        }
        key
    };
    rows.rows.iter().map(key).collect()
}

/// A number with 15 digits; another text as it is.
fn digits_15(text: Cow<str>) -> Cow<str> {
    match text.parse::<f64>() {
        Ok(x) => Cow::Owned(format!("{x:.14e}")),
        Err(_) => text,
    }
}

/// The default of a parameter as text; empty if it has none or does not apply. A name that decides whether it applies is
/// earlier in the table, so that `key` has it.
fn default_of(
    parameter: &Parameter,
    key: &[Cow<str>],
    table: &[(&Parameter, Option<usize>)],
) -> String {
    let applies = parameter.applies.as_ref().is_none_or(|on| {
        let mut known = key.iter().zip(table);
        known.any(|(value, (other, _))| other.name == on.governor && on.allows(value))
    });
    match &parameter.default {
        parameter::Default::Is(value) if applies => value.to_string(),
        parameter::Default::Is(_)
        | parameter::Default::Required
        | parameter::Default::Follows(_) => String::new(),
    }
}

/// By how much two cells differ, relative to the larger magnitude.
fn difference(cells: [&String; 2]) -> f64 {
    if cells[0] == cells[1] {
        return 0.0;
    }
    let [Ok(a), Ok(b)] = cells.map(|cell| cell.parse::<f64>()) else {
        return f64::INFINITY;
    };
    let size = a.abs().max(b.abs());
    if a == b { 0.0 } else { (a - b).abs() / size }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows of friction with these values of alpha and of two metrics.
    fn table(rows: &[(&str, &str, &str)]) -> Rows {
        let problem = find("friction-oscillator").unwrap();
        let parameters = problem.parameters();
        let names = parameters.iter().map(|p| p.name.to_string());
        let metrics = ["rms_error", "max_error"].map(String::from);
        let columns = ["case".to_owned()].into_iter().chain(names).chain(metrics);
        let row = |(i, (alpha, rms, max)): (usize, &(&str, &str, &str))| {
            let value = |p: &slipgap_problem::problem::numbers::parameter::Parameter| match &*p.name
            {
                "alpha" => (*alpha).to_owned(),
                _ => "1".into(),
            };
            let cells = [i.to_string()]
                .into_iter()
                .chain(parameters.iter().map(value));
            cells
                .chain([(*rms).to_owned(), (*max).to_owned()])
                .collect()
        };
        Rows {
            columns: columns.collect(),
            rows: rows.iter().enumerate().map(row).collect(),
        }
    }

    #[test]
    fn cases_are_matched_by_their_parameters_and_changes_come_largest_first() {
        let a = table(&[("1", "2.0", "3"), ("2", "1", "4"), ("3", "", "5")]);
        let b = table(&[("2", "1", "4.4"), ("1", "2", "6"), ("4", "7", "7")]);
        let problem = find("friction-oscillator").unwrap();
        let found = compare(problem.parameters(), &a, &b, 0.1);
        assert_eq!((found.common, found.alone), (2, [1, 1]));
        let [change] = &found.changes[..] else {
            panic!("{found:?}")
        };
        // 4 to 4.4 is 1/11; 3 to 6 is a half.
        assert_eq!((change.metric.as_str(), change.cases), ("max_error", 1));
        assert_eq!((change.largest, change.case.as_str()), (0.5, "0"));
        assert_eq!(change.cells, ["3", "6"]);
        assert!(!found.same() && compare(problem.parameters(), &a, &a, 0.0).same());
    }

    #[test]
    fn a_value_on_one_side_only_is_the_largest_change() {
        let a = table(&[("1", "", "1"), ("1", "2", "1")]);
        let b = table(&[("1", "1", "1.5"), ("1", "2", "1")]);
        let problem = find("friction-oscillator").unwrap();
        let found = compare(problem.parameters(), &a, &b, 0.0);
        let largest: Vec<(&str, f64)> = found
            .changes
            .iter()
            .map(|c| (c.metric.as_str(), c.largest))
            .collect();
        assert_eq!(largest[0], ("rms_error", f64::INFINITY));
        assert!((largest[1].1 - 1.0 / 3.0).abs() < 1e-15);
    }

    #[test]
    fn a_parameter_without_a_column_has_its_default() {
        let problem = find("friction-oscillator").unwrap();
        let column_of =
            |rows: &Rows, name: &str| rows.columns.iter().position(|c| c == name).unwrap();
        // Three cases that differ in x0 only; the default of x0 is 12.
        let mut with = table(&[("1", "2", "3"), ("1", "4", "5"), ("1", "6", "7")]);
        let x0 = column_of(&with, "x0");
        for (row, value) in with.rows.iter_mut().zip(["9", "12", "13"]) {
            row[x0] = value.into();
        }
        let mut without = table(&[("1", "4", "5")]);
        without.columns.remove(x0);
        without.rows[0].remove(x0);
        for (a, b, only) in [(&with, &without, [2, 0]), (&without, &with, [0, 2])] {
            let found = compare(problem.parameters(), a, b, 0.0);
            assert_eq!((found.common, found.alone), (1, only));
            assert_eq!(found.changes, []);
        }
    }

    #[test]
    fn columns_name_a_problem_only_if_all_its_parameters_are_there() {
        let mut columns = table(&[]).columns;
        let name = |columns: &[String]| problem_of_columns(columns).map(|p| p.name().to_owned());
        assert_eq!(name(&columns).as_deref(), Some("friction-oscillator"));
        columns.retain(|column| column != "alpha");
        assert_eq!(name(&columns), None);
    }
}
