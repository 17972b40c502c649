//! `slipgap compare`: the differences of two folders of results.

use super::NOT_MET;
use super::arguments::Expected;
use super::terminal::{note, print, table};
use crate::compare::{Comparison, Finding, compare_folders};
use crate::error::Error;
use crate::problem::numbers::parameter::shortest;
use clap::Args;
use std::path::{Path, PathBuf};

const HEADER: [&str; 7] = [
    "study", "metric", "cases", "largest", "at case", "first", "second",
];

/// The arguments of `slipgap compare`.
#[derive(Args)]
pub struct CompareArgs {
    /// Results of a study, or a folder of several
    first: PathBuf,
    /// Results to compare with
    second: PathBuf,
    /// Largest difference to ignore, relative to the larger of the two values
    #[arg(long, value_name = "RELATIVE", default_value_t = 0.0, value_parser = tolerance)]
    tolerance: f64,
}

impl CompareArgs {
    /// Compares the results; returns the exit code.
    pub fn execute(self) -> Result<u8, Error> {
        compare(&self.first, &self.second, self.tolerance)
    }
}

fn tolerance(text: &str) -> Result<f64, Expected> {
    let parsed = text.parse::<f64>().ok();
    let number = parsed.filter(|x| *x >= 0.0 && x.is_finite());
    number.ok_or(Expected("a number >= 0".into()))
}

/// Compares the studies in the folders `a` and `b`, or these studies themselves; returns the exit code.
fn compare(a: &Path, b: &Path, tolerance: f64) -> Result<u8, Error> {
    let sides = [a, b];
    let findings = compare_folders(a, b, tolerance)?;
    let mut rows = vec![HEADER.map(String::from).to_vec()];
    for (name, finding) in &findings {
        let name = display_name(name);
        match finding {
            Finding::OnlyIn(side) => note(&format!("{name}: only in {}", sides[*side].display())),
            Finding::OtherProblem => {
                note(&format!(
                    "{name}: the two results are of different problems"
                ));
            }
            Finding::Compared(comparison) => {
                note_sides(name, comparison, sides);
                rows.extend(changes(name, comparison));
            }
        }
    }
    if rows.len() > 1 {
        print(&table(&rows))?;
    }
    let equal = findings.iter().filter(|(_, finding)| finding.same());
    let same = equal.count();
    let differing = findings.len() - same;
    note(&format!("{same} studies equal, {differing} different"));
    Ok(if differing > 0 { NOT_MET } else { 0 })
}

/// Notes the cases and metrics that only one side has, and files that differ.
fn note_sides(name: &str, comparison: &Comparison, sides: [&Path; 2]) {
    for origin in &comparison.origins {
        note(&format!("{name}: {origin}"));
    }
    let alone = comparison.alone.iter().zip(&comparison.columns);
    for ((cases, metrics), side) in alone.zip(sides) {
        let side = side.display();
        if *cases > 0 {
            note(&format!("{name}: {cases} cases only in {side}"));
        }
        if !metrics.is_empty() {
            note(&format!("{name}: {} only in {side}", metrics.join(", ")));
        }
    }
}

/// The rows of the table about the metrics that differ.
fn changes(name: &str, comparison: &Comparison) -> Vec<Vec<String>> {
    let changes = comparison.changes.iter();
    let row = changes.map(|change| {
        let [first, second] = change.cells.clone();
        vec![
            name.to_owned(),
            change.metric.clone(),
            format!("{} of {}", change.cases, comparison.common),
            shortest((change.largest * 1e6).round() / 1e6),
            change.case.clone(),
            first,
            second,
        ]
    });
    row.collect()
}

/// The name of a study; a point for the folder of the command itself.
fn display_name(name: &str) -> &str {
    if name.is_empty() { "." } else { name }
}
