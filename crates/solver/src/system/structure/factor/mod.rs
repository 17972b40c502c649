//! Sparse factors L D L^T of symmetric positive definite matrices.

mod order;
mod solve;

use super::Symmetric;
use super::lists::Lists;
use order::Remaining;
use std::collections::BTreeMap;
use std::fmt;

/// A matrix in the order of elimination, factored: P A P^T = L D L^T, L with a diagonal of 1.
///
/// The order is that of the smallest degree (Tinney and Walker 1967). The factor of a tree, such as bars and piers in rows,
/// has as many entries as the tree has edges.
#[derive(Debug, Clone)]
pub struct Factor {
    order: Vec<usize>,
    /// 1/D.
    reciprocals: Vec<f64>,
    /// L without its diagonal.
    columns: Lists<Entry>,
}

/// An entry of L.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Entry {
    /// Its row.
    pub at: usize,
    /// The number.
    pub value: f64,
}

/// A matrix is not positive definite.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NotPositive {
    /// Row whose pivot is not positive.
    pub row: usize,
}

impl fmt::Display for NotPositive {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the matrix is not positive definite, row {}", self.row)
    }
}

impl std::error::Error for NotPositive {}

impl Factor {
    /// Factors a matrix. Rows of `late` come late in the order where that costs nothing.
    ///
    /// # Errors
    /// [`NotPositive`] if the matrix is not positive definite.
    pub fn new(matrix: &Symmetric, late: &[bool]) -> Result<Factor, NotPositive> {
        let n = matrix.size();
        let mut diagonal = vec![0.0; n];
        let mut rows = vec![BTreeMap::new(); n];
        for ((i, j), value) in matrix.entries() {
            if i == j {
                diagonal[i] = value;
            } else {
                rows[i].insert(j, value);
                rows[j].insert(i, value);
            }
        }
        let mut remaining = Remaining::new(&rows, late);
        let mut order = Vec::with_capacity(n);
        let mut columns = Vec::with_capacity(n);
        while let Some(row) = remaining.next() {
            let pivot = diagonal[row];
            if !(pivot > 0.0 && pivot.is_finite()) {
                return Err(NotPositive { row });
            }
            let column: Vec<(usize, f64)> = std::mem::take(&mut rows[row]).into_iter().collect();
            for (i, a) in &column {
                let l = a / pivot;
                diagonal[*i] -= l * a;
                rows[*i].remove(&row);
                for (j, b) in column.iter().filter(|(j, _)| j != i) {
                    // One product for both triangles, so that they stay equal.
                    let product = if i < j { l * b } else { a * (b / pivot) };
                    *rows[*i].entry(*j).or_default() -= product;
                }
            }
            for (i, _) in &column {
                remaining.eliminated(row, *i, rows[*i].len());
            }
            columns.push(column.into_iter().map(move |(i, a)| (i, a / pivot)));
            order.push(row);
        }
        Ok(Factor::renumbered(order, diagonal, columns))
    }

    /// The factor in the order of elimination.
    fn renumbered(
        order: Vec<usize>,
        diagonal: Vec<f64>,
        columns: Vec<impl Iterator<Item = (usize, f64)>>,
    ) -> Factor {
        let mut place = vec![0; order.len()];
        for (k, row) in order.iter().enumerate() {
            place[*row] = k;
        }
        let mut by_columns = vec![Vec::new(); order.len()];
        for (k, column) in columns.into_iter().enumerate() {
            for (row, value) in column {
                let at = place[row];
                by_columns[k].push(Entry { at, value });
            }
        }
        for column in &mut by_columns {
            column.sort_unstable_by_key(|entry| entry.at);
        }
        Factor {
            reciprocals: order.iter().map(|row| 1.0 / diagonal[*row]).collect(),
            order,
            columns: Lists::new(&by_columns),
        }
    }

    /// The rows of the matrix in the order of elimination.
    pub fn order(&self) -> &[usize] {
        &self.order
    }

    /// 1/D in the order of elimination.
    pub fn reciprocals(&self) -> &[f64] {
        &self.reciprocals
    }

    /// Column `i` of L, below the diagonal, in the order of elimination; its rows rise.
    pub fn column(&self, i: usize) -> &[Entry] {
        self.columns.list(i)
    }

    /// Number of entries of L below its diagonal.
    pub fn entries(&self) -> usize {
        self.columns.entries().len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::DMatrix;
    use proptest::prelude::*;

    /// Springs k between pairs of nodes, and 0.5 from each node to the ground.
    fn springs(n: usize, pairs: &[(usize, usize, f64)]) -> Symmetric {
        let mut matrix = Symmetric::zeros(n);
        for i in 0..n {
            matrix.add_spring([None, Some(i)], 0.5);
        }
        for (i, j, k) in pairs {
            matrix.add_spring([Some(*i), Some(*j)], *k);
        }
        matrix
    }

    /// L D L^T in the order of the matrix.
    fn product(factor: &Factor) -> DMatrix<f64> {
        let n = factor.order().len();
        let mut l = DMatrix::identity(n, n);
        for i in 0..n {
            for entry in factor.column(i) {
                l[(entry.at, i)] = entry.value;
            }
        }
        let d = DMatrix::from_fn(n, n, |i, j| {
            if i == j {
                1.0 / factor.reciprocals()[i]
            } else {
                0.0
            }
        });
        let ordered = &l * d * l.transpose();
        let mut matrix = DMatrix::zeros(n, n);
        for (i, row) in factor.order().iter().enumerate() {
            for (j, column) in factor.order().iter().enumerate() {
                matrix[(*row, *column)] = ordered[(i, j)];
            }
        }
        matrix
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn the_factor_multiplies_to_the_matrix(
            pairs in prop::collection::vec((0..12_usize, 0..12_usize, 0.1..10.0_f64), 0..40),
            late in prop::collection::vec(any::<bool>(), 12),
        ) {
            let pairs: Vec<_> = pairs.into_iter().filter(|(i, j, _)| i != j).collect();
            let matrix = springs(12, &pairs);
            let product = product(&Factor::new(&matrix, &late).unwrap());
            for i in 0..12 {
                let mut row = [0.0; 12];
                let unit: [f64; 12] = std::array::from_fn(|j| if i == j { 1.0 } else { 0.0 });
                matrix.add_product(&unit, &mut row);
                for (j, expected) in row.into_iter().enumerate() {
                    // Entries up to 400 of sums of at most 12 products.
                    prop_assert!((product[(i, j)] - expected).abs() < 1e-12);
                }
            }
        }

        #[test]
        fn a_tree_has_no_fill_in(parents in prop::collection::vec(0..1000_usize, 30)) {
            let edges = (1..30).map(|i| (i, parents[i] % i, 1.0));
            let matrix = springs(30, &edges.collect::<Vec<_>>());
            prop_assert_eq!(Factor::new(&matrix, &[false; 30]).unwrap().entries(), 29);
        }
    }

    #[test]
    fn a_ring_has_the_least_fill_in() {
        // Eliminating a node of a ring joins its neighbours: n - 3 new entries.
        let edges: Vec<_> = (0..10).map(|i| (i, (i + 1) % 10, 1.0)).collect();
        assert_eq!(
            Factor::new(&springs(10, &edges), &[false; 10])
                .unwrap()
                .entries(),
            17
        );
    }

    #[test]
    fn late_rows_of_a_chain_come_last() {
        let edges: Vec<_> = (1..9).map(|i| (i - 1, i, 1.0)).collect();
        let late: Vec<bool> = (0..9).map(|i| i == 8).collect();
        let factor = Factor::new(&springs(9, &edges), &late).unwrap();
        assert_eq!(factor.order(), [0, 1, 2, 3, 4, 5, 6, 7, 8]);
    }

    #[test]
    fn a_matrix_that_is_not_positive_definite_has_no_factor() {
        for (k, row) in [(-1.0, 0), (f64::NAN, 0), (0.0, 0)] {
            let mut matrix = Symmetric::zeros(2);
            matrix.add_spring([Some(0), Some(1)], k);
            assert_eq!(
                Factor::new(&matrix, &[false; 2]).unwrap_err(),
                NotPositive { row }
            );
        }
        // Free: the second pivot is zero.
        let mut matrix = Symmetric::zeros(2);
        matrix.add_spring([Some(0), Some(1)], 2.0);
        assert_eq!(
            Factor::new(&matrix, &[false; 2]).unwrap_err(),
            NotPositive { row: 1 }
        );
    }
}
