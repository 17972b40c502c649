//! Products of the entries of a panel, the loop in which a factor spends its time.

use crate::lane::Lane;
use slipgap_contact::for_widest;
use std::ops::Range;

/// Rows and columns of a tile, whose entries stay in the registers of the processor.
const ROWS: usize = 8;
const COLUMNS: usize = 4;

/// The columns of a panel.
#[derive(Debug)]
pub(super) struct Products<'a> {
    /// For each column, the place of its entry in the first row below the panel.
    pub(super) firsts: &'a [usize],
    /// L D by columns.
    pub(super) scaled: &'a [f64],
    /// The rows that are columns of the target, as places in `rows`.
    pub(super) columns: Range<usize>,
    /// L in these rows, by columns.
    pub(super) divided: &'a [f64],
    /// D of the columns.
    pub(super) pivots: &'a [f64],
    /// The rows below the panel.
    pub(super) rows: &'a [usize],
    /// The number of each row.
    pub(super) numbers: &'a [usize],
}

/// What products are subtracted from.
#[derive(Debug)]
pub(super) struct Target<'a> {
    pub(super) entries: &'a mut [f64],
    /// What each column adds to the places of its rows.
    pub(super) offsets: &'a [usize],
    /// The places of all rows.
    pub(super) places: &'a [usize],
}

impl Products<'_> {
    /// Subtracts the products of the rows that are columns of the target, and all rows below each.
    pub(super) fn subtract(&self, mut from: Target) {
        subtract(self, &mut from);
    }

    /// The place of each column in its first row below the panel, and L of the rows from `column` on.
    #[inline(always)]
    fn from(&self, column: usize) -> impl Iterator<Item = (&usize, &[f64])> {
        let rows = self.divided.chunks_exact(self.columns.len());
        let from = column - self.columns.start;
        self.firsts.iter().zip(rows.map(move |l| &l[from..]))
    }

    /// Subtracts the products of C rows from `column` on and R rows from `row` on. Each entry loses one product after the other.
    #[inline(always)]
    fn tile<const R: usize, const C: usize>(
        &self,
        [row, column]: [usize; 2],
        offsets: &[usize],
        to: &mut Target,
    ) {
        let rows = &self.rows[row..row + R];
        let columns = &self.rows[column..column + C];
        let offsets = &offsets[..C];
        let mut places = [0; R];
        let mut numbers = [0; R];
        for (i, row) in rows.iter().enumerate() {
            (places[i], numbers[i]) = (to.places[*row], self.numbers[*row]);
        }
        let mut sums = [[0.0; R]; C];
        let mut rising = true;
        for (j, sums) in sums.iter_mut().enumerate() {
            let number = self.numbers[columns[j]];
            for (i, sum) in sums.iter_mut().enumerate() {
                *sum = to.entries[offsets[j] + places[i]];
                rising &= number < numbers[i];
            }
        }
        if rising {
            self.subtract_rising([row, column], &mut sums);
        } else {
            self.subtract_any([row, column], &mut sums);
        }
        for (offset, sums) in offsets.iter().zip(&sums) {
            for (entry, sum) in places.iter().zip(sums) {
                to.entries[offset + entry] = *sum;
            }
        }
    }

    /// Subtracts products of rows whose numbers are larger than those of the columns.
    #[inline(always)]
    fn subtract_rising<const R: usize, const C: usize>(
        &self,
        [row, column]: [usize; 2],
        sums: &mut [[f64; R]; C],
    ) {
        for (first, l) in self.from(column) {
            let a = self.scaled[first + row..].first_chunk::<R>();
            let (Some(a), Some(l)) = (a, l.first_chunk::<C>()) else {
                return;
            };
            for (sums, l) in sums.iter_mut().zip(l) {
                let products = Lane(*a) * *l;
                *sums = (Lane(*sums) - products).0;
            }
        }
    }

    /// Subtracts products of rows of any numbers.
    fn subtract_any<const R: usize, const C: usize>(
        &self,
        [row, column]: [usize; 2],
        sums: &mut [[f64; R]; C],
    ) {
        for ((first, l), pivot) in self.from(column).zip(self.pivots) {
            for ((j, l), sums) in (column..).zip(l).zip(sums.iter_mut()) {
                for (i, sum) in (row..).zip(sums) {
                    let smaller = self.numbers[self.rows[i]] < self.numbers[self.rows[j]];
                    let b = self.scaled[first + i];
                    *sum -= match smaller {
                        true => b / pivot * self.scaled[first + j],
                        false => l * b,
                    };
                }
            }
        }
    }

    /// Subtracts the products of C rows and all rows below them.
    #[inline(always)]
    fn stripe<const C: usize>(&self, column: usize, offsets: &[usize], to: &mut Target) {
        for j in 0..C {
            for row in column + j + 1..column + C {
                self.tile::<1, 1>([row, column + j], &offsets[j..], to);
            }
        }
        let mut row = column + C;
        while row + ROWS <= self.rows.len() {
            self.tile::<ROWS, C>([row, column], offsets, to);
            row += ROWS;
        }
        if row + ROWS / 2 <= self.rows.len() {
            self.tile::<{ ROWS / 2 }, C>([row, column], offsets, to);
            row += ROWS / 2;
        }
        for row in row..self.rows.len() {
            self.tile::<1, C>([row, column], offsets, to);
        }
    }
}

for_widest! {
    fn subtract(products: &Products, from: &mut Target) {
        let mut offsets = from.offsets;
        let columns = &products.columns;
        let mut column = columns.start;
        while column + COLUMNS <= columns.end {
            products.stripe::<COLUMNS>(column, offsets, from);
            column += COLUMNS;
            offsets = &offsets[COLUMNS..];
        }
        match columns.end - column {
            3 => products.stripe::<3>(column, offsets, from),
            2 => products.stripe::<2>(column, offsets, from),
            1 => products.stripe::<1>(column, offsets, from),
            _ => {}
        }
    }
}

/// The sums of K of C columns, from `from` on, times x over these rows.
#[inline(always)]
pub(super) fn products<const L: usize, const C: usize, const K: usize>(
    rows: &[u32],
    values: &[[f64; C]],
    from: usize,
    x: &[Lane<L>],
) -> [Lane<L>; K] {
    let (first_rows, rows) = rows.as_rchunks::<PARTS>();
    let (first_values, values) = values.as_rchunks::<PARTS>();
    let mut parts = [[Lane::splat(0.0); K]; PARTS];
    let add = |sums: &mut [Lane<L>; K], row: &u32, values: &[f64; C]| {
        let x = x[*row as usize];
        for (sum, l) in sums.iter_mut().zip(&values[from..]) {
            *sum = *sum + x * *l;
        }
    };
    for (rows, values) in rows.iter().zip(values).rev() {
        for ((part, row), values) in parts.iter_mut().zip(rows).zip(values) {
            add(part, row, values);
        }
    }
    let mut sums = [Lane::splat(0.0); K];
    let [a, b, c, d] = parts;
    for (k, sum) in sums.iter_mut().enumerate() {
        *sum = (a[k] + b[k]) + (c[k] + d[k]);
    }
    for (row, values) in first_rows.iter().zip(first_values).rev() {
        add(&mut sums, row, values);
    }
    sums
}

/// Parts of a sum, which do not wait for one another.
pub(super) const PARTS: usize = 4;
