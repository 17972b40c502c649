//! CSV tables of cases without a solution, failures.csv, and of histories.

use slipgap_motion::solve::Unsolvable;
use slipgap_problem::problem::numbers::parameter::real;
use slipgap_problem::problem::numbers::unit::Dimension;
use slipgap_problem::problem::{Case, HistoryColumn, MeasuredChannel, Solution};
use slipgap_study::{Study, printable};
use std::io::{self, Write};

/// failures.csv: the cases that could not be solved, with their parameters and the reason.
pub struct FailureTable<W: Write> {
    /// Rows of the parameters that are columns.
    parameters: Vec<usize>,
    writer: csv::Writer<W>,
}

impl<W: Write> FailureTable<W> {
    /// Writes the header.
    pub fn new(study: &Study, out: W) -> io::Result<FailureTable<W>> {
        let mut writer = csv::Writer::from_writer(out);
        let parameters = study.parameter_columns();
        let table = study.problem.parameters();
        let names = parameters.iter().map(|row| table[*row].column_name());
        let header = ["case"].into_iter().chain(names).chain(["reason"]);
        writer.write_record(header)?;
        Ok(FailureTable { parameters, writer })
    }

    /// Writes one case.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn row(&mut self, number: u64, case: &Case, why: &Unsolvable) -> io::Result<()> {
        let row = parameters(number, &self.parameters, case).chain([plain(&why.to_string())]);
        Ok(self.writer.write_record(row)?)
    }

    /// Flushes the table and returns its writer.
    pub fn finish(self) -> io::Result<W> {
        self.writer.into_inner().map_err(|e| e.into_error())
    }
}

/// A text as a cell, perhaps from the store of somebody else: no codes that a terminal obeys, and no formula of a table calculator.
fn plain(text: &str) -> String {
    let text = printable(text);
    match text.starts_with(['=', '+', '-', '@', '\t', '\r']) {
        true => format!("'{text}"),
        false => text,
    }
}

/// The number of a case and the parameters in these rows, as cells.
fn parameters(number: u64, rows: &[usize], case: &Case) -> impl Iterator<Item = String> {
    let value = |row: &usize| case.values[*row].map(|v| v.cell()).unwrap_or_default();
    std::iter::once(number.to_string()).chain(rows.iter().map(value))
}

/// Writes the history of a case with one row for each step. The columns are the time, the computed channels, the exact
/// ones, and the measured ones, straight between the measured points and empty outside of them. If the study has units, each column is followed by the same quantity in these units.
pub fn write_history(
    study: &Study,
    case: &Case,
    solution: &Solution,
    out: impl Write,
) -> io::Result<()> {
    let schema = study.problem.schema();
    let channels = study.problem.history_columns(case);
    let (computed, exact) = (&solution.computed, &solution.exact);
    let mut columns = vec![(
        schema.time.column.to_string(),
        Dimension::Time,
        &computed.time[..],
    )];
    columns.extend(channels.iter().map(|HistoryColumn { index, column }| {
        let name = column.name.to_string();
        (name, column.dimension, computed.channel(*index))
    }));
    let with_exact = channels.iter().filter(|channel| channel.column.exact);
    columns.extend(with_exact.map(|HistoryColumn { index, column }| {
        let name = format!("{}_exact", column.name);
        (name, column.dimension, exact.channel(*index))
    }));
    let channels = study.measured(case);
    let measured: Vec<(&MeasuredChannel, Vec<f64>)> = channels
        .iter()
        .map(|channel| (channel, channel.at(&computed.time)))
        .collect();
    columns.extend(measured.iter().map(|(channel, values)| {
        let dimension = schema.channels[channel.column].dimension;
        (channel.history_name(), dimension, &values[..])
    }));
    let mut writer = csv::Writer::from_writer(out);
    let units = study.units.as_ref();
    let header = columns.iter().flat_map(|(name, dimension, _)| {
        let in_units = units.map(|units| units.column(name, *dimension));
        [Some(name.clone()), in_units].into_iter().flatten()
    });
    writer.write_record(header)?;
    let size = |dimension| {
        units.and_then(|_| {
            study
                .problem
                .as_textbook()
                .and_then(|textbook| textbook.size(case, dimension))
        })
    };
    let sizes: Vec<Option<f64>> = columns.iter().map(|column| size(column.1)).collect();
    for i in 0..computed.len() {
        let cells = columns
            .iter()
            .zip(&sizes)
            .flat_map(|((_, _, values), size)| {
                let in_units = size.map(|size| cell(Some(values[i] * size)));
                [Some(cell(Some(values[i]))), in_units]
                    .into_iter()
                    .flatten()
            });
        writer.write_record(cells)?;
    }
    writer.flush()
}

/// A number; empty if it is undefined.
pub(super) fn cell(value: Option<f64>) -> String {
    value
        .filter(|x| x.is_finite())
        .map(real)
        .unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reason_from_a_foreign_store_is_no_command_and_no_formula() {
        for (text, cell) in [
            ("the step is singular", "the step is singular"),
            ("=1+1", "'=1+1"),
            ("@x", "'@x"),
            ("-2+3", "'-2+3"),
            (
                "\u{1b}[2J a \u{202e}b\u{9b}",
                "\\u{1b}[2J a \\u{202e}b\\u{9b}",
            ),
        ] {
            assert_eq!(plain(text), cell);
        }
    }
}
