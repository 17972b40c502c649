//! The cases of a study as a table, without results.

use super::arrow_table::Table;
use super::result_columns::Columns;
use crate::error::{raise, usage};
use crate::given;
use arrow_array::Int64Array;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Most raw combinations of a table.
const MOST: u64 = 10_000_000;

/// The number of cases of a study.
#[pyfunction]
pub fn count(py: Python<'_>, study: &Bound<'_, PyAny>) -> PyResult<u64> {
    Ok(given::source(py, study, None)?.study.len())
}

/// The cases of a study with their parameters.
#[pyfunction]
pub fn expand(py: Python<'_>, study: &Bound<'_, PyAny>) -> PyResult<Table> {
    let study = given::source(py, study, None)?.study;
    let raw = study.raw_len();
    if raw > MOST {
        let message = format!("expand: the study has {raw} combinations; allowed: at most {MOST}");
        return Err(usage(py, message));
    }
    let batch = py.detach(|| {
        let (first, cases) = study.columns(0, raw);
        let numbers = (0..cases.len()).map(|row| (first + cases.offset(row)) as i64);
        let mut columns = Columns::new(&study, &[]);
        let arrays = columns.of_cases(&study, &cases, Int64Array::from_iter_values(numbers));
        Ok((columns.schema(), columns.batch(arrays)?))
    });
    let (schema, batch) = batch.map_err(|error| raise(py, error))?;
    let batches = vec![batch];
    Ok(Table { schema, batches })
}

/// The titles of axes of a study in the markup of figures, by the names of its columns, of the quantities that its figures draw, and
/// of the time.
#[pyfunction]
pub fn titles<'py>(py: Python<'py>, study: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyDict>> {
    let study = given::source(py, study, None)?.study;
    let (schema, titles) = (study.problem.schema(), PyDict::new(py));
    titles.set_item(&*schema.time.column, &*schema.time.title)?;
    for quantity in &*schema.quantities {
        titles.set_item(&*quantity.name, &*quantity.title)?;
    }
    for parameter in study.problem.parameters() {
        titles.set_item(parameter.column_name(), parameter.title())?;
    }
    for row in &study.columns {
        titles.set_item(&study.measures[*row].name, study.title(*row))?;
    }
    Ok(titles)
}
