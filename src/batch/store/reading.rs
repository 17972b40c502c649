//! Parts read back from their files.

use bytes::Bytes;
use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::data_type::DataType;
use parquet::errors::Result;
use parquet::file::reader::{FileReader, SerializedFileReader};

use super::{FAILURE, general};
use crate::batch::chunk::MOST_ROWS;
use crate::batch::key::Key;
use crate::compare::Rows;
use crate::problem::found::Found;
use crate::problem::parameter::shortest;
use crate::study::Study;

/// What was found of the cases of a part, as many as there are; or what differs from its key.
pub fn read(
    study: &Study,
    bytes: Vec<u8>,
    key: &Key,
    cases: usize,
) -> Result<std::result::Result<Found, &'static str>> {
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
    let kept = Key {
        solver: value("solver"),
        columns: value("columns"),
        cases: value("cases"),
    };
    if let Some(change) = key.change(&kept) {
        return Ok(Err(change));
    }
    let count = rows(&file)?;
    if count != cases {
        return Err(general("another number of rows"));
    }
    let names: Vec<String> = metadata
        .schema_descr()
        .columns()
        .iter()
        .map(|c| c.name().to_owned())
        .collect();
    let place = |name: &str| names.iter().position(|n| n == name);
    let group = file.get_row_group(0)?;
    let table = study.problem.metrics();
    let (mut columns, mut width) = (Vec::new(), 0);
    for &metric in &study.metrics {
        let place = place(table[metric].name).ok_or_else(|| general("a metric is missing"))?;
        let ColumnReader::DoubleColumnReader(reader) = group.get_column_reader(place)? else {
            return Err(general("a metric that is no number"));
        };
        columns.push((metric, cells(reader, count)?));
        width = width.max(metric + 1);
    }
    let place = place(FAILURE).ok_or_else(|| general("no column of failures"))?;
    let ColumnReader::ByteArrayColumnReader(reader) = group.get_column_reader(place)? else {
        return Err(general("a reason that is no text"));
    };
    let failures = cells(reader, count)?;
    let (mut found, mut row) = (Found::new(failures.len(), width), vec![f64::NAN; width]);
    for (case, why) in failures.into_iter().enumerate() {
        for (metric, column) in &columns {
            row[*metric] = column.get(case).copied().flatten().unwrap_or(f64::NAN);
        }
        found.set(case, row.iter().copied());
        if let Some(why) = why {
            found.fail(case, why.as_utf8()?.to_owned());
        }
    }
    Ok(Ok(found))
}

/// The rows of a part as text, but for the column of failures.
pub fn text(bytes: Vec<u8>) -> Result<Rows> {
    let mut text = Rows::default();
    let file = SerializedFileReader::new(Bytes::from(bytes))?;
    let count = rows(&file)?;
    let schema = file.metadata().file_metadata().schema_descr();
    let names = schema
        .columns()
        .iter()
        .map(|column| column.name().to_owned());
    text.columns = names.filter(|name| name != FAILURE).collect();
    let group = file.get_row_group(0)?;
    text.rows.resize(count, Vec::new());
    for place in 0..text.columns.len() {
        let told: Vec<Option<String>> = match group.get_column_reader(place)? {
            ColumnReader::DoubleColumnReader(reader) => {
                let numbers = cells(reader, count)?.into_iter();
                numbers.map(|x| x.map(shortest)).collect()
            }
            ColumnReader::Int64ColumnReader(reader) => {
                let numbers = cells(reader, count)?.into_iter();
                numbers.map(|n| n.map(|n| n.to_string())).collect()
            }
            ColumnReader::ByteArrayColumnReader(reader) => {
                let texts = cells(reader, count)?.into_iter();
                texts.map(|t| Some(t?.as_utf8().ok()?.to_owned())).collect()
            }
            _ => return Err(general("a column of an unknown type")),
        };
        for (row, cell) in text.rows.iter_mut().zip(told) {
            row.push(cell.unwrap_or_default());
        }
    }
    Ok(text)
}

/// Number of rows, where a part can have as many: memory is made for them before they are read.
fn rows(file: &SerializedFileReader<Bytes>) -> Result<usize> {
    let rows = usize::try_from(file.metadata().file_metadata().num_rows()).ok();
    let one = file.num_row_groups() == 1;
    let rows = rows.filter(|rows| one && *rows <= MOST_ROWS);
    rows.ok_or_else(|| general("a number of rows that no part has"))
}

/// The cells of a column of `count` rows: a value or none for each.
fn cells<D: DataType>(mut reader: ColumnReaderImpl<D>, count: usize) -> Result<Vec<Option<D::T>>> {
    let (mut values, mut levels) = (Vec::new(), Vec::new());
    reader.read_records(count, Some(&mut levels), None, &mut values)?;
    let mut values = values.into_iter();
    let cell = |level: &i16| (*level > 0).then(|| values.next()).flatten();
    let cells: Vec<Option<D::T>> = levels.iter().map(cell).collect();
    match cells.len() == count {
        true => Ok(cells),
        false => Err(general("a column that is too short")),
    }
}
