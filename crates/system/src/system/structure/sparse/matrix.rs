//! Sparse symmetric matrices.

use nalgebra::DMatrix;

/// A sparse symmetric matrix: the entries on and below the diagonal.
#[derive(Debug, Clone, PartialEq)]
pub struct Symmetric {
    /// The entries (column, value) of each row, which rise.
    rows: Vec<Vec<(usize, f64)>>,
}

impl Symmetric {
    /// A matrix of zeros.
    pub fn zeros(size: usize) -> Symmetric {
        Symmetric {
            rows: vec![Vec::new(); size],
        }
    }

    /// Number of rows.
    pub fn size(&self) -> usize {
        self.rows.len()
    }

    /// Adds `value` to entries (i, j) and (j, i), which may be one.
    pub fn add(&mut self, i: usize, j: usize, value: f64) {
        let (row, column) = (&mut self.rows[i.max(j)], i.min(j));
        // Most matrices are filled by rising columns.
        let last = row.last().is_none_or(|(last, _)| *last < column);
        let place = if last {
            Err(row.len())
        } else {
            row.binary_search_by_key(&column, |(j, _)| *j)
        };
        match place {
            Ok(place) => row[place].1 += value,
            Err(place) => row.insert(place, (column, 0.0 + value)),
        }
    }

    /// Adds a spring between two nodes; `None` is the ground.
    pub fn add_spring(&mut self, between: [Option<usize>; 2], k: f64) {
        self.add_along(&crate::system::structure::between(between), k);
    }

    /// Adds the stiffness k of a spring whose extension is the sum of factor times u.
    pub fn add_along(&mut self, along: &[(usize, f64)], k: f64) {
        for (place, (i, a)) in along.iter().enumerate() {
            for (j, b) in &along[..=place] {
                self.add(*i, *j, k * (a * b));
            }
        }
    }

    /// Whether it has no entries.
    pub fn is_empty(&self) -> bool {
        self.rows.iter().all(Vec::is_empty)
    }

    /// Adds another matrix times a factor.
    pub fn add_matrix(&mut self, other: &Symmetric, factor: f64) {
        for (row, other) in self.rows.iter_mut().zip(&other.rows) {
            row.reserve_exact(other.len().saturating_sub(row.len()));
        }
        for ((i, j), value) in other.entries() {
            self.add(i, j, factor * value);
        }
    }

    /// The entries (row, column) on and below the diagonal, by rows.
    pub fn entries(&self) -> impl Iterator<Item = ((usize, usize), f64)> + '_ {
        let rows = self.rows.iter().enumerate();
        rows.flat_map(|(i, row)| row.iter().map(move |(j, value)| ((i, *j), *value)))
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
}
