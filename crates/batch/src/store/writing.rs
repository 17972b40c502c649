//! Encodes parts as Parquet: `case`, the parameters, the metrics, `failure` if a case could not be solved, and `warnings`.
//!
//! Each column is encoded by itself, so that several threads encode a part, and the pieces of a file are written where they are.

use std::iter::{once, repeat_n};
use std::sync::Arc;

use bytes::Bytes;
use parquet::column::writer::{ColumnWriter, get_column_writer, get_typed_column_writer_mut};
use parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::Result;
use parquet::file::metadata::{
    ColumnChunkMetaData, FileMetaData, KeyValue, ParquetMetaData, ParquetMetaDataWriter,
    RowGroupMetaData,
};
use parquet::file::properties::WriterPropertiesPtr;
use parquet::file::writer::{SerializedPageWriter, TrackedWrite};
use parquet::schema::types::SchemaDescriptor;
use rayon::prelude::*;

use super::constant_columns::{ConstantColumns, EncodedColumn};
use super::key::Key;
use super::numbers;
use super::parquet_columns::{metadata, properties, schema};
use slipgap_motion::solve::MetricTable;
use slipgap_problem::problem::numbers::parameter::{Kind, Range, Value};
use slipgap_problem::problem::table::cases::{Cases, Cells, Column, NO_NAME, NO_WHOLE, applies};
use slipgap_study::Study;

/// The first bytes of a Parquet file. The last ones are written with its footer.
const MAGIC: &[u8] = b"PAR1";

/// What a column is made of.
enum Source<'a> {
    Cases,
    Parameter(Kind, &'a Column),
    Metric(&'a [f64]),
    Failures,
    Warnings,
}

/// A part that is being encoded.
struct Encoder<'a> {
    /// Number of the first case.
    first: u64,
    cases: &'a Cases,
    metrics: &'a MetricTable,
    constant_columns: &'a ConstantColumns,
    schema: Arc<SchemaDescriptor>,
    properties: WriterPropertiesPtr,
}

/// The bytes of a part, in pieces. `first` is the number of its first case.
pub fn encode(
    study: &Study,
    key: &Key,
    (first, cases): (u64, &Cases),
    metrics: &MetricTable,
    constant_columns: &ConstantColumns,
) -> Result<Vec<Bytes>> {
    let encoder = Encoder {
        first,
        cases,
        metrics,
        constant_columns,
        schema: Arc::new(SchemaDescriptor::new(Arc::new(schema(study)?))),
        properties: Arc::new(properties()),
    };
    let table = study.problem.parameters();
    let rows = study.parameter_columns().into_iter();
    let parameters = rows.map(|row| Source::Parameter(table[row].kind, &cases.columns()[row]));
    let numbers = |metric: &usize| metrics.numbers(*metric).unwrap_or_default();
    let metric = |metric| Source::Metric(numbers(metric));
    let values = study.metrics.iter().map(metric);
    let both = parameters.chain(values);
    let mut sources: Vec<Source> = once(Source::Cases).chain(both).collect();
    sources.extend([Source::Failures, Source::Warnings]);
    let numbered = sources.par_iter().enumerate();
    let columns = numbered.map_init(Vec::new, |memory, (index, source)| {
        encoder.column(index, source, memory)
    });
    encoder.file(metadata(study, key), columns.collect::<Result<_>>()?)
}

impl Encoder<'_> {
    /// The pieces of the file with these columns.
    fn file(&self, about: Vec<KeyValue>, columns: Vec<EncodedColumn>) -> Result<Vec<Bytes>> {
        let (rows, mut offset) = (self.cases.len() as i64, MAGIC.len() as i64);
        let place_column = |(pieces, column): &EncodedColumn| {
            let column = column.metadata.clone();
            let dictionary = column.dictionary_page_offset().map(|page| page + offset);
            let data = column.data_page_offset() + offset;
            offset += pieces.iter().map(Bytes::len).sum::<usize>() as i64;
            let column = column.into_builder().set_data_page_offset(data);
            column.set_dictionary_page_offset(dictionary).build()
        };
        let placed = columns.iter().map(place_column);
        let placed_columns = placed.collect::<Result<Vec<_>>>()?;
        let sizes = placed_columns
            .iter()
            .map(ColumnChunkMetaData::uncompressed_size);
        let group = RowGroupMetaData::builder(self.schema.clone())
            .set_num_rows(rows)
            .set_total_byte_size(sizes.sum())
            .set_file_offset(MAGIC.len() as i64)
            .set_ordinal(0)
            .set_column_metadata(placed_columns)
            .build()?;
        let version = self.properties.writer_version().as_num();
        let program = Some(self.properties.created_by().to_owned());
        let file = FileMetaData::new(
            version,
            rows,
            program,
            Some(about),
            self.schema.clone(),
            None,
        );
        let mut footer = Vec::new();
        let metadata = ParquetMetaData::new(file, vec![group]);
        ParquetMetaDataWriter::new(&mut footer, &metadata).finish()?;
        let columns = columns.into_iter().flat_map(|(pieces, _)| pieces);
        let chunks = once(Bytes::from_static(MAGIC)).chain(columns);
        Ok(chunks.chain(once(footer.into())).collect())
    }

    fn column(&self, index: usize, source: &Source, memory: &mut Vec<u8>) -> Result<EncodedColumn> {
        let len = self.cases.len();
        match source {
            Source::Cases => {
                let number = |row| (self.first + self.cases.offset(row)) as i64;
                let numbers: Vec<i64> = (0..len).map(number).collect();
                self.written(index, |writer| write_all::<Int64Type>(writer, &numbers))
            }
            Source::Parameter(_, Column::Each(Cells::Numbers(numbers))) => {
                match numbers::repeat(numbers) {
                    true => self.written(index, |writer| write_numbers(writer, numbers)),
                    false => self.numbers(index, numbers, applies, memory),
                }
            }
            Source::Parameter(_, Column::Each(cells)) => {
                self.written(index, |writer| write_cells_of(writer, cells))
            }
            Source::Parameter(kind, Column::Same(value)) => self.same(index, *kind, *value),
            Source::Metric(numbers) => self.numbers(index, numbers, |x| !x.is_nan(), memory),
            // Most parts have no failures and no warnings.
            Source::Failures if self.metrics.failures().next().is_none() => self.empty(index),
            Source::Failures => self.text(index, |case| {
                let why = self.metrics.failure(case)?.to_string();
                Some(ByteArray::from(why.as_str()))
            }),
            Source::Warnings if self.metrics.warned().next().is_none() => self.empty(index),
            Source::Warnings => self.text(index, |case| {
                let warnings = self.metrics.warnings(case);
                (!warnings.is_empty()).then(|| ByteArray::from(warnings.names().as_str()))
            }),
        }
    }

    /// A column of numbers, of which those that `has` selects are cells with a value.
    fn numbers(
        &self,
        column: usize,
        numbers: &[f64],
        has: impl Fn(f64) -> bool,
        memory: &mut Vec<u8>,
    ) -> Result<EncodedColumn> {
        let cell = |x: &f64| Some(Value::Number(*x)).filter(|_| has(*x));
        let first = numbers.first().and_then(cell);
        match numbers.iter().all(|x| Value::identical(cell(x), first)) {
            true => self.same(column, Kind::Number(Range::Any), first),
            false => numbers::encode(&self.schema.columns()[column], numbers, has, memory),
        }
    }

    /// A column with one value of this kind in all rows.
    fn same(&self, column: usize, kind: Kind, value: Option<Value>) -> Result<EncodedColumn> {
        let len = self.cases.len();
        self.constant_columns.column(column, value, len, || {
            self.written(column, |writer| {
                let values = repeat_n(value, len);
                match kind {
                    Kind::Number(_) => {
                        write_cells::<DoubleType>(writer, len, values.map(|v| v?.as_f64()))
                    }
                    Kind::Whole { .. } => {
                        write_cells::<Int64Type>(writer, len, values.map(|v| integer(v?)))
                    }
                    Kind::Choice(_) => {
                        write_cells::<ByteArrayType>(writer, len, values.map(|v| name(v?)))
                    }
                }
            })
        })
    }

    /// A column of text without any.
    fn empty(&self, column: usize) -> Result<EncodedColumn> {
        self.same(column, Kind::Choice(&[]), None)
    }

    /// A column with the text of each case, if it has one.
    fn text(
        &self,
        column: usize,
        text: impl Fn(usize) -> Option<ByteArray>,
    ) -> Result<EncodedColumn> {
        let len = self.cases.len();
        self.written(column, |writer| {
            write_cells::<ByteArrayType>(writer, len, (0..len).map(text))
        })
    }

    /// A column that `write` writes.
    fn written(
        &self,
        index: usize,
        write: impl FnOnce(&mut ColumnWriter) -> Result<()>,
    ) -> Result<EncodedColumn> {
        let mut bytes = TrackedWrite::new(Vec::new());
        let pages = Box::new(SerializedPageWriter::new(&mut bytes));
        let column = self.schema.columns()[index].clone();
        let mut writer = get_column_writer(column, self.properties.clone(), pages);
        write(&mut writer)?;
        let closed = writer.close()?;
        Ok((vec![bytes.into_inner()?.into()], closed))
    }
}

/// Writes numbers of a parameter.
fn write_numbers(writer: &mut ColumnWriter, numbers: &[f64]) -> Result<()> {
    match numbers.iter().all(|x| applies(*x)) {
        true => write_all::<DoubleType>(writer, numbers),
        false => {
            let cells = numbers.iter().map(|x| applies(*x).then_some(*x));
            write_cells::<DoubleType>(writer, numbers.len(), cells)
        }
    }
}

/// Writes the values of a parameter.
fn write_cells_of(writer: &mut ColumnWriter, cells: &Cells) -> Result<()> {
    match cells {
        Cells::Numbers(numbers) => write_numbers(writer, numbers),
        Cells::Whole(numbers) => {
            let cells = numbers
                .iter()
                .map(|n| (*n != NO_WHOLE).then_some(*n as i64));
            write_cells::<Int64Type>(writer, numbers.len(), cells)
        }
        Cells::Names { names, places } => {
            let names: Vec<ByteArray> = names
                .iter()
                .map(|name| Bytes::from_static(name.as_bytes()).into())
                .collect();
            let name = |index: &u32| (*index != NO_NAME).then(|| names[*index as usize].clone());
            write_cells::<ByteArrayType>(writer, places.len(), places.iter().map(name))
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
