//! Encodes parts as Parquet: `case`, the parameters, the metrics, `failure` if a case could not be solved, and `warnings`.

use std::iter::repeat_n;
use std::sync::Arc;

use bytes::Bytes;
use parquet::column::writer::{ColumnWriter, get_column_writer, get_typed_column_writer_mut};
use parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::Result;
use parquet::file::properties::WriterPropertiesPtr;
use parquet::file::writer::{
    SerializedFileWriter, SerializedPageWriter, SerializedRowGroupWriter, TrackedWrite,
};
use parquet::schema::types::ColumnDescPtr;

use super::constant_columns::{ConstantColumns, EncodedColumn};
use super::key::Key;
use super::reading::{OWN_TEXTS, general};
use super::schema::{properties, schema};
use slipgap_motion::solve::MetricTable;
use slipgap_problem::problem::numbers::parameter::{Kind, Value};
use slipgap_problem::problem::table::cases::{Cases, Cells, Column, NO_NAME, NO_WHOLE, applies};
use slipgap_study::Study;

/// The text of a case in a column, if it has one.
type Text<'a> = &'a dyn Fn(usize) -> Option<ByteArray>;

/// The bytes of a part. `first` is the number of its first case.
pub fn encode(
    study: &Study,
    key: &Key,
    (first, cases): (u64, &Cases),
    metrics: &MetricTable,
    constant_columns: &ConstantColumns,
) -> Result<Vec<u8>> {
    let mut bytes = Vec::with_capacity(8 * cases.len() * (study.metrics.len() + 2));
    let (schema, properties) = (Arc::new(schema(study)?), Arc::new(properties(study, key)));
    let mut file = SerializedFileWriter::new(&mut bytes, schema, properties.clone())?;
    let columns = file.schema_descr().columns().to_vec();
    let mut rows = file.next_row_group()?;
    let len = cases.len();
    let number = |row| (first + cases.offset(row)) as i64;
    let numbers: Vec<i64> = (0..len).map(number).collect();
    write_next(&mut rows, |writer| write_all::<Int64Type>(writer, &numbers))?;
    let table = study.problem.parameters();
    let given = study.parameter_columns().into_iter();
    let given = given.map(|row| (&cases.columns()[row], &table[row]));
    for (place, (column, parameter)) in (1..).zip(given) {
        match column {
            Column::Each(cells) => write_next(&mut rows, |writer| write_column(writer, cells))?,
            Column::Same(value) => {
                let (bytes, footer) = constant_columns.column(place, *value, len, || {
                    encode_column(&columns[place], &properties, |writer| {
                        write_values(writer, parameter.kind, len, repeat_n(*value, len))
                    })
                })?;
                rows.append_column(&bytes, footer)?;
            }
        }
    }
    for &metric in &study.metrics {
        write_next(&mut rows, |writer| match metrics.numbers(metric) {
            Some(numbers) => write_numbers(writer, numbers, |x| !x.is_nan()),
            None => write_cells::<DoubleType>(writer, len, repeat_n(None, len)),
        })?;
    }
    // Most parts have no failures and no warnings.
    let why = |case| Some(ByteArray::from(metrics.failure(case)?.to_string().as_str()));
    let warned = |case| warnings(metrics, case);
    let texts: [(bool, Text); OWN_TEXTS] = [
        (metrics.failures().next().is_some(), &why),
        (metrics.warned().next().is_some(), &warned),
    ];
    for (place, (some, text)) in (columns.len() - OWN_TEXTS..).zip(texts) {
        if some {
            write_next(&mut rows, |writer| {
                write_cells::<ByteArrayType>(writer, len, (0..len).map(text))
            })?;
            continue;
        }
        let (bytes, footer) = constant_columns.column(place, None, len, || {
            encode_column(&columns[place], &properties, |writer| {
                write_cells::<ByteArrayType>(writer, len, repeat_n(None, len))
            })
        })?;
        rows.append_column(&bytes, footer)?;
    }
    rows.close()?;
    file.close()?;
    Ok(bytes)
}

/// Writes the next column.
fn write_next(
    rows: &mut SerializedRowGroupWriter<&mut Vec<u8>>,
    write: impl FnOnce(&mut ColumnWriter) -> Result<()>,
) -> Result<()> {
    let next = rows.next_column()?;
    let mut writer = next.ok_or_else(|| general("one column too many"))?;
    write(writer.untyped())?;
    writer.close()
}

/// Encodes a column apart from a file, to be copied into parts.
fn encode_column(
    column: &ColumnDescPtr,
    properties: &WriterPropertiesPtr,
    write: impl FnOnce(&mut ColumnWriter) -> Result<()>,
) -> Result<EncodedColumn> {
    let mut bytes = TrackedWrite::new(Vec::new());
    let pages = Box::new(SerializedPageWriter::new(&mut bytes));
    let mut writer = get_column_writer(column.clone(), properties.clone(), pages);
    write(&mut writer)?;
    let closed = writer.close()?;
    Ok((bytes.into_inner()?.into(), closed))
}

/// Writes values of a parameter of this kind.
fn write_values(
    writer: &mut ColumnWriter,
    kind: Kind,
    len: usize,
    values: impl Iterator<Item = Option<Value>>,
) -> Result<()> {
    match kind {
        Kind::Number(_) => write_cells::<DoubleType>(writer, len, values.map(|v| v?.as_f64())),
        Kind::Whole { .. } => write_cells::<Int64Type>(writer, len, values.map(|v| integer(v?))),
        Kind::Choice(_) => write_cells::<ByteArrayType>(writer, len, values.map(|v| name(v?))),
    }
}

/// Writes the values of a parameter.
fn write_column(writer: &mut ColumnWriter, cells: &Cells) -> Result<()> {
    match cells {
        Cells::Numbers(numbers) => write_numbers(writer, numbers, applies),
        Cells::Whole(numbers) => {
            let cells = numbers
                .iter()
                .map(|n| (*n != NO_WHOLE).then_some(*n as i64));
            write_cells::<Int64Type>(writer, numbers.len(), cells)
        }
        Cells::Names { names, places } => {
            let names = names
                .iter()
                .map(|name| Bytes::from_static(name.as_bytes()).into());
            let names: Vec<ByteArray> = names.collect();
            let name = |place: &u32| (*place != NO_NAME).then(|| names[*place as usize].clone());
            write_cells::<ByteArrayType>(writer, places.len(), places.iter().map(name))
        }
    }
}

/// Writes numbers, of which those that `has` selects are cells with a value.
fn write_numbers(
    writer: &mut ColumnWriter,
    numbers: &[f64],
    has: impl Fn(f64) -> bool,
) -> Result<()> {
    match numbers.iter().all(|x| has(*x)) {
        true => write_all::<DoubleType>(writer, numbers),
        false => {
            let cells = numbers.iter().map(|x| has(*x).then_some(*x));
            write_cells::<DoubleType>(writer, numbers.len(), cells)
        }
    }
}

/// Writes cells that all have a value.
fn write_all<D: DataType>(writer: &mut ColumnWriter, values: &[D::T]) -> Result<()> {
    let writer = get_typed_column_writer_mut::<D>(writer);
    writer.write_batch(values, Some(&vec![1; values.len()]), None)?;
    Ok(())
}

/// Writes `len` cells: the values, and for each row whether it has one.
fn write_cells<D: DataType>(
    writer: &mut ColumnWriter,
    len: usize,
    cells: impl Iterator<Item = Option<D::T>>,
) -> Result<()> {
    let (mut values, mut levels) = (Vec::with_capacity(len), Vec::with_capacity(len));
    for cell in cells {
        levels.push(i16::from(cell.is_some()));
        values.extend(cell);
    }
    let writer = get_typed_column_writer_mut::<D>(writer);
    writer.write_batch(&values, Some(&levels), None)?;
    Ok(())
}

fn integer(value: Value) -> Option<i64> {
    match value {
        Value::Whole(n) => Some(n as i64),
        Value::Number(_) | Value::Name(_) => None,
    }
}

/// A name without a copy of its bytes for each row.
fn name(value: Value) -> Option<ByteArray> {
    match value {
        Value::Name(name) => Some(Bytes::from_static(name.as_bytes()).into()),
        Value::Number(_) | Value::Whole(_) => None,
    }
}

/// The names of the warnings of a case, if it has some.
fn warnings(metrics: &MetricTable, case: usize) -> Option<ByteArray> {
    let warnings = metrics.warnings(case);
    (!warnings.is_empty()).then(|| ByteArray::from(warnings.names().as_str()))
}
