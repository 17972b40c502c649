//! One chunk as a Parquet file: `case`, the parameters, the metrics, and `failure` where a case could not be solved.

use std::sync::Arc;

use bytes::Bytes;
use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
use parquet::column::reader::ColumnReader;
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::errors::{ParquetError, Result};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::{ColumnPath, Type};
use serde_json::json;

use crate::batch::Outcome;
use crate::batch::chunk::{Key, by_table};
use crate::compare::Rows;
use crate::problem::parameter::{Kind, Value, shortest};
use crate::study::Study;

/// Column of the reason why a case could not be solved.
const FAILURE: &str = "failure";

/// Bytes of the different values of a column from which on it has no dictionary.
const DICTIONARY: usize = 1 << 14;

/// Metrics by the problem's table, and why the case could not be solved.
type Row = (Vec<Option<f64>>, Option<String>);

/// The bytes of a chunk whose first case has the number `first`.
pub(super) fn written(
    study: &Study,
    key: &Key,
    first: u64,
    outcomes: &[Outcome],
) -> Result<Vec<u8>> {
    // Values that many cases share go to a dictionary, as far as there are few; metrics differ from case to case.
    let mut properties = WriterProperties::builder()
        .set_dictionary_enabled(true)
        .set_dictionary_page_size_limit(DICTIONARY)
        .set_compression(Compression::SNAPPY)
        .set_created_by("slipgap".into())
        .set_statistics_enabled(EnabledStatistics::Chunk)
        .set_key_value_metadata(Some(metadata(study, key)));
    let metrics = study
        .metrics
        .iter()
        .map(|m| study.problem.metrics()[*m].name);
    for name in metrics.chain(["case"]) {
        properties = properties.set_column_dictionary_enabled(ColumnPath::from(name), false);
    }
    let properties = properties.build();
    let mut bytes = Vec::new();
    let mut file =
        SerializedFileWriter::new(&mut bytes, Arc::new(schema(study)?), Arc::new(properties))?;
    let mut rows = file.next_row_group()?;
    let mut column = |data: Column| -> Result<()> {
        let mut writer = rows
            .next_column()?
            .ok_or_else(|| general("a column too many"))?;
        match data {
            Column::Number(values) => {
                let (values, levels) = levelled(values);
                writer
                    .typed::<DoubleType>()
                    .write_batch(&values, Some(&levels), None)?;
            }
            Column::Whole(values) => {
                let (values, levels) = levelled(values);
                writer
                    .typed::<Int64Type>()
                    .write_batch(&values, Some(&levels), None)?;
            }
            Column::Text(values) => {
                let (values, levels) = levelled(values);
                writer
                    .typed::<ByteArrayType>()
                    .write_batch(&values, Some(&levels), None)?;
            }
        }
        writer.close()
    };
    let numbers = (first..)
        .take(outcomes.len())
        .map(|number| Some(number as i64));
    column(Column::Whole(numbers.collect()))?;
    for (row, parameter) in study.problem.parameters().iter().enumerate() {
        let values = outcomes.iter().map(|o| o.case.values[row]);
        column(match parameter.kind {
            Kind::Number(_) => Column::Number(values.map(|v| v?.as_f64()).collect()),
            Kind::Whole { .. } => {
                Column::Whole(values.map(|v| Some(v?.as_f64()? as i64)).collect())
            }
            Kind::Choice(_) => Column::Text(values.map(name).collect()),
        })?;
    }
    for &metric in &study.metrics {
        column(Column::Number(
            outcomes.iter().map(|o| o.metrics[metric]).collect(),
        ))?;
    }
    let why = |o: &Outcome| Some(ByteArray::from(o.failure.as_deref()?));
    column(Column::Text(outcomes.iter().map(why).collect()))?;
    rows.close()?;
    file.close()?;
    Ok(bytes)
}

/// One column; every one may lack values.
enum Column {
    Number(Vec<Option<f64>>),
    Whole(Vec<Option<i64>>),
    Text(Vec<Option<ByteArray>>),
}

/// The values that are there, and for each row whether it has one.
fn levelled<T>(values: Vec<Option<T>>) -> (Vec<T>, Vec<i16>) {
    let mut levels = Vec::with_capacity(values.len());
    let mut there = Vec::with_capacity(values.len());
    for value in values {
        levels.push(i16::from(value.is_some()));
        there.extend(value);
    }
    (there, levels)
}

/// A name as it is stored: the table's own bytes, not a copy for each row.
fn name(value: Option<Value>) -> Option<ByteArray> {
    match value {
        Some(Value::Name(name)) => Some(Bytes::from_static(name.as_bytes()).into()),
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

/// The key of a chunk and its rows.
pub(super) fn read(study: &Study, bytes: Vec<u8>) -> Result<(Key, Vec<Row>)> {
    let file = SerializedFileReader::new(Bytes::from(bytes))?;
    let metadata = file.metadata().file_metadata();
    let pairs = metadata
        .key_value_metadata()
        .map(Vec::as_slice)
        .unwrap_or_default();
    let value = |key: &str| {
        let key = format!("slipgap.{key}");
        let pair = pairs.iter().find(|pair| pair.key == key);
        pair.and_then(|pair| pair.value.clone()).unwrap_or_default()
    };
    let key = Key {
        solver: value("solver"),
        columns: value("columns"),
        cases: value("cases"),
    };
    let count = usize::try_from(metadata.num_rows()).unwrap_or(0);
    let names: Vec<String> = metadata
        .schema_descr()
        .columns()
        .iter()
        .map(|c| c.name().to_owned())
        .collect();
    let place = |name: &str| names.iter().position(|n| n == name);
    let group = file.get_row_group(0)?;
    let mut columns = Vec::new();
    for &metric in &study.metrics {
        // Without one of the columns the key says so.
        let Some(place) = place(study.problem.metrics()[metric].name) else {
            return Ok((key, Vec::new()));
        };
        let ColumnReader::DoubleColumnReader(mut reader) = group.get_column_reader(place)? else {
            return Err(general("a metric that is no number"));
        };
        let (mut values, mut levels) = (Vec::new(), Vec::new());
        reader.read_records(count, Some(&mut levels), None, &mut values)?;
        columns.push(spread(values, &levels).collect::<Vec<_>>());
    }
    let place = place(FAILURE).ok_or_else(|| general("no column of failures"))?;
    let ColumnReader::ByteArrayColumnReader(mut reader) = group.get_column_reader(place)? else {
        return Err(general("a reason that is no text"));
    };
    let (mut values, mut levels) = (Vec::new(), Vec::new());
    reader.read_records(count, Some(&mut levels), None, &mut values)?;
    let failures = spread(values, &levels).map(|why| Some(why?.as_utf8().ok()?.to_owned()));
    let row = |(i, failure): (usize, Option<String>)| {
        let cells = columns
            .iter()
            .map(|column| column.get(i).copied().flatten());
        (by_table(study.problem, &study.metrics, cells), failure)
    };
    Ok((key, failures.enumerate().map(row).collect()))
}

/// Adds the rows of a part as text, but for the column of failures.
pub(super) fn text(bytes: Vec<u8>, rows: &mut Rows) -> Result<()> {
    let file = SerializedFileReader::new(Bytes::from(bytes))?;
    let count = usize::try_from(file.metadata().file_metadata().num_rows()).unwrap_or(0);
    let schema = file.metadata().file_metadata().schema_descr();
    let names = schema
        .columns()
        .iter()
        .map(|column| column.name().to_owned());
    rows.columns = names.filter(|name| name != FAILURE).collect();
    let group = file.get_row_group(0)?;
    let start = rows.rows.len();
    rows.rows.resize(start + count, Vec::new());
    for place in 0..rows.columns.len() {
        let mut levels = Vec::new();
        let cells: Vec<Option<String>> = match group.get_column_reader(place)? {
            ColumnReader::DoubleColumnReader(mut reader) => {
                let mut values = Vec::new();
                reader.read_records(count, Some(&mut levels), None, &mut values)?;
                spread(values, &levels).map(|x| x.map(shortest)).collect()
            }
            ColumnReader::Int64ColumnReader(mut reader) => {
                let mut values = Vec::new();
                reader.read_records(count, Some(&mut levels), None, &mut values)?;
                spread(values, &levels)
                    .map(|n| n.map(|n: i64| n.to_string()))
                    .collect()
            }
            ColumnReader::ByteArrayColumnReader(mut reader) => {
                let mut values = Vec::new();
                reader.read_records(count, Some(&mut levels), None, &mut values)?;
                let texts = spread(values, &levels);
                texts.map(|t| Some(t?.as_utf8().ok()?.to_owned())).collect()
            }
            _ => return Err(general("a column of an unknown type")),
        };
        for (row, cell) in rows.rows[start..].iter_mut().zip(cells) {
            row.push(cell.unwrap_or_default());
        }
    }
    Ok(())
}

/// A value or none for each row.
fn spread<T>(values: Vec<T>, levels: &[i16]) -> impl Iterator<Item = Option<T>> {
    let mut values = values.into_iter();
    let take = move |level: &i16| (*level > 0).then(|| values.next()).flatten();
    levels.iter().map(take)
}

fn general(what: &str) -> ParquetError {
    ParquetError::General(what.into())
}
