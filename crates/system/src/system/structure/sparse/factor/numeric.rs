//! The entries of L.

use super::panels::Panel;
use super::products::{Products, Target};
use crate::system::structure::sparse::lists::Lists;

/// The numbers of a factor.
#[derive(Debug)]
pub(super) struct Numeric<'a> {
    panels: &'a [Panel],
    numbers: &'a [usize],
    /// Place of the first entry of each column.
    starts: Vec<usize>,
    /// D.
    pivots: Vec<f64>,
    /// L D by columns.
    scaled: Vec<f64>,
    /// L by columns.
    entries: Vec<f64>,
    /// Place of each row among the entries of the first column of the present panel.
    places: Vec<usize>,
}

/// Columns of a panel that change another panel.
#[derive(Debug, Clone, Copy)]
struct Source {
    panel: usize,
    /// The first of its rows that is a column of the other panel.
    first: usize,
}

impl<'a> Numeric<'a> {
    /// The numbers of P A P^T = L D L^T for the diagonal of P A P^T and its entries (row, value) below the diagonal, by columns. Of
    /// two entries of a column of L D, the one whose row has the smaller number is divided by the pivot.
    ///
    /// All entries are A_ij less the products of the columns in their order, however the columns are grouped.
    ///
    /// # Errors
    /// The place of a pivot that is not positive.
    pub(super) fn new(
        panels: &'a [Panel],
        numbers: &'a [usize],
        diagonal: Vec<f64>,
        columns: &Lists<(usize, f64)>,
    ) -> Result<Self, usize> {
        let size = diagonal.len();
        let mut starts = vec![0; size + 1];
        let mut panel_of = vec![0; size];
        for (number, panel) in panels.iter().enumerate() {
            for column in panel.first..panel.end {
                starts[column + 1] = starts[column] + panel.entries(column);
                panel_of[column] = number;
            }
        }
        let entries = starts[size];
        let mut numeric = Numeric {
            panels,
            numbers,
            starts,
            pivots: diagonal,
            scaled: vec![0.0; entries],
            entries: vec![0.0; entries],
            places: vec![0; size],
        };
        let mut sources: Vec<Vec<Source>> = vec![Vec::new(); panels.len()];
        for (number, panel) in panels.iter().enumerate() {
            numeric.begin(panel, columns);
            let mut own = std::mem::take(&mut sources[number]);
            own.sort_unstable_by_key(|source| source.panel);
            for source in &mut own {
                source.first = numeric.subtract(panel, *source);
            }
            numeric.eliminate(panel)?;
            own.push(Source {
                panel: number,
                first: 0,
            });
            for source in own {
                if let Some(row) = panels[source.panel].rows.get(source.first) {
                    sources[panel_of[*row]].push(source);
                }
            }
        }
        Ok(numeric)
    }

    /// D, and L by columns.
    pub(super) fn finish(self) -> (Vec<f64>, Vec<f64>) {
        (self.pivots, self.entries)
    }

    /// Writes the entries of A to a panel.
    fn begin(&mut self, panel: &Panel, columns: &Lists<(usize, f64)>) {
        for (place, row) in panel.rows_of(panel.first).enumerate() {
            self.places[row] = place;
        }
        for column in panel.first..panel.end {
            let start = self.offset(panel, column);
            for (row, value) in columns.list(column) {
                self.scaled[start + self.places[*row]] = *value;
            }
        }
    }

    /// What makes a place in the first column of a panel one in all entries, for another column of it.
    fn offset(&self, panel: &Panel, column: usize) -> usize {
        // Each column begins one row lower than the one before.
        self.starts[column] - (column - panel.first)
    }

    /// Subtracts the products of the columns of another panel. Returns the first row of it that is below this panel.
    fn subtract(&mut self, panel: &Panel, source: Source) -> usize {
        let from = &self.panels[source.panel];
        let rows = &from.rows[..];
        let end = source.first + rows[source.first..].partition_point(|row| *row < panel.end);
        let first = |k: usize| self.starts[k] + from.end - 1 - k;
        for (i, row) in rows.iter().enumerate().take(end).skip(source.first) {
            for k in (from.first..from.end).map(first) {
                self.pivots[*row] -= self.entries[k + i] * self.scaled[k + i];
            }
        }
        // In a tree, nothing else changes.
        if source.first + 1 == rows.len() {
            return end;
        }
        let base = self.starts[panel.first];
        let offset = |row: &usize| self.offset(panel, *row) - base;
        let offsets: Vec<usize> = rows[source.first..end].iter().map(offset).collect();
        let (scaled, entries) = self.scaled.split_at_mut(base);
        let products = Products {
            firsts: &(from.first..from.end).map(first).collect::<Vec<_>>(),
            scaled,
            entries: &self.entries,
            rows,
            numbers: self.numbers,
        };
        let target = Target {
            entries,
            offsets: &offsets,
            places: &self.places,
        };
        products.subtract(source.first..end, target);
        end
    }

    /// Eliminates the columns of a panel.
    fn eliminate(&mut self, panel: &Panel) -> Result<(), usize> {
        for column in panel.first..panel.end {
            let start = self.starts[column];
            let rows = || panel.rows_of(column).map(|row| self.numbers[row]);
            let number = self.numbers[column];
            let rising = rows().all(|other| other > number);
            let (before, own) = self.scaled.split_at_mut(start);
            let own = &mut own[..panel.entries(column)];
            for k in panel.first..column {
                let at = self.starts[k] + column - k - 1;
                let (l, a) = (self.entries[at], before[at]);
                self.pivots[column] -= l * a;
                let below = at + 1..at + 1 + own.len();
                let others = own.iter_mut().zip(&before[below.clone()]);
                if rising {
                    for (entry, b) in others {
                        *entry -= b * l;
                    }
                    continue;
                }
                let divided = &self.entries[below];
                for (((entry, b), m), other) in others.zip(divided).zip(rows()) {
                    *entry -= if other < number { m * a } else { b * l };
                }
            }
            let pivot = self.pivots[column];
            if !(pivot > 0.0 && pivot.is_finite()) {
                return Err(column);
            }
            for (l, a) in self.entries[start..].iter_mut().zip(own) {
                *l = *a / pivot;
            }
        }
        Ok(())
    }
}
