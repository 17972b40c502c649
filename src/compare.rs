//! Two tables of results of one study, held against each other: case by case, metric by metric.

use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

use crate::problem::{PROBLEMS, Problem};
use crate::study::units::scaled;

/// A table of results as text: results.csv, or the same from a store.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Rows {
    /// Names of the columns.
    pub columns: Vec<String>,
    /// Cells, in the order of the columns; empty where there is no value.
    pub rows: Vec<Vec<String>>,
}

impl Rows {
    /// Adds rows of the same columns.
    pub fn extend(&mut self, more: Rows) {
        self.columns = more.columns;
        self.rows.extend(more.rows);
    }
}

/// What became of one metric.
#[derive(Debug, Clone, PartialEq)]
pub struct Change {
    /// The column.
    pub metric: String,
    /// Number of cases that differ by more than the tolerance, or have a value on one side alone.
    pub cases: usize,
    /// The largest difference: relative to the larger of both magnitudes; infinite where one side has no value.
    pub largest: f64,
    /// Number of the case where it is, on the first side.
    pub case: String,
    /// The two cells.
    pub cells: [String; 2],
}

/// What two tables differ in.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Comparison {
    /// Metrics that changed beyond the tolerance, the largest difference first.
    pub changes: Vec<Change>,
    /// Cases that both have.
    pub common: usize,
    /// Cases of the first side alone, and of the second.
    pub alone: [usize; 2],
    /// Metrics of the first side alone, and of the second; those in the units of a study are not counted.
    pub columns: [Vec<String>; 2],
}

impl Comparison {
    /// Whether nothing differs beyond the tolerance.
    pub fn same(&self) -> bool {
        self.changes.is_empty() && self.alone == [0, 0] && self.columns.iter().all(Vec::is_empty)
    }
}

/// Compares two tables; cases are the same where all their parameters are, whatever their numbers. `None` where the
/// columns are not those of a problem, or of two problems.
pub fn compare(a: &Rows, b: &Rows, tolerance: f64) -> Option<Comparison> {
    let has = |rows: &Rows, name: &str| rows.columns.iter().any(|column| column == name);
    let of = |rows: &Rows| {
        let all =
            |problem: &&Arc<dyn Problem>| problem.parameters().iter().all(|p| has(rows, &p.name));
        PROBLEMS.iter().find(all).cloned()
    };
    let problem = of(a)?;
    if of(b)?.name() != problem.name() {
        return None;
    }
    let is_metric =
        |name: &&String| **name != "case" && problem.parameters().iter().all(|p| p.name != **name);
    let metrics =
        |rows: &Rows| -> Vec<String> { rows.columns.iter().filter(is_metric).cloned().collect() };
    let only = |one: &Rows, other: &Rows| {
        let mut only = metrics(one);
        // What is worked out from other columns is no difference of its own.
        only.retain(|name| !has(other, name) && scaled(name).is_none());
        only
    };
    let names: Vec<&str> = problem.parameters().iter().map(|p| &*p.name).collect();
    let (keys_a, keys_b) = (keys(a, &names), keys(b, &names));
    let mut waiting: HashMap<&[&str], Vec<usize>> = HashMap::new();
    for (row, key) in keys_b.iter().enumerate().rev() {
        waiting.entry(key).or_default().push(row);
    }
    let mut partners: Vec<Option<usize>> = Vec::new();
    for key in &keys_a {
        partners.push(waiting.get_mut(key.as_slice()).and_then(Vec::pop));
    }
    let common = partners.iter().flatten().count();
    let mut comparison = Comparison {
        common,
        alone: [a.rows.len() - common, b.rows.len() - common],
        columns: [only(a, b), only(b, a)],
        changes: Vec::new(),
    };
    for metric in metrics(a).into_iter().filter(|name| has(b, name)) {
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
    Some(comparison)
}

/// The cells of each row's parameters.
fn keys<'a>(rows: &'a Rows, names: &[&str]) -> Vec<Vec<&'a str>> {
    let places: BTreeMap<&str, usize> = rows
        .columns
        .iter()
        .enumerate()
        .map(|(place, name)| (name.as_str(), place))
        .collect();
    let key = |row: &'a Vec<String>| {
        names
            .iter()
            .map(|name| row[places[name]].as_str())
            .collect()
    };
    rows.rows.iter().map(key).collect()
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
    use crate::problem::find;

    /// Rows of friction with these values of alpha and of two metrics.
    fn table(rows: &[(&str, &str, &str)]) -> Rows {
        let problem = find("friction-oscillator").unwrap();
        let parameters = problem.parameters();
        let names = parameters.iter().map(|p| p.name.to_string());
        let metrics = ["rms_error", "max_error"].map(String::from);
        let columns = ["case".to_owned()].into_iter().chain(names).chain(metrics);
        let row = |(i, (alpha, rms, max)): (usize, &(&str, &str, &str))| {
            let value = |p: &crate::problem::parameter::Parameter| match &*p.name {
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
    fn cases_are_found_by_their_parameters_and_changes_come_largest_first() {
        let a = table(&[("1", "2.0", "3"), ("2", "1", "4"), ("3", "", "5")]);
        let b = table(&[("2", "1", "4.4"), ("1", "2", "6"), ("4", "7", "7")]);
        let found = compare(&a, &b, 0.1).unwrap();
        assert_eq!((found.common, found.alone), (2, [1, 1]));
        let [change] = &found.changes[..] else {
            panic!("{found:?}")
        };
        // 4 to 4.4 is 1/11; 3 to 6 is a half.
        assert_eq!((change.metric.as_str(), change.cases), ("max_error", 1));
        assert_eq!((change.largest, change.case.as_str()), (0.5, "0"));
        assert_eq!(change.cells, ["3", "6"]);
        assert!(!found.same() && compare(&a, &a, 0.0).unwrap().same());
    }

    #[test]
    fn a_value_on_one_side_alone_is_the_largest_change() {
        let a = table(&[("1", "", "1"), ("1", "2", "1")]);
        let b = table(&[("1", "1", "1.5"), ("1", "2", "1")]);
        let found = compare(&a, &b, 0.0).unwrap();
        let told: Vec<(&str, f64)> = found
            .changes
            .iter()
            .map(|c| (c.metric.as_str(), c.largest))
            .collect();
        assert_eq!(told[0], ("rms_error", f64::INFINITY));
        assert!((told[1].1 - 1.0 / 3.0).abs() < 1e-15);
    }
}
