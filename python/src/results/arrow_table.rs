//! The table of results, which other libraries take by the Arrow PyCapsule interface.

use super::result_columns::{UNITS, with_unit};
use crate::arrays;
use crate::error::{raise, usage};
use arrow_array::cast::AsArray;
use arrow_array::ffi::FFI_ArrowSchema;
use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::types::{Float64Type, Int64Type};
use arrow_array::{
    Array, ArrayRef, Float64Array, Int64Array, RecordBatch, RecordBatchIterator, StringArray,
};
use arrow_schema::{DataType, Field, Schema, SchemaRef};
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;
use pyo3::types::{PyCapsule, PyDict, PyList};
use slipgap::error::Error;
use std::collections::HashMap;
use std::sync::Arc;

/// Arrow columns, which `slipgap.Table` shows.
#[pyclass(frozen, module = "slipgap")]
pub struct Table {
    pub schema: SchemaRef,
    pub batches: Vec<RecordBatch>,
}

#[pymethods]
impl Table {
    /// A table of arrays of numbers, with NaN for null, and lists of names, with their units.
    #[new]
    fn new(columns: &Bound<'_, PyDict>, units: HashMap<String, String>) -> PyResult<Table> {
        let (mut fields, mut arrays) = (Vec::new(), Vec::new());
        for (name, column) in columns {
            let (name, array): (String, _) = (name.extract()?, array(&column)?);
            let unit = units.get(&name).cloned();
            fields.push(with_unit(
                Field::new(name, array.data_type().clone(), true),
                unit,
            ));
            arrays.push(array);
        }
        let schema = Arc::new(Schema::new(fields));
        let batch = RecordBatch::try_new(schema.clone(), arrays)
            .map_err(|why| usage(columns.py(), format!("columns: {why}")))?;
        let batches = vec![batch];
        Ok(Table { schema, batches })
    }

    /// Units by column, of those whose unit is known.
    #[getter]
    fn units(&self) -> HashMap<String, String> {
        let units = self.schema.fields().iter().filter_map(|field| {
            let unit = field.metadata().get(UNITS)?;
            Some((field.name().clone(), unit.to_string()))
        });
        units.collect()
    }

    /// The types of the columns, by the Arrow PyCapsule interface.
    fn __arrow_c_schema__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyCapsule>> {
        let schema = FFI_ArrowSchema::try_from(self.schema.as_ref())
            .map_err(|e| raise(py, Error::Internal(e.to_string())))?;
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
        let index = self.schema.index_of(name);
        let column = index.map_err(|_| PyKeyError::new_err(name.to_owned()))?;
        let arrays = self.batches.iter().map(|batch| batch.column(column));
        let field = self.schema.field(column);
        let kind = field.data_type();
        if *kind == DataType::Utf8 {
            let names = arrays.flat_map(|array| array.as_string::<i32>().iter());
            return Ok(PyList::new(py, names.collect::<Vec<_>>())?.into_any());
        }
        if *kind != DataType::Int64 {
            let cells = arrays.flat_map(|array| array.as_primitive::<Float64Type>().iter());
            let values: Vec<f64> = cells.map(|x| x.unwrap_or(f64::NAN)).collect();
            return arrays::numbers(py, values.into_iter());
        }
        if arrays.clone().any(|array| array.null_count() > 0) {
            let cells = arrays.flat_map(|array| array.as_primitive::<Int64Type>().iter());
            let values: Vec<f64> = cells.map(|n| n.map_or(f64::NAN, |n| n as f64)).collect();
            return arrays::numbers(py, values.into_iter());
        }
        let cells = arrays.flat_map(|array| array.as_primitive::<Int64Type>().values());
        let values: Vec<i64> = cells.copied().collect();
        arrays::whole(py, values.into_iter())
    }
}

/// A column of an array of numbers or of a list of names.
fn array(column: &Bound<'_, PyAny>) -> PyResult<ArrayRef> {
    if let Ok(names) = column.extract::<Vec<Option<String>>>() {
        return Ok(Arc::new(StringArray::from(names)));
    }
    let kind: String = column.getattr("dtype")?.getattr("kind")?.extract()?;
    let bytes = |kind: &str| -> PyResult<Vec<u8>> {
        let column = column.call_method1("astype", (kind,))?;
        column.call_method0("tobytes")?.extract()
    };
    match kind.as_str() {
        "i" => {
            let values = bytes("i8")?;
            let words = values
                .chunks_exact(8)
                .filter_map(|word| word.try_into().ok());
            Ok(Arc::new(
                words.map(i64::from_ne_bytes).collect::<Int64Array>(),
            ))
        }
        _ => {
            let numbers = arrays::of_bytes(&bytes("f8")?);
            let known = numbers.into_iter().map(|x| Some(x).filter(|x| !x.is_nan()));
            Ok(Arc::new(known.collect::<Float64Array>()))
        }
    }
}
