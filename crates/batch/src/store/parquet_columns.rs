//! The columns of a part as Parquet: names, types, encodings, units and meanings.

use super::key::Key;
use super::reading::{FAILURE, WARNED};
use parquet::basic::{Compression, Encoding, LogicalType, Repetition, Type as Physical};
use parquet::errors::{ParquetError, Result};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::schema::types::{ColumnPath, Type};
use serde_json::json;
use slipgap_problem::problem::numbers::parameter::Kind;
use slipgap_study::Study;
use std::sync::Arc;

/// Largest dictionary of a column, in bytes.
const DICTIONARY: usize = 1 << 14;

/// The encodings of the columns of few different values: a dictionary. Numbers that differ from case to case are encoded by
/// `numbers`.
pub fn properties() -> WriterProperties {
    let properties = WriterProperties::builder()
        .set_dictionary_enabled(true)
        .set_dictionary_page_size_limit(DICTIONARY)
        .set_compression(Compression::SNAPPY)
        .set_created_by("slipgap".into())
        .set_statistics_enabled(EnabledStatistics::Chunk)
        .set_offset_index_disabled(true);
    // Case numbers are consecutive: their differences take almost no space.
    properties
        .set_column_dictionary_enabled(ColumnPath::from("case"), false)
        .set_column_encoding(ColumnPath::from("case"), Encoding::DELTA_BINARY_PACKED)
        .build()
}

/// The columns with their types.
pub fn schema(study: &Study) -> Result<Type> {
    let column = |name: &str, physical: Physical| {
        let text = (physical == Physical::BYTE_ARRAY).then_some(LogicalType::String);
        let built = Type::primitive_type_builder(name, physical)
            .with_repetition(Repetition::OPTIONAL)
            .with_logical_type(text)
            .build()?;
        Ok::<_, ParquetError>(Arc::new(built))
    };
    let mut fields = vec![column("case", Physical::INT64)?];
    let parameters = study.problem.parameters();
    for parameter in study
        .parameter_columns()
        .iter()
        .map(|row| &parameters[*row])
    {
        let physical = match parameter.kind {
            Kind::Number(_) => Physical::DOUBLE,
            Kind::Whole { .. } => Physical::INT64,
            Kind::Choice(_) => Physical::BYTE_ARRAY,
        };
        fields.push(column(parameter.column_name(), physical)?);
    }
    for &metric in &study.metrics {
        fields.push(column(
            &study.problem.metrics()[metric].name,
            Physical::DOUBLE,
        )?);
    }
    fields.push(column(FAILURE, Physical::BYTE_ARRAY)?);
    fields.push(column(WARNED, Physical::BYTE_ARRAY)?);
    Type::group_type_builder("results")
        .with_fields(fields)
        .build()
}

/// The part's key, and unit and meaning of every column.
pub fn metadata(study: &Study, key: &Key) -> Vec<KeyValue> {
    let table = study.problem.parameters();
    let rows = study.parameter_columns().into_iter();
    let parameters = rows
        .map(|row| &table[row])
        .map(|p| (p.column_name(), &*p.unit, &*p.meaning));
    let metric_rows = study.metrics.iter().map(|m| &study.problem.metrics()[*m]);
    let metrics = metric_rows.map(|m| (&*m.name, &*m.unit, &*m.meaning));
    let own_columns = [
        ("case", "1", "number of the case, from 0"),
        (FAILURE, "", "why the case could not be solved"),
        (WARNED, "", "names of the warnings of the case"),
    ];
    let described = own_columns.into_iter().chain(parameters).chain(metrics);
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
