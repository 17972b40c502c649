//! The table of results, which other libraries take by the Arrow PyCapsule interface.

use crate::arrays;
use crate::error::raise;
use arrow_array::cast::AsArray;
use arrow_array::ffi::FFI_ArrowSchema;
use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::types::{Float64Type, Int64Type};
use arrow_array::{Array, RecordBatch, RecordBatchIterator};
use arrow_schema::{DataType, SchemaRef};
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;
use pyo3::types::{PyCapsule, PyList};
use slipgap::error::Error;

/// The table of results: one row for each case, with the columns of results.csv.
///
/// Other libraries take it by the Arrow PyCapsule interface, and do not copy it:
/// `polars.DataFrame(table)`, `pyarrow.table(table)`, `pandas.DataFrame.from_arrow(table)` (pandas 3) and
/// `duckdb.sql("from table")`.
///
/// `case` is a whole number, parameters are numbers, whole numbers or names, metrics are numbers. Units are those of
/// docs/scope.md. A parameter that does not apply and a metric that is undefined are null.
///
/// `len(table)` is the number of cases. `table["rms_error"]` is a column without any other library: an array of shape
/// (cases,) with NaN for null, or for names a list of str and None.
#[pyclass(frozen, module = "slipgap")]
pub struct Table {
    pub schema: SchemaRef,
    pub batches: Vec<RecordBatch>,
}

#[pymethods]
impl Table {
    /// The types of the columns, by the Arrow PyCapsule interface.
    fn __arrow_c_schema__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyCapsule>> {
        let schema = FFI_ArrowSchema::try_from(self.schema.as_ref());
        let schema = schema.map_err(|e| raise(py, Error::Internal(e.to_string())))?;
        PyCapsule::new_with_value(py, schema, c"arrow_schema")
    }

    /// The rows, by the Arrow PyCapsule interface; they are not copied. The types are always those of the table.
    #[pyo3(signature = (requested_schema = None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        // The interface lets a producer leave types as they are.
        let _ = requested_schema;
        let batches = self.batches.clone().into_iter().map(Ok);
        let reader = RecordBatchIterator::new(batches, self.schema.clone());
        let stream = FFI_ArrowArrayStream::new(Box::new(reader));
        PyCapsule::new_with_value(py, stream, c"arrow_array_stream")
    }

    /// Names of the columns.
    #[getter]
    fn columns(&self) -> Vec<String> {
        let fields = self.schema.fields().iter();
        fields.map(|field| field.name().clone()).collect()
    }

    fn __len__(&self) -> usize {
        self.batches.iter().map(RecordBatch::num_rows).sum()
    }

    /// A column: an array of shape (cases,) with NaN for null, or for names a list of str and None.
    fn __getitem__<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        let column = self.schema.index_of(name);
        let column = column.map_err(|_| PyKeyError::new_err(name.to_owned()))?;
        let arrays = self.batches.iter().map(|batch| batch.column(column));
        let field = self.schema.field(column);
        match field.data_type() {
            DataType::Utf8 => {
                let names = arrays.flat_map(|array| array.as_string::<i32>().iter());
                Ok(PyList::new(py, names.collect::<Vec<_>>())?.into_any())
            }
            DataType::Int64 if !arrays.clone().any(|array| array.null_count() > 0) => {
                let values = arrays.flat_map(|array| array.as_primitive::<Int64Type>().values());
                let values: Vec<i64> = values.copied().collect();
                arrays::whole(py, values.into_iter())
            }
            DataType::Int64 => {
                let values = arrays.flat_map(|array| array.as_primitive::<Int64Type>().iter());
                let values: Vec<f64> = values.map(|n| n.map_or(f64::NAN, |n| n as f64)).collect();
                arrays::numbers(py, values.into_iter())
            }
            _ => {
                let values = arrays.flat_map(|array| array.as_primitive::<Float64Type>().iter());
                let values: Vec<f64> = values.map(|x| x.unwrap_or(f64::NAN)).collect();
                arrays::numbers(py, values.into_iter())
            }
        }
    }

    fn __repr__(&self) -> String {
        let columns = self.columns().join(", ");
        format!("<slipgap.Table of {} cases: {columns}>", self.__len__())
    }
}
