//! Decodes parts from Parquet.
#![expect(clippy::wildcard_enum_match_arm, reason = "types of parquet")]

use bytes::Bytes;
use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::data_type::{ByteArray, DataType};
use parquet::errors::{ParquetError, Result};
use parquet::file::reader::{ChunkReader, FileReader, SerializedFileReader};

use super::key::{CaseHash, Difference, Key};
use super::numbers;
use super::rows::Rows;
use crate::chunks::chunk::MOST_ROWS;
use slipgap_motion::solve::{MetricTable, Unsolvable, Warnings};
use slipgap_problem::problem::Case;
use slipgap_problem::problem::numbers::parameter::{ColumnRule, Kind, Parameter, Value, real};
use slipgap_study::Study;

/// Column of the reason why a case could not be solved.
pub const FAILURE: &str = "failure";

/// Column of the names of the warnings of a case.
pub const WARNED: &str = "warnings";

/// Number of the columns of text after the metrics: failures, then warnings.
pub const OWN_TEXTS: usize = 2;

/// An error with this message.
pub fn general(message: &str) -> ParquetError {
    ParquetError::General(message.into())
}

/// What a part has, or the difference of its key.
type OfPart<T> = Result<std::result::Result<T, Difference>>;

/// The metrics of a part with so many cases.
pub fn read(study: &Study, bytes: Vec<u8>, key: &Key, cases: usize) -> OfPart<MetricTable> {
    let file = SerializedFileReader::new(Bytes::from(bytes))?;
    match check_file(&file, key, cases)? {
        Ok(()) => Ok(Ok(metrics(study, &file, cases)?)),
        Err(difference) => Ok(Err(difference)),
    }
}

/// Whether a part has this key and so many cases.
pub fn check(bytes: Vec<u8>, key: &Key, cases: usize) -> OfPart<()> {
    check_file(&SerializedFileReader::new(Bytes::from(bytes))?, key, cases)
}

/// What the footer of a part says.
pub struct Summary {
    /// Its key.
    pub key: Key,
    /// Number of its cases.
    pub cases: usize,
    /// Number of these that could not be solved.
    pub failed: u64,
}

/// What the footer of a part says; nothing else is read.
pub fn summary<R: ChunkReader + 'static>(file: R) -> Result<Summary> {
    let file = SerializedFileReader::new(file)?;
    let cases = rows(&file)?;
    let group = file.metadata().row_group(0);
    let first_text = group.num_columns().checked_sub(OWN_TEXTS);
    let column = first_text.map(|first_text| group.column(first_text).statistics());
    let empty = column.flatten().and_then(|column| column.null_count_opt());
    let failed = empty.and_then(|empty| (cases as u64).checked_sub(empty));
    Ok(Summary {
        key: stored_key(&file),
        cases,
        failed: failed.ok_or_else(|| general("the number of failures is not given"))?,
    })
}

fn check_file<R: ChunkReader + 'static>(
    file: &SerializedFileReader<R>,
    key: &Key,
    cases: usize,
) -> Result<std::result::Result<(), Difference>> {
    if let Some(difference) = key.difference(&stored_key(file)) {
        return Ok(Err(difference));
    }
    match rows(file)? == cases {
        true => Ok(Ok(())),
        false => Err(general("wrong number of rows")),
    }
}

/// The metrics of a part and the hashes of its cases; `None` if another solver computed it or it has other columns.
pub fn read_hashed(
    study: &Study,
    bytes: Vec<u8>,
    key: &Key,
) -> Result<Option<(Vec<u128>, MetricTable)>> {
    let file = SerializedFileReader::new(Bytes::from(bytes))?;
    if !key.same_solver_and_columns(&stored_key(&file)) {
        return Ok(None);
    }
    let count = rows(&file)?;
    let schema = study.problem.schema();
    let mut columns = Vec::new();
    for parameter in schema.parameters.iter() {
        // A study that does not give the parameter stores no column of it.
        let absent = parameter.column == ColumnRule::IfGiven
            && place(&file, parameter.column_name()).is_err();
        columns.push(match absent {
            true => None,
            false => Some(values(parameter, &file, count)?),
        });
    }
    let (mut case, mut hash) = (Case::new(schema), CaseHash::default());
    let hash = |index: usize| {
        for (row, column) in columns.iter().enumerate() {
            case.values[row] = match column {
                Some(values) => values[index],
                None => case.default_at(row),
            };
        }
        hash.of(&case.values)
    };
    let hashes = (0..count).map(hash).collect();
    Ok(Some((hashes, metrics(study, &file, count)?)))
}

/// The values of a parameter.
fn values(
    parameter: &Parameter,
    file: &SerializedFileReader<Bytes>,
    count: usize,
) -> Result<Vec<Option<Value>>> {
    let column = place(file, parameter.column_name())?;
    let other = || general("a parameter has the wrong type");
    Ok(
        match (
            parameter.kind,
            file.get_row_group(0)?.get_column_reader(column)?,
        ) {
            (Kind::Number(_), ColumnReader::DoubleColumnReader(reader)) => {
                let numbers = cells(reader, count)?.into_iter();
                numbers.map(|x| x.map(Value::Number)).collect()
            }
            (Kind::Whole { .. }, ColumnReader::Int64ColumnReader(reader)) => {
                let numbers = cells(reader, count)?.into_iter();
                numbers.map(|n| n.map(|n| Value::Whole(n as u64))).collect()
            }
            (Kind::Choice(names), ColumnReader::ByteArrayColumnReader(reader)) => {
                let known = |text: ByteArray| {
                    let name = names
                        .iter()
                        .find(|(name, _)| name.as_bytes() == text.data());
                    name.map(|(name, _)| Value::Name(name)).ok_or_else(other)
                };
                let texts = cells(reader, count)?.into_iter();
                texts
                    .map(|text| text.map(known).transpose())
                    .collect::<Result<_>>()?
            }
            _ => return Err(other()),
        },
    )
}

/// The key of a part.
fn stored_key<R: ChunkReader + 'static>(file: &SerializedFileReader<R>) -> Key {
    let metadata = file.metadata().file_metadata();
    let known = metadata.key_value_metadata();
    let pairs = known.map(Vec::as_slice).unwrap_or_default();
    let value = |key: &str| {
        let key = format!("slipgap.{key}");
        let pair = pairs.iter().find(|pair| pair.key == key);
        pair.and_then(|pair| pair.value.clone()).unwrap_or_default()
    };
    Key {
        solver: value("solver"),
        columns: value("columns"),
        cases: value("cases"),
    }
}

/// The place of a column.
fn place(file: &SerializedFileReader<Bytes>, name: &str) -> Result<usize> {
    let columns = file.metadata().file_metadata().schema_descr().columns();
    let index = columns.iter().position(|column| column.name() == name);
    index.ok_or_else(|| general("a column is missing"))
}

/// The metrics of a part.
fn metrics(study: &Study, file: &SerializedFileReader<Bytes>, count: usize) -> Result<MetricTable> {
    let group = file.get_row_group(0)?;
    let names = study.problem.metrics();
    let (mut columns, mut width) = (Vec::new(), 0);
    for &metric in &study.metrics {
        let column = place(file, &names[metric].name)?;
        let numbers = match (
            numbers::decode(&*group, column, count)?,
            group.get_column_reader(column)?,
        ) {
            (Some(numbers), ColumnReader::DoubleColumnReader(_)) => numbers,
            (None, ColumnReader::DoubleColumnReader(reader)) => {
                let cells = cells(reader, count)?.into_iter();
                cells.map(|x| x.unwrap_or(f64::NAN)).collect()
            }
            _ => return Err(general("a metric is not a number")),
        };
        columns.push((metric, numbers));
        width = width.max(metric + 1);
    }
    // By their places: a parameter may have the same name.
    let numeric = group.num_columns().checked_sub(OWN_TEXTS);
    let first_text = numeric.ok_or_else(|| general("a column is missing"))?;
    let texts = |column: usize| match group.get_column_reader(column)? {
        ColumnReader::ByteArrayColumnReader(reader) => filled(reader, count),
        _ => Err(general("a column is not text")),
    };
    let (failures, warned) = (texts(first_text)?, texts(first_text + 1)?);
    let mut table = MetricTable::new(count, width);
    for (metric, numbers) in columns {
        table.set_column(metric, numbers.into_iter());
    }
    for (case, why) in failures {
        table.fail(case, Unsolvable::Stored(why.as_utf8()?.to_owned()));
    }
    for (case, names) in warned {
        table.warn(case, Warnings::parse(names.as_utf8()?));
    }
    Ok(table)
}

/// The rows of a part as text, without the columns of failures and warnings.
pub fn read_text(bytes: Vec<u8>) -> Result<Rows> {
    let mut text = Rows::default();
    let file = SerializedFileReader::new(Bytes::from(bytes))?;
    let count = rows(&file)?;
    let schema = file.metadata().file_metadata().schema_descr();
    let names = schema.columns().iter().map(|column| column.name());
    text.columns = names.map(str::to_owned).collect();
    text.columns
        .truncate(text.columns.len().saturating_sub(OWN_TEXTS));
    let group = file.get_row_group(0)?;
    text.rows.resize(count, Vec::new());
    for column in 0..text.columns.len() {
        let cells: Vec<Option<String>> = match group.get_column_reader(column)? {
            ColumnReader::DoubleColumnReader(reader) => {
                let numbers = cells(reader, count)?.into_iter();
                numbers.map(|x| x.map(real)).collect()
            }
            ColumnReader::Int64ColumnReader(reader) => {
                let numbers = cells(reader, count)?.into_iter();
                numbers.map(|n| n.map(|n| n.to_string())).collect()
            }
            ColumnReader::ByteArrayColumnReader(reader) => {
                let texts = cells(reader, count)?.into_iter();
                texts.map(|t| Some(t?.as_utf8().ok()?.to_owned())).collect()
            }
            _ => return Err(general("a column has an unknown type")),
        };
        for (row, cell) in text.rows.iter_mut().zip(cells) {
            row.push(cell.unwrap_or_default());
        }
    }
    Ok(text)
}

/// Number of rows, if a part can have as many: memory is allocated before they are read.
fn rows<R: ChunkReader + 'static>(file: &SerializedFileReader<R>) -> Result<usize> {
    let rows = usize::try_from(file.metadata().file_metadata().num_rows()).ok();
    let one = file.num_row_groups() == 1;
    let rows = rows.filter(|rows| one && *rows <= MOST_ROWS);
    rows.ok_or_else(|| general("the number of rows is impossible"))
}

/// The cells of a column of `count` rows.
fn cells<D: DataType>(reader: ColumnReaderImpl<D>, count: usize) -> Result<Vec<Option<D::T>>> {
    let (values, levels) = values_and_levels(reader, count)?;
    let mut values = values.into_iter();
    let cell = |level: &i16| (*level > 0).then(|| values.next()).flatten();
    Ok(levels.iter().map(cell).collect())
}

/// The cells that have a value, with their rows, of a column of `count` rows.
fn filled<D: DataType>(reader: ColumnReaderImpl<D>, count: usize) -> Result<Vec<(usize, D::T)>> {
    let (values, levels) = values_and_levels(reader, count)?;
    let rows = (0..count).filter(|row| levels[*row] > 0);
    Ok(rows.zip(values).collect())
}

/// The values of a column of `count` rows, and for each row whether it has one.
fn values_and_levels<D: DataType>(
    mut reader: ColumnReaderImpl<D>,
    count: usize,
) -> Result<(Vec<D::T>, Vec<i16>)> {
    let (mut values, mut levels) = (Vec::new(), Vec::new());
    reader.read_records(count, Some(&mut levels), None, &mut values)?;
    match levels.len() == count {
        true => Ok((values, levels)),
        false => Err(general("a column is too short")),
    }
}
