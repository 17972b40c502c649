//! results.csv: one row for each case, in order. The columns are `case`, the parameters and the metrics.

use crate::batch::PartResult;
use crate::problem::cases::Column;
use crate::problem::digits::{push_shortest, push_whole};
use crate::problem::parameter::Value;
use crate::solve::MetricTable;
use crate::study::Study;
use rayon::prelude::*;
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
        let parameters = self.parameters.iter();
        let parameters = parameters.map(|row| Cells::of_parameter(&part.cases.columns()[*row]));
        let metrics = self.study.columns.iter();
        let metrics = metrics.map(|metric| Cells::Metric(&part.metrics, *metric));
        let columns: Vec<Cells> = parameters.chain(metrics).collect();
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

/// The cells of a column.
enum Cells<'a> {
    /// The same text in all rows.
    Same(Vec<u8>),
    Values(&'a [Option<Value>]),
    Metric(&'a MetricTable, usize),
}

impl Cells<'_> {
    fn of_parameter(column: &Column) -> Cells<'_> {
        match column {
            Column::Same(value) => {
                let mut text = Vec::new();
                push_value(&mut text, *value);
                Cells::Same(text)
            }
            Column::Each(values) => Cells::Values(values),
        }
    }

    fn push(&self, text: &mut Vec<u8>, row: usize) {
        match self {
            Cells::Same(same) => text.extend_from_slice(same),
            Cells::Values(values) => push_value(text, values[row]),
            Cells::Metric(metrics, metric) => {
                let value = metrics.value(row, *metric).filter(|x| x.is_finite());
                value.into_iter().for_each(|x| push_shortest(text, x));
            }
        }
    }
}

/// Some rows of a part as text.
fn rows(part: &PartResult, columns: &[Cells], rows: Range<usize>) -> Vec<u8> {
    let mut text = Vec::new();
    for row in rows {
        push_whole(&mut text, part.number(row) as i64);
        for column in columns {
            text.push(b',');
            column.push(&mut text, row);
        }
        text.push(b'\n');
    }
    text
}

/// Appends a value; nothing for a parameter that does not apply.
fn push_value(text: &mut Vec<u8>, value: Option<Value>) {
    match value {
        None => {}
        Some(Value::Number(x)) => push_shortest(text, x),
        Some(Value::Whole(n)) => text.extend_from_slice(n.to_string().as_bytes()),
        Some(Value::Name(name)) => push_name(text, name),
    }
}

/// Appends a name, in quotes if it needs them.
fn push_name(text: &mut Vec<u8>, name: &str) {
    if name.contains([',', '"', '\n', '\r']) {
        text.push(b'"');
        text.extend_from_slice(name.replace('"', "\"\"").as_bytes());
        text.push(b'"');
    } else {
        text.extend_from_slice(name.as_bytes());
    }
}
