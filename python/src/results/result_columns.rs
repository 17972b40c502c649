//! Results as Arrow columns: those of results.csv, with their units.

use crate::units;
use arrow_array::builder::StringBuilder;
use arrow_array::{ArrayRef, Float64Array, Int64Array, RecordBatch, new_null_array};
use arrow_schema::{DataType, Field, Schema, SchemaRef};
use slipgap::batch::PartResult;
use slipgap::error::Error;
use slipgap::problem::numbers::parameter::{Kind, Value};
use slipgap::problem::table::cases::{Cases, Column};
use slipgap::study::Study;
use std::collections::HashMap;
use std::iter::repeat_n;
use std::sync::Arc;

/// Key of the unit in the metadata of a column.
pub const UNITS: &str = "units";

/// The types of the columns: `case`, the parameters and these metrics.
pub fn schema(study: &Study, metrics: &[usize]) -> SchemaRef {
    let (problem, table) = (&*study.problem, study.problem.parameters());
    let mut fields = vec![Field::new("case", DataType::Int64, false)];
    fields.extend(study.parameter_columns().into_iter().map(|row| {
        let parameter = &table[row];
        let field = Field::new(parameter.column_name(), data_type(parameter.kind), true);
        with_unit(field, units::of_parameter(problem, parameter))
    }));
    fields.extend(metrics.iter().map(|&metric| {
        let measure = &study.measures[metric];
        let field = Field::new(measure.name.as_str(), DataType::Float64, true);
        with_unit(field, units::of_measure(problem, measure))
    }));
    Arc::new(Schema::new(fields))
}

/// A column with its unit in the metadata, if it is known.
pub fn with_unit(field: Field, unit: Option<String>) -> Field {
    let metadata = unit.map(|unit| (UNITS.to_owned(), unit));
    field.with_metadata(metadata.into_iter().collect::<HashMap<_, _>>())
}

fn data_type(kind: Kind) -> DataType {
    match kind {
        Kind::Number(_) => DataType::Float64,
        Kind::Whole { .. } => DataType::Int64,
        Kind::Choice(_) => DataType::Utf8,
    }
}

/// The columns of a part. A part has the arrays of the part before for parameters that have the same one value in both.
pub struct Columns {
    schema: SchemaRef,
    parameters: Vec<usize>,
    /// By parameter column: the value, the number of cases, and the array.
    constant: Vec<Option<(Option<Value>, usize, ArrayRef)>>,
}

impl Columns {
    /// The columns of a study with these metrics.
    pub fn new(study: &Study, metrics: &[usize]) -> Columns {
        let parameters = study.parameter_columns();
        Columns {
            schema: schema(study, metrics),
            constant: vec![None; parameters.len()],
            parameters,
        }
    }

    /// The columns of a part.
    pub fn of(&mut self, study: &Study, part: &PartResult) -> Result<RecordBatch, Error> {
        let first = part.first as i64;
        let numbers = Int64Array::from_iter_values(first..first + part.len() as i64);
        let mut arrays = self.of_cases(study, &part.cases, numbers);
        for &metric in &study.columns {
            let values = part.metrics.column(metric);
            let finite = values.map(|x| x.filter(|x| x.is_finite()));
            arrays.push(Arc::new(finite.collect::<Float64Array>()));
        }
        self.batch(arrays)
    }

    /// The numbers and the parameters of cases.
    pub fn of_cases(&mut self, study: &Study, cases: &Cases, numbers: Int64Array) -> Vec<ArrayRef> {
        let len = numbers.len();
        let mut arrays: Vec<ArrayRef> = vec![Arc::new(numbers)];
        let table = study.problem.parameters();
        for (row, constant) in self.parameters.iter().zip(&mut self.constant) {
            let kind = table[*row].kind;
            arrays.push(match &cases.columns()[*row] {
                Column::Each(cells) => array(kind, (0..len).map(|row| cells.at(row)), len),
                Column::Same(value) => match constant {
                    Some((same, n, array)) if *n == len && Value::identical(*same, *value) => {
                        array.clone()
                    }
                    other => {
                        let array = array(kind, repeat_n(*value, len), len);
                        *other = Some((*value, len, array.clone()));
                        array
                    }
                },
            });
        }
        arrays
    }

    /// The rows of these columns.
    pub fn batch(&self, arrays: Vec<ArrayRef>) -> Result<RecordBatch, Error> {
        RecordBatch::try_new(self.schema.clone(), arrays)
            .map_err(|error| Error::Internal(error.to_string()))
    }

    /// The types of the columns.
    pub fn schema(&self) -> SchemaRef {
        self.schema.clone()
    }
}

/// The values of a parameter of this kind; `None` if it does not apply.
fn array(kind: Kind, values: impl Iterator<Item = Option<Value>> + Clone, len: usize) -> ArrayRef {
    if values.clone().all(|value| value.is_none()) {
        return new_null_array(&data_type(kind), len);
    }
    match kind {
        Kind::Number(_) => {
            let numbers = values.map(|value| value?.as_f64());
            Arc::new(numbers.collect::<Float64Array>())
        }
        Kind::Whole { .. } => {
            let numbers = values.map(|value| match value? {
                Value::Whole(n) => i64::try_from(n).ok(),
                Value::Number(_) | Value::Name(_) => None,
            });
            Arc::new(numbers.collect::<Int64Array>())
        }
        Kind::Choice(_) => {
            let mut names = StringBuilder::with_capacity(len, 16 * len);
            for value in values {
                names.append_option(value.map(Value::name));
            }
            Arc::new(names.finish())
        }
    }
}
