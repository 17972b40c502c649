//! Chunks read back from their files.

use bytes::Bytes;
use parquet::column::reader::ColumnReader;
use parquet::errors::Result;
use parquet::file::reader::{FileReader, SerializedFileReader};

use super::{FAILURE, general};
use crate::batch::chunk::Key;
use crate::compare::Rows;
use crate::problem::found::{Found, cells};
use crate::problem::parameter::shortest;
use crate::study::Study;

/// The key of a chunk and what was found of its cases.
pub fn read(study: &Study, bytes: Vec<u8>) -> Result<(Key, Found)> {
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
    let table = study.problem.metrics();
    let (mut columns, mut width) = (Vec::new(), 0);
    for &metric in &study.metrics {
        // Without one of the columns the key says so.
        let Some(place) = place(table[metric].name) else {
            return Ok((key, Found::default()));
        };
        let ColumnReader::DoubleColumnReader(mut reader) = group.get_column_reader(place)? else {
            return Err(general("a metric that is no number"));
        };
        let (mut values, mut levels) = (Vec::new(), Vec::new());
        reader.read_records(count, Some(&mut levels), None, &mut values)?;
        columns.push((metric, spread(values, &levels).collect::<Vec<_>>()));
        width = width.max(metric + 1);
    }
    let place = place(FAILURE).ok_or_else(|| general("no column of failures"))?;
    let ColumnReader::ByteArrayColumnReader(mut reader) = group.get_column_reader(place)? else {
        return Err(general("a reason that is no text"));
    };
    let (mut values, mut levels) = (Vec::new(), Vec::new());
    reader.read_records(count, Some(&mut levels), None, &mut values)?;
    let (mut found, mut row) = (Found::new(levels.len(), width), vec![None; width]);
    for (case, why) in spread(values, &levels).enumerate() {
        for (metric, column) in &columns {
            row[*metric] = column.get(case).copied().flatten();
        }
        found.set(case, cells(&row));
        if let Some(why) = why {
            found.fail(case, why.as_utf8()?.to_owned());
        }
    }
    Ok((key, found))
}

/// Adds the rows of a part as text, but for the column of failures.
pub fn text(bytes: Vec<u8>, rows: &mut Rows) -> Result<()> {
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
