//! results.csv: one row for each case, in order. The columns are `case`, the parameters and the metrics.

use crate::PartResult;
use rayon::prelude::*;
use slipgap_notation::{push_real, push_whole};
use slipgap_problem::problem::table::cases::{Cells, Column, NO_WHOLE, applies};
use slipgap_study::Study;
use std::io::{self, Write};
use std::ops::Range;

/// Rows that one thread writes at a time.
const ROWS: usize = 1024;

/// The table, written part by part.
pub struct ResultTable<'a, W: Write> {
    study: &'a Study,
    /// Rows of the parameters that are columns.
    parameters: Vec<usize>,
    out: W,
}

impl<'a, W: Write> ResultTable<'a, W> {
    /// Writes the header.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn new(study: &'a Study, out: W) -> io::Result<ResultTable<'a, W>> {
        let parameters = study.parameter_columns();
        let table = study.problem.parameters();
        let names = parameters.iter().map(|row| table[*row].column_name());
        let metrics = study.columns.iter().map(|m| &*study.measures[*m].name);
        let mut writer = csv::Writer::from_writer(out);
        writer.write_record(["case"].into_iter().chain(names).chain(metrics))?;
        let out = writer.into_inner().map_err(|e| e.into_error())?;
        Ok(ResultTable {
            study,
            parameters,
            out,
        })
    }

    /// Writes the cases of a part.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn add(&mut self, part: &PartResult) -> io::Result<()> {
        let parameters = self
            .parameters
            .iter()
            .map(|row| Text::of_parameter(&part.cases.columns()[*row]));
        let metrics = self
            .study
            .columns
            .iter()
            .map(|metric| part.metrics.numbers(*metric))
            .map(|numbers| numbers.map_or(Text::Same(Vec::new()), Text::Metrics));
        let columns: Vec<Text> = parameters
            .chain(metrics.map(Ok))
            .collect::<io::Result<_>>()?;
        let starts = (0..part.len()).into_par_iter().step_by(ROWS);
        let rows = |start: usize| rows(part, &columns, start..part.len().min(start + ROWS));
        let written: Vec<Vec<u8>> = starts.map(rows).collect();
        written.iter().try_for_each(|text| self.out.write_all(text))
    }

    /// Flushes the table and returns its writer.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn finish(mut self) -> io::Result<W> {
        self.out.flush()?;
        Ok(self.out)
    }
}

/// The text of a column.
enum Text<'a> {
    /// The same in all rows.
    Same(Vec<u8>),
    Numbers(&'a [f64]),
    /// NaN where one is undefined.
    Metrics(&'a [f64]),
    Whole(&'a [u64]),
    /// The text of each name, and the place of the name of each case.
    Names(Vec<Vec<u8>>, &'a [u32]),
}

impl Text<'_> {
    fn of_parameter(column: &Column) -> io::Result<Text<'_>> {
        Ok(match column {
            Column::Same(value) => Text::Same(match value {
                None => Vec::new(),
                Some(value) => in_csv(&value.cell())?,
            }),
            Column::Each(Cells::Numbers(numbers)) => Text::Numbers(numbers),
            Column::Each(Cells::Whole(numbers)) => Text::Whole(numbers),
            Column::Each(Cells::Names { names, places }) => {
                let names = names.iter().map(|name| in_csv(name));
                Text::Names(names.collect::<io::Result<_>>()?, places)
            }
        })
    }

    /// Nothing is written for what does not apply or is undefined.
    fn push(&self, text: &mut Vec<u8>, row: usize) {
        match self {
            Text::Same(same) => text.extend_from_slice(same),
            Text::Numbers(numbers) => {
                let x = numbers[row];
                if applies(x) {
                    push_real(text, x);
                }
            }
            Text::Metrics(numbers) => {
                let x = numbers[row];
                if x.is_finite() {
                    push_real(text, x);
                }
            }
            Text::Whole(numbers) => {
                let n = numbers[row];
                if n != NO_WHOLE {
                    push_whole(text, n);
                }
            }
            Text::Names(names, places) => {
                let name = names.get(places[row] as usize);
                name.into_iter()
                    .for_each(|name| text.extend_from_slice(name));
            }
        }
    }
}

/// A cell as the writer of csv writes it: in quotes if it needs them.
fn in_csv(cell: &str) -> io::Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    // Behind an empty cell, because a record of one empty cell has quotes.
    writer.write_record(["", cell])?;
    let record = writer.into_inner().map_err(|e| e.into_error())?;
    let cell = record
        .strip_prefix(b",")
        .and_then(|rest| rest.strip_suffix(b"\n"));
    Ok(cell.unwrap_or_default().to_vec())
}

/// Some rows of a part as text.
fn rows(part: &PartResult, columns: &[Text], rows: Range<usize>) -> Vec<u8> {
    let mut text = Vec::new();
    for row in rows {
        push_whole(&mut text, part.number(row));
        for column in columns {
            text.push(b',');
            column.push(&mut text, row);
        }
        text.push(b'\n');
    }
    text
}
