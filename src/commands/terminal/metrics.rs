//! The metrics of a study of few cases, shown after its run.

use super::message::width;
use super::{GAP, table};
use crate::batch::PartResult;
use crate::problem::numbers::parameter::{Value, shortest};
use crate::run::Source;

/// Most cases that are shown.
const MOST: u64 = 20;

/// Most cases that have a column each; more have a row each.
const COLUMNS: usize = 6;

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

    /// The table; empty without cases. Columns that a line of the terminal has no room for are below the others.
    pub fn text(&self) -> String {
        let cases = self.rows.first().map_or(0, Vec::len).saturating_sub(1);
        let columns = match cases {
            0 => return String::new(),
            1..=COLUMNS => transposed(&self.rows),
            _ => self.rows.clone(),
        };
        let blocks = blocks(columns, width().unwrap_or(usize::MAX));
        let tables = blocks.iter().map(|block| table(&transposed(block)));
        tables.collect::<Vec<_>>().join("\n")
    }
}

/// The columns in blocks that fit into lines of this width; each block has the first column.
fn blocks(columns: Vec<Vec<String>>, width: usize) -> Vec<Vec<Vec<String>>> {
    let wide = |column: &[String]| column.iter().map(|cell| cell.chars().count()).max();
    let (mut blocks, mut used) = (Vec::<Vec<Vec<String>>>::new(), 0);
    let mut columns = columns.into_iter();
    let first = columns.next().unwrap_or_default();
    let of_first = wide(&first).unwrap_or_default();
    for column in columns {
        let wide = GAP + wide(&column).unwrap_or_default();
        match blocks.last_mut() {
            Some(block) if used + wide <= width => block.push(column),
            Some(_) | None => {
                blocks.push(vec![first.clone(), column]);
                used = of_first;
            }
        }
        used += wide;
    }
    blocks
}

/// Rows as columns.
fn transposed(rows: &[Vec<String>]) -> Vec<Vec<String>> {
    let cells = rows.first().map_or(0, Vec::len);
    let column = |i: usize| rows.iter().filter_map(|row| row.get(i).cloned()).collect();
    (0..cells).map(column).collect()
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wide_tables_continue_below_with_the_first_column() {
        let column = |cells: [&str; 2]| cells.map(str::to_owned).to_vec();
        let columns = vec![
            column(["case", "0"]),
            column(["gap", "0.01"]),
            column(["peak", "2"]),
        ];
        let shown = |width| -> Vec<String> {
            let blocks = blocks(columns.clone(), width).into_iter();
            blocks.map(|block| table(&transposed(&block))).collect()
        };
        assert_eq!(shown(16), ["case  gap   peak\n0     0.01  2\n"]);
        assert_eq!(
            shown(15),
            ["case  gap\n0     0.01\n", "case  peak\n0     2\n"]
        );
    }
}
