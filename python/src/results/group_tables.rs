//! Tables of the program as Arrow columns: the files that a run writes over groups of cases, and its warnings.

use super::arrow_table::Table;
use super::figure::Shown;
use crate::error::raise;
use arrow_array::{ArrayRef, Float64Array, Int64Array, RecordBatch, StringArray};
use arrow_schema::{DataType, Field, Schema};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use slipgap::batch::WarnedCases;
use slipgap::batch::output::ensemble::EnsembleMetrics;
use slipgap::batch::output::reductions::ReducedMetrics;
use slipgap::error::Error;
use std::sync::Arc;

/// Columns of whole numbers: numbers of cases, blocks and samples.
const WHOLE: [&str; 5] = ["block", "case", "cases", "empty", "tests"];

/// The files over groups of cases, as bytes; `None` if the study has no such groups.
#[derive(Debug, Default)]
pub struct Groups {
    quantiles: Option<Vec<u8>>,
    two_samples: Option<Vec<u8>>,
    tests: Option<Vec<u8>>,
    reductions: Option<Vec<u8>>,
}

impl Groups {
    /// The files after all parts.
    pub fn new(
        ensembles: Option<&EnsembleMetrics>,
        reductions: &ReducedMetrics,
    ) -> Result<Groups, Error> {
        let mut groups = Groups {
            reductions: reductions.table()?.map(|table| table.bytes),
            ..Groups::default()
        };
        if let Some(ensembles) = ensembles {
            let mut bytes = Vec::new();
            let written = ensembles.write_quantiles(&mut bytes);
            written.map_err(Error::io("cannot write", "quantiles"))?;
            groups.quantiles = Some(bytes);
            if ensembles.has_pairs() {
                let mut bytes = Vec::new();
                let written = ensembles.write_two_samples(&mut bytes);
                written.map_err(Error::io("cannot write", "two_samples"))?;
                groups.two_samples = Some(bytes);
            }
            if ensembles.has_tests() {
                let mut bytes = Vec::new();
                let written = ensembles.write_tests(&mut bytes);
                written.map_err(Error::io("cannot write", "tests"))?;
                groups.tests = Some(bytes);
            }
        }
        Ok(groups)
    }

    /// The tables by name. Sobol' indices are computed now, because their intervals take time.
    pub fn tables(
        &self,
        py: Python<'_>,
        shown: &Shown,
        warnings: &[WarnedCases],
    ) -> PyResult<Py<PyDict>> {
        let computed = py.detach(|| {
            let study = &shown.source.study;
            let table = match shown.designs.estimates() {
                0 => None,
                _ => slipgap::batch::output::sobol::table(&shown.designs, study, || ())?,
            };
            Ok(table.map(|table| table.bytes))
        });
        let indices = computed.map_err(|error| raise(py, error))?;
        let files = [
            ("quantiles", &self.quantiles),
            ("two_samples", &self.two_samples),
            ("tests", &self.tests),
            ("sobol", &indices),
            ("reductions", &self.reductions),
        ];
        let tables = PyDict::new(py);
        for (name, bytes) in files {
            if let Some(bytes) = bytes {
                let table = of_csv(bytes).map_err(|error| raise(py, error))?;
                tables.set_item(name, Bound::new(py, table)?)?;
            }
        }
        let warnings = of_warnings(warnings).map_err(|error| raise(py, error))?;
        tables.set_item("warnings", Bound::new(py, warnings)?)?;
        Ok(tables.unbind())
    }
}

/// A file with a header as a table. A column of which every cell is a number or empty has numbers, every other one has text.
fn of_csv(bytes: &[u8]) -> Result<Table, Error> {
    let fault = |error: csv::Error| Error::Internal(error.to_string());
    let mut reader = csv::Reader::from_reader(bytes);
    let names: Vec<String> = { reader.headers().map_err(fault)?.iter() }
        .map(String::from)
        .collect();
    let rows: Vec<csv::StringRecord> = reader.records().collect::<Result<_, _>>().map_err(fault)?;
    let columns = names.iter().enumerate().map(|(column, name)| {
        let cells = || rows.iter().map(|row| row.get(column).unwrap_or_default());
        let is_number = |cell: &str| cell.is_empty() || cell.parse::<f64>().is_ok();
        let array: ArrayRef = if WHOLE.contains(&name.as_str()) {
            Arc::new(
                cells()
                    .map(|cell| cell.parse().ok())
                    .collect::<Int64Array>(),
            )
        } else if name != "metric" && cells().all(is_number) {
            Arc::new(
                cells()
                    .map(|cell| cell.parse().ok())
                    .collect::<Float64Array>(),
            )
        } else {
            let filled = cells().map(|cell| Some(cell).filter(|cell| !cell.is_empty()));
            Arc::new(filled.collect::<StringArray>())
        };
        (name.clone(), array)
    });
    table(columns.collect())
}

/// The kinds of warnings: a row for each, without rows if there is none.
fn of_warnings(warnings: &[WarnedCases]) -> Result<Table, Error> {
    let whole = |of: fn(&WarnedCases) -> u64| -> ArrayRef {
        let numbers = warnings
            .iter()
            .map(|warning| i64::try_from(of(warning)).ok());
        Arc::new(numbers.collect::<Int64Array>())
    };
    let text = |of: fn(&WarnedCases) -> String| -> ArrayRef {
        Arc::new(
            warnings
                .iter()
                .map(|warning| Some(of(warning)))
                .collect::<StringArray>(),
        )
    };
    table(vec![
        (
            "kind".into(),
            text(|warning| warning.kind.name().to_owned()),
        ),
        ("cases".into(), whole(|warning| warning.cases)),
        ("of".into(), whole(|warning| warning.of)),
        ("case".into(), whole(|warning| warning.case)),
        ("message".into(), text(|warning| warning.to_string())),
    ])
}

fn table(columns: Vec<(String, ArrayRef)>) -> Result<Table, Error> {
    let field = |(name, array): &(String, ArrayRef)| {
        let kind: DataType = array.data_type().clone();
        Field::new(name, kind, true)
    };
    let fields: Vec<Field> = columns.iter().map(field).collect();
    let schema = Arc::new(Schema::new(fields));
    let arrays = columns.into_iter().map(|(_, array)| array).collect();
    let batch = RecordBatch::try_new(schema.clone(), arrays)
        .map_err(|error| Error::Internal(error.to_string()))?;
    Ok(Table {
        schema,
        batches: vec![batch],
    })
}
