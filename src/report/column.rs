//! A column of numbers, as small as it can be kept without loss: one value for all rows, places in a list of the values
//! that occur, or the doubles themselves.

use crate::figures::base64;
use std::collections::HashMap;
use std::io::{self, Write};

/// Most values of a list.
const MOST_LISTED: usize = 1 << 14;

/// Rows of a block. A multiple of 3: the text of a block ends without padding, so that the page can read it alone.
const BLOCK: usize = 6144;

/// The numbers of a column; NaN where one is undefined.
#[derive(Debug)]
pub struct Column {
    len: usize,
    /// In order of appearance; empty where they are too many.
    values: Vec<f64>,
    places: HashMap<u64, u16>,
    /// For each row the place of its value; empty while there is one value.
    codes: Vec<u16>,
    /// All rows, where the values are too many for a list.
    plain: Vec<f64>,
}

impl Column {
    /// No row yet.
    pub fn new() -> Column {
        Column {
            len: 0,
            values: Vec::new(),
            places: HashMap::new(),
            codes: Vec::new(),
            plain: Vec::new(),
        }
    }

    /// Adds a row.
    pub fn push(&mut self, x: f64) {
        if !self.plain.is_empty() {
            self.plain.push(x);
        } else if let Some(place) = self.place(x) {
            if self.values.len() > 1 {
                // Rows before the second value have the first.
                self.codes.resize(self.len, 0);
                self.codes.push(place);
            }
        } else {
            self.plain = (0..self.len).map(|row| self.at(row)).collect();
            self.plain.push(x);
            (self.values, self.places, self.codes) = Default::default();
        }
        self.len += 1;
    }

    /// The place of a value in the list, which takes it up if it has room.
    fn place(&mut self, x: f64) -> Option<u16> {
        let next = u16::try_from(self.values.len()).ok()?;
        if let Some(place) = self.places.get(&x.to_bits()) {
            return Some(*place);
        }
        if self.values.len() >= MOST_LISTED {
            return None;
        }
        self.places.insert(x.to_bits(), next);
        self.values.push(x);
        Some(next)
    }

    /// The number in a row.
    pub fn at(&self, row: usize) -> f64 {
        match self.plain.get(row) {
            Some(x) => *x,
            None => self.values[self.codes.get(row).map_or(0, |place| usize::from(*place))],
        }
    }

    /// Forgets all rows but the first `len`.
    pub fn truncate(&mut self, len: usize) {
        let mut kept = Column::new();
        (0..self.len.min(len)).for_each(|row| kept.push(self.at(row)));
        *self = kept;
    }

    /// Bytes that a row takes on the page: 8 for a double, 2 or 1 for a place, 0 where all rows have one value.
    pub fn width(&self) -> usize {
        let listed = match self.values.len() {
            _ if !self.plain.is_empty() => return 8,
            0 | 1 => 0,
            2..=256 => 1,
            _ => 2,
        };
        // A list as long as the column saves nothing.
        let smaller = listed * self.len + 8 * self.values.len() < 8 * self.len;
        if listed == 0 || smaller { listed } else { 8 }
    }

    /// Bytes that the column takes on the page, before they are written as text.
    pub fn bytes(&self) -> usize {
        let width = self.width();
        let list = if width < 8 { self.values.len() } else { 0 };
        width * self.len + 8 * list
    }

    /// The list of values as base64 of little-endian doubles; empty where the rows are doubles.
    pub fn list(&self) -> String {
        let values = if self.width() < 8 {
            &self.values[..]
        } else {
            &[]
        };
        let bytes: Vec<u8> = values.iter().flat_map(|x| x.to_le_bytes()).collect();
        base64::text(&bytes)
    }

    /// Writes the rows as base64 of little-endian numbers of [`Column::width`] bytes.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        let (width, mut bytes) = (self.width(), Vec::new());
        if width == 0 {
            return Ok(());
        }
        for from in (0..self.len).step_by(BLOCK) {
            bytes.clear();
            for row in from..(from + BLOCK).min(self.len) {
                match width {
                    8 => bytes.extend(self.at(row).to_le_bytes()),
                    // A place of one byte is the first of two, little-endian.
                    _ => bytes.extend(&self.codes[row].to_le_bytes()[..width]),
                }
            }
            out.write_all(base64::text(&bytes).as_bytes())?;
        }
        Ok(())
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
    fn every_form_keeps_every_bit() {
        let most = MOST_LISTED as u64;
        // One value; two signs of zero; undefined ones; 257 values; as many as a list holds, and one more.
        let forms: [(u64, u64, usize); 5] = [
            (1, 70_000, 0),
            (256, 70_000, 1),
            (257, 70_000, 2),
            (most, 70_000, 2),
            (most + 1, 70_000, 8),
        ];
        for (distinct, rows, width) in forms {
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
    fn a_list_that_saves_nothing_is_not_written() {
        let column = column((0..100).map(f64::from));
        assert_eq!((column.width(), column.bytes()), (8, 800));
        assert_eq!(column.list(), "");
    }

    #[test]
    fn what_is_forgotten_leaves_the_first_rows() {
        let mut column = column((0..20_000).map(|i| f64::from(i) / 3.0));
        column.truncate(1000);
        assert_eq!(column.bytes(), 8000);
        assert!((0..1000).all(|row| column.at(row) == row as f64 / 3.0));
    }
}
