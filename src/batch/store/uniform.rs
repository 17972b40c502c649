//! Columns in which all cases of a part have one value: made once, and put into one part after the other as they are.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use bytes::Bytes;
use parquet::column::writer::ColumnCloseResult;
use parquet::errors::Result;

use crate::problem::parameter::Value;

/// A column as it stands in a part, and what the part's footer says of it.
pub type Made = (Bytes, ColumnCloseResult);

/// Of each column the last.
#[derive(Debug, Default)]
pub struct Uniform(Mutex<BTreeMap<usize, Kept>>);

/// The value in all rows, their number, and the column.
type Kept = (Option<Value>, usize, Made);

impl Uniform {
    /// The column at `place`, `value` in `len` rows.
    pub fn column(
        &self,
        place: usize,
        value: Option<Value>,
        len: usize,
        make: impl FnOnce() -> Result<Made>,
    ) -> Result<Made> {
        let mut columns = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        match columns.get(&place) {
            Some((kept, rows, made)) if *rows == len && Value::identical(*kept, value) => {
                Ok(made.clone())
            }
            _ => {
                let made = make()?;
                columns.insert(place, (value, len, made.clone()));
                Ok(made)
            }
        }
    }
}
