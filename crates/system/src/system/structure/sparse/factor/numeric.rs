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
    /// By columns: an entry is one of L D until its row is eliminated, and then one of L. So the factor is in memory once.
    entries: Vec<f64>,
    /// Place of each row among the entries of the first column of the present panel.
    places: Vec<usize>,
    /// L of the columns of another panel in the rows that are columns of the present one.
    divided: Vec<f64>,
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
        columns: Lists<(usize, f64)>,
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
        let mut numeric = Numeric {
            panels,
            numbers,
            entries: vec![0.0; starts[size]],
            starts,
            pivots: diagonal,
            places: vec![0; size],
            divided: Vec::new(),
        };
        numeric.begin(columns);
        let mut sources: Vec<Vec<Source>> = vec![Vec::new(); panels.len()];
        for (number, panel) in panels.iter().enumerate() {
            numeric.place(panel);
            let mut panel_sources = std::mem::take(&mut sources[number]);
            panel_sources.sort_unstable_by_key(|source| source.panel);
            for source in &mut panel_sources {
                source.first = numeric.subtract(panel, *source);
            }
            numeric.eliminate(panel)?;
            panel_sources.push(Source {
                panel: number,
                first: 0,
            });
            for source in panel_sources {
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

    /// Writes the entries of A.
    fn begin(&mut self, columns: Lists<(usize, f64)>) {
        for panel in self.panels {
            self.place(panel);
            for column in panel.first..panel.end {
                let start = self.offset(panel, column);
                for (row, value) in columns.list(column) {
                    self.entries[start + self.places[*row]] = *value;
                }
            }
        }
    }

    /// Finds the places of the rows of a panel.
    fn place(&mut self, panel: &Panel) {
        for (position, row) in panel.rows_of(panel.first).enumerate() {
            self.places[row] = position;
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
        let columns = source.first..end;
        let first = |k: usize| self.starts[k] + from.end - 1 - k;
        let firsts: Vec<usize> = (from.first..from.end).map(first).collect();
        let pivots = from.first..from.end;
        let mut divided = std::mem::take(&mut self.divided);
        for (first, k) in firsts.iter().zip(pivots.clone()) {
            let (pivot, first) = (self.pivots[k], first + columns.start);
            for (row, a) in rows[columns.clone()].iter().zip(&self.entries[first..]) {
                let l = a / pivot;
                self.pivots[*row] -= l * a;
                divided.push(l);
            }
        }
        // In a tree, nothing else changes.
        if source.first + 1 < rows.len() {
            let base = self.starts[panel.first];
            let offset = |row: &usize| self.offset(panel, *row) - base;
            let offsets: Vec<usize> = rows[columns.clone()].iter().map(offset).collect();
            let (scaled, entries) = self.entries.split_at_mut(base);
            let products = Products {
                firsts: &firsts,
                scaled,
                columns: columns.clone(),
                divided: &divided,
                pivots: &self.pivots[pivots],
                rows,
                numbers: self.numbers,
            };
            let target = Target {
                entries,
                offsets: &offsets,
                places: &self.places,
            };
            products.subtract(target);
        }
        for (first, l) in firsts.iter().zip(divided.chunks_exact(columns.len())) {
            self.entries[first + columns.start..][..columns.len()].copy_from_slice(l);
        }
        divided.clear();
        self.divided = divided;
        end
    }

    /// Eliminates the columns of a panel.
    fn eliminate(&mut self, panel: &Panel) -> Result<(), usize> {
        for column in panel.first..panel.end {
            let start = self.starts[column];
            let rows = || panel.rows_of(column).map(|row| self.numbers[row]);
            let number = self.numbers[column];
            let rising = rows().all(|other| other > number);
            let (before, panel_entries) = self.entries.split_at_mut(start);
            let column_entries = &mut panel_entries[..panel.entries(column)];
            for k in panel.first..column {
                let at = self.starts[k] + column - k - 1;
                let (a, pivot) = (before[at], self.pivots[k]);
                let l = a / pivot;
                self.pivots[column] -= l * a;
                before[at] = l;
                let others = column_entries.iter_mut().zip(&before[at + 1..]);
                if rising {
                    for (entry, b) in others {
                        *entry -= b * l;
                    }
                    continue;
                }
                for ((entry, b), other) in others.zip(rows()) {
                    *entry -= if other < number { b / pivot * a } else { b * l };
                }
            }
            let pivot = self.pivots[column];
            if !(pivot > 0.0 && pivot.is_finite()) {
                return Err(column);
            }
        }
        Ok(())
    }
}
