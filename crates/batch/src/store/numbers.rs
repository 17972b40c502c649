//! Columns of numbers that mostly differ from case to case, without a dictionary: as streams of bytes.

use parquet::basic::{Compression, Encoding};
use parquet::column::page::{CompressedPage, Page, PageWriter};
use parquet::column::writer::ColumnCloseResult;
use parquet::errors::Result;
use parquet::file::metadata::ColumnChunkMetaData;
use parquet::file::reader::RowGroupReader;
use parquet::file::statistics::{Statistics, ValueStatistics};
use parquet::file::writer::{SerializedPageWriter, TrackedWrite};
use parquet::schema::types::ColumnDescPtr;

use super::constant_columns::EncodedColumn;
use super::streams::{joined, packed, push_varint, split};
use bytes::Bytes;
use std::borrow::Cow;
use std::io::{self, Write};

/// The numbers that decide whether they get a dictionary.
const SAMPLE: usize = 1 << 12;

/// Bytes of the head of a page, at most.
const HEAD: usize = 64;

/// Whether the numbers repeat so often, and not in runs, that a dictionary makes them smaller than streams of bytes.
pub fn repeat(numbers: &[f64]) -> bool {
    let mut bits: Vec<u64> = numbers.iter().take(SAMPLE).map(|x| x.to_bits()).collect();
    let changes = bits.windows(2).filter(|pair| pair[0] != pair[1]).count();
    // Those of an axis mostly rise or fall.
    if 16 * changes < bits.len() || bits.is_sorted() || bits.iter().rev().is_sorted() {
        return false;
    }
    let count = bits.len();
    bits.sort_unstable();
    bits.dedup();
    2 * bits.len() <= count
}

/// The column of these numbers, of which those that `has` selects are cells with a value. `bytes` is memory that the next column
/// may have again.
pub fn encode(
    column: &ColumnDescPtr,
    numbers: &[f64],
    has: impl Fn(f64) -> bool,
    bytes: &mut Vec<u8>,
) -> Result<EncodedColumn> {
    let mut values = Cow::Borrowed(numbers);
    // In blocks without branches, several numbers at a time.
    let has_value = |block: &[f64]| block.iter().fold(true, |so_far, x| so_far & has(*x));
    let levels = match numbers.chunks(64).all(has_value) {
        true => levels(&[true], numbers.len()),
        false => {
            values.to_mut().retain(|x| has(*x));
            let cells: Vec<bool> = numbers.iter().map(|x| has(*x)).collect();
            levels(&cells, 1)
        }
    };
    let start = levels.len();
    bytes.resize(start + 8 * values.len(), 0);
    bytes[..start].copy_from_slice(&levels);
    split(&values, &mut bytes[start..]);
    let data = Bytes::from(packed(bytes, start, values.len()));
    let data_page = Page::DataPage {
        buf: data.clone(),
        num_values: numbers.len() as u32,
        encoding: Encoding::BYTE_STREAM_SPLIT,
        def_level_encoding: Encoding::RLE,
        rep_level_encoding: Encoding::RLE,
        statistics: None,
    };
    let page = CompressedPage::new(data_page, bytes.len());
    let mut out = TrackedWrite::new(Beginning::default());
    let written = SerializedPageWriter::new(&mut out).write_page(page)?;
    let mut head = out.into_inner()?.0;
    head.truncate(written.compressed_size - data.len());
    let metadata = ColumnChunkMetaData::builder(column.clone())
        .set_compression(Compression::SNAPPY)
        .set_encodings(vec![Encoding::RLE, Encoding::BYTE_STREAM_SPLIT])
        .set_total_compressed_size(written.compressed_size as i64)
        .set_total_uncompressed_size(written.uncompressed_size as i64)
        .set_num_values(numbers.len() as i64)
        .set_data_page_offset(0)
        .set_statistics(statistics(&values, numbers.len() - values.len()))
        .build()?;
    let closed = ColumnCloseResult {
        bytes_written: written.bytes_written,
        rows_written: numbers.len() as u64,
        metadata,
        bloom_filter: None,
        column_index: None,
        offset_index: None,
    };
    Ok((vec![head.into(), data], closed))
}

/// The numbers of a column of so many, if [`encode`] has made it of cells that all have a value: faster than by its readers.
pub fn decode(group: &dyn RowGroupReader, column: usize, count: usize) -> Result<Option<Vec<f64>>> {
    let mut encodings = group.metadata().column(column).encodings();
    if !encodings.any(|encoding| encoding == Encoding::BYTE_STREAM_SPLIT) {
        return Ok(None);
    }
    let mut pages = group.get_column_page_reader(column)?;
    let (page, end) = (pages.get_next_page()?, pages.get_next_page()?);
    let levels = levels(&[true], count);
    Ok(match (&page, end) {
        (Some(page), None) if page.encoding() == Encoding::BYTE_STREAM_SPLIT => {
            let streams = page.buffer().strip_prefix(&levels[..]);
            streams
                .filter(|streams| streams.len() == 8 * count)
                .map(joined)
        }
        _ => None,
    })
}

/// Whether cells have a value, each of them so many `times`, after the length in bytes: as runs of equal ones, or a bit for each
/// if that is shorter.
fn levels(cells: &[bool], times: usize) -> Vec<u8> {
    let mut levels = vec![0; 4];
    for run in cells.chunk_by(|a, b| a == b) {
        push_varint(&mut levels, (run.len() * times) << 1);
        levels.push(u8::from(run[0]));
    }
    let groups = cells.len().div_ceil(8);
    if groups < levels.len() - 4 && times == 1 {
        levels.truncate(4);
        push_varint(&mut levels, groups << 1 | 1);
        let bits = |group: &[bool]| {
            group
                .iter()
                .rev()
                .fold(0, |bits, has| bits << 1 | u8::from(*has))
        };
        levels.extend(cells.chunks(8).map(bits));
    }
    let len = levels.len() as u32 - 4;
    levels[..4].copy_from_slice(&len.to_le_bytes());
    levels
}

/// The first bytes that are written: the head of a page, without a copy of its data.
#[derive(Default)]
struct Beginning(Vec<u8>);

impl Write for Beginning {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let room = HEAD.saturating_sub(self.0.len());
        self.0.extend_from_slice(&bytes[..bytes.len().min(room)]);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// The least and the greatest of the values, none of which is NaN, and the number of cells without one.
fn statistics(values: &[f64], without: usize) -> Statistics {
    let (mut least, mut greatest) = ([f64::INFINITY; 8], [f64::NEG_INFINITY; 8]);
    for chunk in values.chunks(8) {
        for ((least, greatest), x) in least.iter_mut().zip(&mut greatest).zip(chunk) {
            *least = if *x < *least { *x } else { *least };
            *greatest = if *x > *greatest { *x } else { *greatest };
        }
    }
    let least = least.into_iter().fold(f64::INFINITY, f64::min);
    let greatest = greatest.into_iter().fold(f64::NEG_INFINITY, f64::max);
    // Zeros are equal with either sign: both are between these.
    let some = (!values.is_empty()).then_some((
        if least == 0.0 { -0.0 } else { least },
        if greatest == 0.0 { 0.0 } else { greatest },
    ));
    let (least, greatest) = some.unzip();
    let statistics = ValueStatistics::new(least, greatest, None, Some(without as u64), false)
        .with_nan_count(Some(0));
    Statistics::from(statistics.with_backwards_compatible_min_max(true))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dictionary_is_for_numbers_that_repeat_but_not_in_runs() {
        let of = |number: &dyn Fn(usize) -> f64, len: usize| {
            let numbers: Vec<f64> = (0..len).map(number).collect();
            repeat(&numbers)
        };
        // The fast axis of a grid, and the slow one.
        assert!(of(&|i| (i % 100) as f64, 16_384) && of(&|i| (i % 3) as f64, 9));
        assert!(!of(&|i| (i / 100) as f64, 16_384));
        // All different: rising, falling, and in any order.
        assert!(!of(&|i| i as f64, 16_384) && !of(&|i| -(i as f64), 16_384));
        assert!(!of(
            &|i| (i as f64 * 0.618_033_988_749_894_9).fract(),
            16_384
        ));
        assert!(!of(&|_| 1.0, 1) && !of(&|_| 1.0, 0));
    }
}
