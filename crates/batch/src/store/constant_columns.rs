//! Columns with one value in all rows: encoded once, then copied into further parts.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use bytes::Bytes;
use parquet::column::writer::ColumnCloseResult;
use parquet::errors::Result;

use slipgap_problem::problem::numbers::parameter::Value;

/// The bytes of a column, in pieces, and its entry in the footer.
pub type EncodedColumn = (Vec<Bytes>, ColumnCloseResult);

/// The last encoding of each column.
#[derive(Debug, Default)]
pub struct ConstantColumns(Mutex<BTreeMap<usize, Entry>>);

/// The value in all rows, the number of rows, and the column.
type Entry = (Option<Value>, usize, EncodedColumn);

impl ConstantColumns {
    /// The column at `place`, with `value` in `len` rows.
    pub fn column(
        &self,
        index: usize,
        value: Option<Value>,
        len: usize,
        encode: impl FnOnce() -> Result<EncodedColumn>,
    ) -> Result<EncodedColumn> {
        let mut columns = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        match columns.get(&index) {
            Some((last, rows, column)) if *rows == len && Value::identical(*last, value) => {
                Ok(column.clone())
            }
            _ => {
                let column = encode()?;
                columns.insert(index, (value, len, column.clone()));
                Ok(column)
            }
        }
    }
}
