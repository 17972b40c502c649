//! Sparse symmetric matrices.

use nalgebra::DMatrix;
use std::sync::Arc;

/// Entries (column, value), which rise.
type Row = Vec<(usize, f64)>;

/// A sparse symmetric matrix: the entries on and below the diagonal. Copies share them until one is changed.
#[derive(Debug, Clone)]
pub struct Symmetric {
    size: usize,
    entries: Entries,
}

#[derive(Debug, Clone)]
enum Entries {
    None,
    /// Each row.
    Rows(Arc<Vec<Row>>),
    Packed(Arc<Packed>),
}

/// The rows one behind the other, in half of the memory: 12 bytes for an entry. There are fewer than 2^32.
#[derive(Debug, Clone, Default)]
struct Packed {
    /// Where each row ends.
    ends: Vec<u32>,
    columns: Vec<u32>,
    values: Vec<f64>,
}

impl Packed {
    /// Adds a row behind the last one.
    fn push(&mut self, row: &Row) {
        if self.columns.len() + row.len() > self.columns.capacity() {
            // Doubling would leave much of the memory unused.
            let room = row.len() + self.columns.len() / 8 + 16;
            self.columns.reserve_exact(room);
            self.values.reserve_exact(room);
        }
        self.columns
            .extend(row.iter().map(|(column, _)| *column as u32));
        self.values.extend(row.iter().map(|(_, value)| *value));
        self.ends.push(self.values.len() as u32);
    }

    fn matrix(mut self) -> Symmetric {
        self.columns.shrink_to_fit();
        self.values.shrink_to_fit();
        Symmetric {
            size: self.ends.len(),
            entries: Entries::Packed(Arc::new(self)),
        }
    }

    /// The entries of each row.
    fn rows(&self) -> impl Iterator<Item = impl Iterator<Item = (usize, f64)>> {
        let starts = std::iter::once(&0).chain(&self.ends);
        starts.zip(&self.ends).map(|(start, end)| {
            let entries_of_row = *start as usize..*end as usize;
            let columns = self.columns[entries_of_row.clone()]
                .iter()
                .map(|column| *column as usize);
            columns.zip(self.values[entries_of_row].iter().copied())
        })
    }
}

impl PartialEq for Symmetric {
    fn eq(&self, other: &Symmetric) -> bool {
        let is_same = match (&self.entries, &other.entries) {
            (Entries::Rows(rows), Entries::Rows(other)) => Arc::ptr_eq(rows, other),
            (Entries::Packed(packed), Entries::Packed(other)) => Arc::ptr_eq(packed, other),
            _ => false,
        };
        self.size == other.size && (is_same || self.entries().eq(other.entries()))
    }
}

/// Adds a value to an entry of a row.
fn add(row: &mut Row, column: usize, value: f64) {
    // Most matrices are filled by rising columns.
    let last = row.last().is_none_or(|(last, _)| *last < column);
    let position = if last {
        Err(row.len())
    } else {
        row.binary_search_by_key(&column, |(j, _)| *j)
    };
    match position {
        Ok(index) => row[index].1 += value,
        Err(index) => {
            if row.len() == row.capacity() {
                // Doubling would leave half of the memory unused.
                row.reserve_exact(4 + row.len() / 4);
            }
            row.insert(index, (column, 0.0 + value));
        }
    }
}

impl Symmetric {
    /// A matrix of zeros.
    pub fn zeros(size: usize) -> Symmetric {
        Symmetric {
            size,
            entries: Entries::None,
        }
    }

    /// A matrix of zeros with room for so many entries in each row.
    pub(crate) fn with_room(counts: &[usize]) -> Symmetric {
        let rows = counts.iter().map(|count| Row::with_capacity(*count));
        Symmetric {
            size: counts.len(),
            entries: Entries::Rows(Arc::new(rows.collect())),
        }
    }

    /// The sum of a diagonal and of matrices times factors, packed. Each entry is added up in the order of the terms.
    pub fn sum(diagonal: &[f64], terms: &[(&Symmetric, f64)]) -> Symmetric {
        let mut packed = Packed::default();
        let terms = terms.iter().copied();
        let of_term = terms.map(|(matrix, factor)| (matrix.entries().peekable(), factor));
        let mut terms: Vec<_> = of_term.collect();
        let mut sums = Row::new();
        for (row, on_diagonal) in diagonal.iter().enumerate() {
            sums.clear();
            add(&mut sums, row, *on_diagonal);
            for (entries, factor) in &mut terms {
                while let Some(((_, column), value)) = entries.next_if(|((i, _), _)| *i == row) {
                    add(&mut sums, column, *factor * value);
                }
            }
            packed.push(&sums);
        }
        packed.matrix()
    }

    /// The entries that are kept, in half of the memory. A change unpacks them.
    #[must_use]
    pub fn packed(&self, keeps: impl Fn(f64) -> bool) -> Symmetric {
        let mut packed = Packed::default();
        let mut kept = self.entries().filter(|(_, value)| keeps(*value)).peekable();
        let mut kept_row = Row::new();
        for row in 0..self.size {
            kept_row.clear();
            while let Some(((_, column), value)) = kept.next_if(|((i, _), _)| *i == row) {
                kept_row.push((column, value));
            }
            packed.push(&kept_row);
        }
        packed.matrix()
    }

    /// The same, packed.
    pub(crate) fn pack(&self) -> Symmetric {
        match self.entries {
            Entries::Rows(_) => self.packed(|_| true),
            Entries::None | Entries::Packed(_) => self.clone(),
        }
    }

    /// Number of rows.
    pub fn size(&self) -> usize {
        self.size
    }

    /// The rows, and the packed form: one of them at most has entries.
    fn forms(&self) -> (&[Row], Option<&Packed>) {
        match &self.entries {
            Entries::None => (&[], None),
            Entries::Rows(rows) => (rows, None),
            Entries::Packed(packed) => (&[], Some(packed)),
        }
    }

    fn rows_mut(&mut self) -> &mut [Row] {
        let rows = match std::mem::replace(&mut self.entries, Entries::None) {
            Entries::None => Arc::new(vec![Row::new(); self.size]),
            Entries::Rows(rows) => rows,
            Entries::Packed(packed) => Arc::new(packed.rows().map(Iterator::collect).collect()),
        };
        self.entries = Entries::Rows(rows);
        match &mut self.entries {
            Entries::Rows(rows) => Arc::<Vec<Row>>::make_mut(rows),
            Entries::None | Entries::Packed(_) => &mut [],
        }
    }

    /// Adds `value` to entries (i, j) and (j, i), which may be one.
    pub fn add(&mut self, i: usize, j: usize, value: f64) {
        add(&mut self.rows_mut()[i.max(j)], i.min(j), value);
    }

    /// Adds a spring between two nodes; `None` is the ground.
    pub fn add_spring(&mut self, between: [Option<usize>; 2], k: f64) {
        self.add_along(&crate::system::structure::between(between), k);
    }

    /// Adds the stiffness k of a spring whose extension is the sum of factor times u.
    pub fn add_along(&mut self, along: &[(usize, f64)], k: f64) {
        for (last, (i, a)) in along.iter().enumerate() {
            for (j, b) in &along[..=last] {
                self.add(*i, *j, k * (a * b));
            }
        }
    }

    /// Whether it has no entries.
    pub fn is_empty(&self) -> bool {
        self.entries().next().is_none()
    }

    /// Adds another matrix times a factor.
    pub fn add_matrix(&mut self, other: &Symmetric, factor: f64) {
        if other.is_empty() {
            return;
        }
        let rows = self.rows_mut();
        for (row, count) in rows.iter_mut().zip(other.counts()) {
            row.reserve_exact(count.saturating_sub(row.len()));
        }
        for ((i, j), value) in other.entries() {
            add(&mut rows[i], j, factor * value);
        }
    }

    /// The entries (row, column) on and below the diagonal, by rows.
    pub fn entries(&self) -> impl Iterator<Item = ((usize, usize), f64)> + '_ {
        let (rows, packed) = self.forms();
        let rows = rows.iter().enumerate();
        let of_rows = rows.flat_map(|(i, row)| row.iter().map(move |(j, value)| ((i, *j), *value)));
        let packed = packed
            .into_iter()
            .flat_map(|packed| packed.rows().enumerate());
        of_rows.chain(packed.flat_map(|(i, row)| row.map(move |(j, value)| ((i, j), value))))
    }

    /// Number of entries of each row on and below the diagonal.
    fn counts(&self) -> impl Iterator<Item = usize> + '_ {
        let (rows, packed) = self.forms();
        let packed = packed.into_iter().flat_map(Packed::rows);
        rows.iter().map(Vec::len).chain(packed.map(Iterator::count))
    }

    /// Largest absolute value of its entries.
    pub fn largest(&self) -> f64 {
        let entries = self.entries();
        entries.fold(0.0, |most, (_, value)| f64::max(most, value.abs()))
    }

    /// Whether each row has an entry other than 0.
    pub fn nonzero_rows(&self) -> Vec<bool> {
        let mut nonzero = vec![false; self.size()];
        for ((i, j), _) in self.entries().filter(|(_, value)| *value != 0.0) {
            (nonzero[i], nonzero[j]) = (true, true);
        }
        nonzero
    }

    /// The rows and columns with these numbers, which rise.
    pub fn block(&self, rows: &[usize]) -> Symmetric {
        let mut block = Symmetric::zeros(rows.len());
        for ((i, j), value) in self.entries() {
            if let (Ok(i), Ok(j)) = (rows.binary_search(&i), rows.binary_search(&j)) {
                block.add(i, j, value);
            }
        }
        block
    }

    /// The same as a full matrix.
    pub fn full(&self) -> DMatrix<f64> {
        let mut full = DMatrix::zeros(self.size(), self.size());
        for ((i, j), value) in self.entries() {
            full[(i, j)] = value;
            full[(j, i)] = value;
        }
        full
    }

    /// Adds the product with a vector to `to`.
    pub fn add_product(&self, x: &[f64], to: &mut [f64]) {
        for ((i, j), value) in self.entries() {
            to[i] += value * x[j];
            if i != j {
                to[j] += value * x[i];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn springs_in_a_row_give_the_matrix_of_a_chain() {
        let mut k = Symmetric::zeros(3);
        k.add_spring([None, Some(0)], 2.0);
        k.add_spring([Some(1), Some(0)], 3.0);
        k.add_spring([Some(1), Some(2)], 5.0);
        let mut product = [0.0; 3];
        k.add_product(&[1.0, 10.0, 100.0], &mut product);
        // Rows 5 -3 0, -3 8 -5, 0 -5 5.
        assert_eq!(product, [-25.0, -423.0, 450.0]);
    }

    #[test]
    fn entries_of_a_full_matrix_come_by_rows() {
        let mut matrix = Symmetric::zeros(4);
        let places = [(3, 1), (0, 0), (1, 3), (3, 3), (3, 0), (2, 3), (1, 0)];
        for (i, j) in places {
            matrix.add(i, j, 1.0);
        }
        let entries: Vec<_> = matrix.entries().collect();
        let expected = [
            ((0, 0), 1.0),
            ((1, 0), 1.0),
            ((3, 0), 1.0),
            ((3, 1), 2.0),
            ((3, 2), 1.0),
            ((3, 3), 1.0),
        ];
        assert_eq!(entries, expected);
    }

    #[test]
    fn a_packed_matrix_has_the_entries_that_are_kept_until_it_is_changed() {
        let mut matrix = Symmetric::zeros(6);
        for (i, j, value) in [(1, 0, 2.0), (1, 1, 0.0), (3, 1, -1.0), (3, 3, 4.0)] {
            matrix.add(i, j, value);
        }
        assert_eq!(matrix.packed(|_| true), matrix);
        let kept = matrix.packed(|value| value != 0.0);
        let expected = [((1, 0), 2.0), ((3, 1), -1.0), ((3, 3), 4.0)];
        assert_eq!(kept.entries().collect::<Vec<_>>(), expected);
        let mut changed = kept.clone();
        changed.add(1, 1, 0.0);
        assert_eq!(changed, matrix);
        changed.add(5, 2, 1.0);
        assert_eq!(changed.entries().last(), Some(((5, 2), 1.0)));
        assert_eq!(kept.entries().count(), 3);
        assert!(Symmetric::zeros(3).packed(|_| true).is_empty());
    }
}
