//! A compressed column of numbers: one value for all rows, indices into a list of the values, or numbers.

use crate::report::decimal;
use std::collections::HashMap;

/// Largest number of values in a list.
const MOST_LISTED: usize = 1 << 14;

/// The numbers of a column; NaN if one is undefined.
#[derive(Debug)]
pub struct Column {
    len: usize,
    /// The list of values in order of appearance; empty if there are too many.
    values: Vec<f64>,
    /// Index in the list by the bits of a value.
    indices: HashMap<u64, u16>,
    /// The index of each row; empty while there is one value.
    codes: Vec<u16>,
    /// All rows, if there are too many values for a list.
    doubles: Vec<f64>,
}

impl Column {
    /// No row yet.
    pub fn new() -> Column {
        Column {
            len: 0,
            values: Vec::new(),
            indices: HashMap::new(),
            codes: Vec::new(),
            doubles: Vec::new(),
        }
    }

    /// Adds a row.
    pub fn push(&mut self, x: f64) {
        if !self.doubles.is_empty() {
            self.doubles.push(x);
        } else if let Some(index) = self.index(x) {
            if self.values.len() > 1 {
                // All rows before the second value have the first one.
                self.codes.resize(self.len, 0);
                self.codes.push(index);
            }
        } else {
            self.doubles = (0..self.len).map(|row| self.at(row)).collect();
            self.doubles.push(x);
            (self.values, self.indices, self.codes) = Default::default();
        }
        self.len += 1;
    }

    /// The index of a value in the list, which is extended if it is not full.
    fn index(&mut self, x: f64) -> Option<u16> {
        let next = u16::try_from(self.values.len()).ok()?;
        if let Some(index) = self.indices.get(&x.to_bits()) {
            return Some(*index);
        }
        if self.values.len() >= MOST_LISTED {
            return None;
        }
        self.indices.insert(x.to_bits(), next);
        self.values.push(x);
        Some(next)
    }

    /// The number in a row.
    pub fn at(&self, row: usize) -> f64 {
        match self.doubles.get(row) {
            Some(x) => *x,
            None => self.values[self.codes.get(row).map_or(0, |index| usize::from(*index))],
        }
    }

    /// Removes all rows except the first `len`.
    pub fn truncate(&mut self, len: usize) {
        let mut first = Column::new();
        (0..self.len.min(len)).for_each(|row| first.push(self.at(row)));
        *self = first;
    }

    /// Bytes of a row on the page: 8 for a double, 2 or 1 for an index, 0 if all rows have one value.
    pub fn width(&self) -> usize {
        let listed = match self.values.len() {
            _ if !self.doubles.is_empty() => return 8,
            0 | 1 => 0,
            2..=256 => 1,
            _ => 2,
        };
        // A list as long as the column makes it no smaller.
        let smaller = listed * self.len + 8 * self.values.len() < 8 * self.len;
        if listed == 0 || smaller { listed } else { 8 }
    }

    /// Bytes of the column on the page, before they are encoded as text.
    pub fn bytes(&self) -> usize {
        let width = self.width();
        let list = if width < 8 { self.values.len() } else { 0 };
        width * self.len + 8 * list
    }

    /// The same column with values of six significant digits.
    pub fn rounded(&self) -> Column {
        let mut column = Column::new();
        (0..self.len).for_each(|row| column.push(decimal::rounded(self.at(row))));
        column
    }

    /// Number of values in the list on the page.
    pub fn listed(&self) -> usize {
        if self.width() < 8 {
            self.values.len()
        } else {
            0
        }
    }

    /// Adds the list of values and then the rows: numbers as little-endian doubles, or as [`decimal`]s if they are rounded, and
    /// indices in the list as little-endian numbers of [`Column::width`] bytes.
    pub fn encode(&self, rounded: bool, out: &mut Vec<u8>) {
        let width = self.width();
        let numbers = if width == 8 {
            (0..self.len).map(|row| self.at(row)).collect()
        } else {
            self.values.clone()
        };
        match rounded {
            true => decimal::encode(&numbers, out),
            false => numbers.iter().for_each(|x| out.extend(x.to_le_bytes())),
        }
        if width == 1 || width == 2 {
            // An index of one byte is the first of two, little-endian.
            let codes = self.codes.iter();
            codes.for_each(|index| out.extend(&index.to_le_bytes()[..width]));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn column(values: impl Iterator<Item = f64>) -> Column {
        let mut column = Column::new();
        values.for_each(|x| column.push(x));
        column
    }

    #[test]
    fn every_encoding_keeps_every_bit() {
        let most = MOST_LISTED as u64;
        // Numbers of values: one; a byte full; one more; a list full; one more. Zeros of both signs and NaN are among them.
        let encodings: [(u64, u64, usize); 5] = [
            (1, 70_000, 0),
            (256, 70_000, 1),
            (257, 70_000, 2),
            (most, 70_000, 2),
            (most + 1, 70_000, 8),
        ];
        for (distinct, rows, width) in encodings {
            let value = |row: u64| match row * 7919 % distinct {
                1 => f64::NAN,
                2 => 0.0,
                3 => -0.0,
                k => (k as f64 + 0.5).sqrt(),
            };
            let column = column((0..rows).map(value));
            assert_eq!(column.width(), width, "{distinct} values");
            let same = |row: u64| column.at(row as usize).to_bits() == value(row).to_bits();
            assert!((0..rows).all(same), "{distinct} values");
        }
    }

    #[test]
    fn a_list_is_not_written_if_doubles_are_smaller() {
        let column = column((0..100).map(f64::from));
        assert_eq!((column.width(), column.bytes()), (8, 800));
        assert_eq!(column.listed(), 0);
    }

    #[test]
    fn a_shortened_column_has_its_first_rows() {
        let mut column = column((0..20_000).map(|i| f64::from(i) / 3.0));
        column.truncate(1000);
        assert_eq!(column.bytes(), 8000);
        assert!((0..1000).all(|row| column.at(row) == row as f64 / 3.0));
    }
}
