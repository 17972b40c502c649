//! One chunk as a Parquet file: `case`, the parameters, the metrics, and `failure` where a case could not be solved.

use std::sync::Arc;

use bytes::Bytes;
use parquet::basic::{Compression, Encoding, LogicalType, Repetition, Type as Physical};
use parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::{ParquetError, Result};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::{ColumnPath, Type};
use serde_json::json;

use super::{FAILURE, general};
use crate::batch::chunk::Key;
use crate::problem::cases::{Cases, Column};
use crate::problem::found::Found;
use crate::problem::parameter::{Kind, Value};
use crate::study::Study;

/// Bytes of the different values of a column from which on it has no dictionary.
const DICTIONARY: usize = 1 << 14;

/// The bytes of a chunk, its cases with the number of the first.
pub fn written(
    study: &Study,
    key: &Key,
    (first, cases): (u64, &Cases),
    found: &Found,
) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let (schema, properties) = (Arc::new(schema(study)?), Arc::new(properties(study, key)));
    let mut file = SerializedFileWriter::new(&mut bytes, schema, properties)?;
    let mut rows = file.next_row_group()?;
    let len = cases.len();
    let numbers = (first..).take(len).map(|number| Some(number as i64));
    put::<Int64Type>(&mut rows, cells(len, numbers))?;
    for (column, parameter) in cases.columns().iter().zip(study.problem.parameters()) {
        match parameter.kind {
            Kind::Number(_) => put::<DoubleType>(&mut rows, given(column, len, Value::as_f64)),
            Kind::Whole { .. } => put::<Int64Type>(&mut rows, given(column, len, whole)),
            Kind::Choice(_) => put::<ByteArrayType>(&mut rows, given(column, len, name)),
        }?;
    }
    for &metric in &study.metrics {
        put::<DoubleType>(&mut rows, cells(len, found.column(metric)))?;
    }
    let why = |case| Some(ByteArray::from(found.failure(case)?));
    put::<ByteArrayType>(&mut rows, cells(len, (0..len).map(why)))?;
    rows.close()?;
    file.close()?;
    Ok(bytes)
}

/// How a chunk is laid out: values that many cases share go to a dictionary, as far as there are few; metrics differ
/// from case to case, in all their bits, so that nothing makes them smaller.
fn properties(study: &Study, key: &Key) -> WriterProperties {
    let mut properties = WriterProperties::builder()
        .set_dictionary_enabled(true)
        .set_dictionary_page_size_limit(DICTIONARY)
        .set_compression(Compression::SNAPPY)
        .set_created_by("slipgap".into())
        .set_statistics_enabled(EnabledStatistics::Chunk)
        .set_key_value_metadata(Some(metadata(study, key)));
    // Numbers of cases follow each other: their differences take no room.
    properties = properties
        .set_column_dictionary_enabled(ColumnPath::from("case"), false)
        .set_column_encoding(ColumnPath::from("case"), Encoding::DELTA_BINARY_PACKED);
    for &metric in &study.metrics {
        let path = || ColumnPath::from(study.problem.metrics()[metric].name);
        properties = properties
            .set_column_dictionary_enabled(path(), false)
            .set_column_compression(path(), Compression::UNCOMPRESSED);
    }
    properties.build()
}

/// The values of a column that are there, and for each row whether it has one.
type Cells<T> = (Vec<T>, Vec<i16>);

/// A column of parameters as cells of the type `T`.
fn given<T: Clone>(column: &Column, len: usize, of: impl Fn(Value) -> Option<T>) -> Cells<T> {
    match column {
        Column::Each(values) => cells(len, values.iter().map(|value| value.and_then(&of))),
        Column::Same(value) => match value.and_then(of) {
            Some(value) => (vec![value; len], vec![1; len]),
            None => (Vec::new(), vec![0; len]),
        },
    }
}

/// `len` cells.
fn cells<T>(len: usize, of: impl Iterator<Item = Option<T>>) -> Cells<T> {
    let (mut values, mut levels) = (Vec::with_capacity(len), Vec::with_capacity(len));
    for cell in of {
        levels.push(i16::from(cell.is_some()));
        values.extend(cell);
    }
    (values, levels)
}

/// Writes the next column.
fn put<D: DataType>(
    rows: &mut SerializedRowGroupWriter<&mut Vec<u8>>,
    (values, levels): Cells<D::T>,
) -> Result<()> {
    let next = rows.next_column()?;
    let mut writer = next.ok_or_else(|| general("a column too many"))?;
    let typed = writer.typed::<D>();
    typed.write_batch(&values, Some(&levels), None)?;
    writer.close()
}

fn whole(value: Value) -> Option<i64> {
    match value {
        Value::Whole(n) => Some(n as i64),
        _ => None,
    }
}

/// A name as it is stored: the table's own bytes, not a copy for each row.
fn name(value: Value) -> Option<ByteArray> {
    match value {
        Value::Name(name) => Some(Bytes::from_static(name.as_bytes()).into()),
        _ => None,
    }
}

fn schema(study: &Study) -> Result<Type> {
    let column = |name: &str, physical: Physical| {
        let text = (physical == Physical::BYTE_ARRAY).then_some(LogicalType::String);
        let built = Type::primitive_type_builder(name, physical)
            .with_repetition(Repetition::OPTIONAL)
            .with_logical_type(text)
            .build()?;
        Ok::<_, ParquetError>(Arc::new(built))
    };
    let mut fields = vec![column("case", Physical::INT64)?];
    for parameter in study.problem.parameters() {
        let physical = match parameter.kind {
            Kind::Number(_) => Physical::DOUBLE,
            Kind::Whole { .. } => Physical::INT64,
            Kind::Choice(_) => Physical::BYTE_ARRAY,
        };
        fields.push(column(parameter.name, physical)?);
    }
    for &metric in &study.metrics {
        fields.push(column(
            study.problem.metrics()[metric].name,
            Physical::DOUBLE,
        )?);
    }
    fields.push(column(FAILURE, Physical::BYTE_ARRAY)?);
    Type::group_type_builder("results")
        .with_fields(fields)
        .build()
}

/// The chunk's key, and unit and meaning of every column.
fn metadata(study: &Study, key: &Key) -> Vec<KeyValue> {
    let parameters = study.problem.parameters().iter();
    let parameters = parameters.map(|p| (p.name, p.unit, p.meaning));
    let metrics = study.metrics.iter().map(|m| &study.problem.metrics()[*m]);
    let metrics = metrics.map(|m| (m.name, m.unit, m.meaning));
    let own = [
        ("case", "1", "number of the case, from 0"),
        (FAILURE, "", "why the case could not be solved"),
    ];
    let described = own.into_iter().chain(parameters).chain(metrics);
    let columns: serde_json::Map<String, serde_json::Value> = described
        .map(|(name, unit, meaning)| (name.into(), json!({ "unit": unit, "description": meaning })))
        .collect();
    let pair = |key: &str, value: &str| KeyValue::new(format!("slipgap.{key}"), value.to_owned());
    vec![
        pair("solver", &key.solver),
        pair("columns", &key.columns),
        pair("cases", &key.cases),
        pair("description", &serde_json::Value::from(columns).to_string()),
    ]
}
