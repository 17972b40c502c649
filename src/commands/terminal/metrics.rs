//! The metrics of a study of few cases, shown after its run.

use super::table;
use crate::batch::PartResult;
use crate::problem::numbers::parameter::{Value, shortest};
use crate::run::Source;

/// Most cases that are shown, each in a column.
const MOST: u64 = 6;

/// Significant digits after the first one.
const DIGITS: usize = 5;

/// Rows of a table: the axes of the study, then its metrics; a column for each case.
#[derive(Debug, Default)]
pub struct Metrics {
    rows: Vec<Vec<String>>,
    /// Rows of the parameters with several values.
    axes: Vec<usize>,
    /// Rows of the metrics.
    columns: Vec<usize>,
}

impl Metrics {
    /// Of the cases of a study; nothing for many of them.
    pub fn of(source: &Source) -> Metrics {
        let study = &source.study;
        if study.len() > MOST {
            return Metrics::default();
        }
        let axes = varying(source);
        let table = study.problem.parameters();
        let of_axes = axes.iter().map(|row| table[*row].name.to_string());
        let of_columns = study.columns.iter();
        let metrics = of_columns.map(|column| study.measures[*column].name.clone());
        let first = ["case".to_owned()].into_iter();
        Metrics {
            rows: first
                .chain(of_axes)
                .chain(metrics)
                .map(|name| vec![name])
                .collect(),
            axes,
            columns: study.columns.clone(),
        }
    }

    /// Adds the cases of a part.
    pub fn add(&mut self, part: &PartResult) {
        if self.rows.is_empty() {
            return;
        }
        let mut shown = part.cases.shown();
        for row in 0..part.len() {
            let case = shown.at(row);
            let shown_axes = self.axes.iter();
            let axes = shown_axes.map(|axis| case.values[*axis].map_or(String::new(), cell));
            let metrics = self.columns.iter().map(|column| {
                let value = part.metrics.value(row, *column);
                value.map_or("undefined".to_owned(), rounded)
            });
            let number = part.number(row).to_string();
            let cells = [number].into_iter().chain(axes).chain(metrics);
            for (line, cell) in self.rows.iter_mut().zip(cells) {
                line.push(cell);
            }
        }
    }

    /// The table; empty without cases.
    pub fn text(&self) -> String {
        match self.rows.first() {
            Some(cases) if cases.len() > 1 => table(&self.rows),
            Some(_) | None => String::new(),
        }
    }
}

/// Rows of the parameters with several values.
fn varying(source: &Source) -> Vec<usize> {
    let study = &source.study;
    let axes = || study.blocks.iter().flat_map(|block| block.axes());
    let several = |row: &usize| {
        let mut axes_of_row = axes().filter(|axis| axis.parameter == *row);
        let values = axes_of_row.next().map(|axis| axis.values.len() > 1);
        values == Some(true) || axes_of_row.next().is_some()
    };
    (0..study.problem.parameters().len())
        .filter(several)
        .collect()
}

fn cell(value: Value) -> String {
    match value {
        Value::Number(x) => rounded(x),
        Value::Whole(_) | Value::Name(_) => value.to_string(),
    }
}

fn rounded(x: f64) -> String {
    let text = format!("{x:.DIGITS$e}");
    text.parse().map_or(text, shortest)
}
