//! Sparse factors L D L^T of symmetric positive definite matrices.

mod blocks;
mod elimination;
mod entries;
mod minimum_degree;
mod numeric;
mod panels;
pub(crate) mod pivot;
mod products;
mod reach;
mod solve;

pub use blocks::Blocks;
pub use entries::{Columns, Entry};
pub use pivot::negative_pivot;

use super::lists::Lists;
use crate::system::structure::Symmetric;
use elimination::{Order, order};
use numeric::Numeric;
use panels::{Panel, panels};
use std::borrow::Borrow;
use std::fmt;

/// A matrix in the order of elimination, factored: P A P^T = L D L^T, L with a diagonal of 1.
///
/// The order makes few new entries. The factor of a tree, such as bars and piers in rows, has as many entries as the tree has
/// edges.
#[derive(Debug, Clone)]
pub struct Factor {
    order: Vec<usize>,
    triangle: Triangle,
}

/// L without its diagonal, and D.
#[derive(Debug, Clone)]
pub enum Triangle {
    /// Columns with little fill-in.
    Columns {
        /// 1/D.
        reciprocals: Vec<f64>,
        /// L.
        columns: Columns,
    },
    /// Much fill-in.
    Blocks(Blocks),
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
    pub fn new(matrix: impl Borrow<Symmetric>, late: &[bool]) -> Result<Factor, NotPositive> {
        // A matrix that is given away is in memory no longer than needed.
        let packed = matrix.borrow().pack();
        drop(matrix);
        let Order {
            rows,
            numbers,
            fills,
        } = order(neighbours(&packed), late);
        let (diagonal, columns) = ordered(&packed, &rows);
        drop(packed);
        let panels = panels(&columns);
        let numeric = Numeric::new(&panels, &numbers, diagonal, columns)
            .map_err(|pivot| NotPositive { row: rows[pivot] })?;
        let (pivots, values) = numeric.finish();
        let triangle = match fills {
            true => Triangle::Blocks(Blocks::new(&panels, &pivots, values)),
            false => Triangle::Columns {
                reciprocals: pivots.into_iter().map(|pivot| 1.0 / pivot).collect(),
                columns: by_columns(&panels, &values),
            },
        };
        Ok(Factor {
            order: rows,
            triangle,
        })
    }

    /// Factors a matrix that is positive definite beyond round-off: no pivot is below this part of its diagonal.
    ///
    /// # Errors
    /// [`NotPositive`] for a matrix that is not.
    pub fn regular(matrix: &Symmetric, smallest: f64) -> Result<Factor, NotPositive> {
        let factor = Factor::new(matrix, &vec![false; matrix.size()])?;
        let mut diagonal = vec![0.0; matrix.size()];
        for ((i, j), value) in matrix.entries() {
            if i == j {
                diagonal[i] = value;
            }
        }
        let mut pivots = factor.order().iter().zip(factor.reciprocals());
        match pivots.find(|(row, reciprocal)| 1.0 < smallest * diagonal[**row] * **reciprocal) {
            Some((row, _)) => Err(NotPositive { row: *row }),
            None => Ok(factor),
        }
    }

    /// The rows of the matrix in the order of elimination.
    pub fn order(&self) -> &[usize] {
        &self.order
    }

    /// 1/D in the order of elimination.
    pub fn reciprocals(&self) -> &[f64] {
        match &self.triangle {
            Triangle::Columns { reciprocals, .. } => reciprocals,
            Triangle::Blocks(blocks) => blocks.reciprocals(),
        }
    }

    /// L and D.
    pub fn into_triangle(self) -> Triangle {
        self.triangle
    }

    /// Its size in memory, with the order of elimination.
    pub fn bytes(&self) -> usize {
        let triangle = match &self.triangle {
            Triangle::Columns {
                reciprocals,
                columns,
            } => size_of_val(&reciprocals[..]) + columns.bytes(),
            Triangle::Blocks(blocks) => blocks.bytes(),
        };
        size_of_val(&self.order[..]) + triangle
    }

    /// Number of entries of L below its diagonal.
    pub fn entries(&self) -> usize {
        match &self.triangle {
            Triangle::Columns { columns, .. } => columns.entries(),
            Triangle::Blocks(blocks) => blocks.entries(),
        }
    }
}

/// The entries of L with their rows.
fn by_columns(panels: &[Panel], values: &[f64]) -> Columns {
    let mut end = values.len();
    let size = panels.last().map_or(0, |panel| panel.end);
    let panels_backwards = panels.iter().rev();
    let backwards = panels_backwards.flat_map(|p| (p.first..p.end).rev().map(move |k| (p, k)));
    let columns = backwards.map(|(panel, column)| {
        let start = end - panel.entries(column);
        let values = &values[start..end];
        end = start;
        let entries = panel.rows_of(column).zip(values);
        entries.map(|(at, value)| Entry { at, value: *value })
    });
    Columns::new(size, values.len(), columns)
}

/// The rows that each row has an entry with, without itself; they rise.
fn neighbours(matrix: &Symmetric) -> Lists<usize> {
    let others = || matrix.entries().filter(|((i, j), _)| i != j);
    let mut counts = vec![0; matrix.size()];
    for ((i, j), _) in others() {
        counts[i] += 1;
        counts[j] += 1;
    }
    // By rows of the lower triangle: a row takes its columns first, then the rows that it is a column of.
    let entries = others().flat_map(|((i, j), _)| [(i, j), (j, i)]);
    Lists::sorted(&counts, 0, entries)
}

/// The diagonal of a matrix with its rows in this order, and the entries (row, value) of each column below it.
fn ordered(matrix: &Symmetric, rows: &[usize]) -> (Vec<f64>, Lists<(usize, f64)>) {
    let mut position_of = vec![0; rows.len()];
    for (k, row) in rows.iter().enumerate() {
        position_of[*row] = k;
    }
    let entries = || {
        let placed =
            |((i, j), value): ((usize, usize), f64)| ([position_of[i], position_of[j]], value);
        matrix.entries().map(placed)
    };
    let mut diagonal = vec![0.0; rows.len()];
    let mut counts = vec![0; rows.len()];
    for ([i, j], value) in entries() {
        if i == j {
            diagonal[i] = value;
        } else {
            counts[i.min(j)] += 1;
        }
    }
    let others = entries().filter(|([i, j], _)| i != j);
    let below = others.map(|([i, j], value)| (i.min(j), (i.max(j), value)));
    (diagonal, Lists::sorted(&counts, (0, 0.0), below))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lane::Lane;
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
            factor.for_column(i, |entry| l[(entry.at, i)] = entry.value);
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

    /// Springs of a square grid of nodes.
    fn grid(width: usize) -> Symmetric {
        let node = |i: usize, j: usize| i * width + j;
        let mut pairs = Vec::new();
        for i in 0..width {
            for j in 0..width {
                let k = 1.0 + (7 * i + 3 * j) as f64 % 5.0;
                if i > 0 {
                    pairs.push((node(i, j), node(i - 1, j), k));
                }
                if j > 0 {
                    pairs.push((node(i, j), node(i, j - 1), 1.0 / k));
                }
            }
        }
        springs(width * width, &pairs)
    }

    /// D and L of a matrix with its rows in the order of a factor, column after column in a full matrix. Of two entries i > j of a
    /// column, that of row i is divided by the pivot if `before`, else that of row j.
    fn full(
        matrix: &Symmetric,
        factor: &Factor,
        before: impl Fn(usize, usize) -> bool,
    ) -> DMatrix<f64> {
        let n = matrix.size();
        let position_of: Vec<usize> = {
            let mut positions = vec![0; n];
            for (k, row) in factor.order().iter().enumerate() {
                positions[*row] = k;
            }
            positions
        };
        let mut a = DMatrix::zeros(n, n);
        for ((i, j), value) in matrix.entries() {
            a[(
                position_of[i].max(position_of[j]),
                position_of[i].min(position_of[j]),
            )] = value;
        }
        for k in 0..n {
            let below: Vec<f64> = (k + 1..n).map(|i| a[(i, k)]).collect();
            let pivot = a[(k, k)];
            for i in k + 1..n {
                for j in k + 1..=i {
                    let [x, y] = [below[i - k - 1], below[j - k - 1]];
                    a[(i, j)] -= match before(i, j) {
                        true => x / pivot * y,
                        false => x * (y / pivot),
                    };
                }
                a[(i, k)] = below[i - k - 1] / pivot;
            }
        }
        a
    }

    fn has_the_bits_of(factor: &Factor, full: &DMatrix<f64>) {
        for i in 0..full.nrows() {
            assert_eq!(factor.reciprocals()[i], 1.0 / full[(i, i)], "{i}");
            let mut column = vec![0.0; full.nrows()];
            factor.for_column(i, |entry| column[entry.at] = entry.value);
            for j in i + 1..full.nrows() {
                assert_eq!(column[j], full[(j, i)], "{j} {i}");
            }
        }
    }

    #[test]
    fn a_small_factor_has_the_bits_of_an_elimination_by_columns() {
        // The order of the rows decides on the products.
        let matrix = grid(9);
        let factor = Factor::new(&matrix, &[false; 81]).unwrap();
        let order = factor.order();
        let full = full(&matrix, &factor, |i, j| order[i] < order[j]);
        has_the_bits_of(&factor, &full);
    }

    #[test]
    fn a_large_factor_has_the_bits_of_an_elimination_by_columns() {
        let matrix = grid(32);
        let factor = Factor::new(&matrix, &[false; 1024]).unwrap();
        has_the_bits_of(&factor, &full(&matrix, &factor, |_, _| false));
    }

    /// A factor by panels.
    fn filled() -> (Symmetric, Factor) {
        let matrix = grid(40);
        let factor = Factor::new(&matrix, &[false; 1600]).unwrap();
        assert!(matches!(factor.triangle, Triangle::Blocks(_)));
        (matrix, factor)
    }

    #[test]
    fn a_solution_by_panels_fulfils_the_equations() {
        let (matrix, factor) = filled();
        let x: Vec<f64> = (0..1600).map(|i| f64::from(i % 13) - 6.0).collect();
        let mut b = vec![0.0; 1600];
        matrix.add_product(&x, &mut b);
        factor.solve(&mut b);
        for (solved, x) in b.iter().zip(x) {
            // Round-off times a condition of about 50.
            assert!((solved - x).abs() < 1e-12, "{solved} {x}");
        }
    }

    #[test]
    fn lanes_by_panels_have_the_bits_of_one() {
        let (_, factor) = filled();
        let Triangle::Blocks(blocks) = &factor.triangle else {
            return;
        };
        let number = |i: usize, l: usize| (i * (l + 3) % 17) as f64 - 8.3;
        let lane = |i: usize| Lane(std::array::from_fn::<_, 5, _>(|l| number(i, l)));
        let mut together: Vec<Lane<5>> = (0..1600).map(lane).collect();
        blocks.eliminate(&mut together);
        blocks.substitute(&mut together);
        for l in 0..5 {
            let mut alone: Vec<Lane<1>> = (0..1600).map(|i| Lane([number(i, l)])).collect();
            blocks.eliminate(&mut alone);
            blocks.substitute(&mut alone);
            for (alone, together) in alone.iter().zip(&together) {
                assert_eq!(alone.0[0], together.0[l]);
            }
        }
    }

    #[test]
    fn a_few_entries_are_eliminated_as_in_a_full_right_side() {
        let chain: Vec<_> = (1..40).map(|i| (i / 2, i, 1.0)).collect();
        let tree = Factor::new(springs(40, &chain), &[false; 40]).unwrap();
        for factor in [filled().1, tree] {
            let n = factor.order().len();
            let few = [(3, 1.5), (n / 2, -2.0), (n - 2, 0.5), (3, 0.25)];
            let mut full = vec![0.0; n];
            for (at, x) in few {
                full[at] += x;
            }
            for i in 0..n {
                let value = full[i];
                factor.for_column(i, |entry| full[entry.at] -= entry.value * value);
            }
            let nonzero = full.into_iter().enumerate().filter(|(_, x)| *x != 0.0);
            assert_eq!(factor.eliminate_few(&few), nonzero.collect::<Vec<_>>());
        }
    }

    #[test]
    fn a_large_grid_has_little_fill_in() {
        // Nested dissection of a square grid of n nodes: 31/8 n log2 n entries to leading order (George 1973).
        let factor = Factor::new(grid(64), &[false; 4096]).unwrap();
        assert!((factor.entries() as f64) < 31.0 / 8.0 * 4096.0 * 12.0);
    }

    #[test]
    fn a_large_chain_is_eliminated_by_exact_degrees() {
        let edges: Vec<_> = (1..5000).map(|i| (i - 1, i, 1.0)).collect();
        let late: Vec<bool> = (0..5000).map(|i| i == 4999).collect();
        let factor = Factor::new(springs(5000, &edges), &late).unwrap();
        assert_eq!(factor.entries(), 4999);
        assert_eq!(factor.order()[4999], 4999);
    }

    #[test]
    fn a_ring_has_the_least_fill_in() {
        // Eliminating a node of a ring joins its neighbours: n - 3 new entries.
        let edges: Vec<_> = (0..10).map(|i| (i, (i + 1) % 10, 1.0)).collect();
        assert_eq!(
            Factor::new(springs(10, &edges), &[false; 10])
                .unwrap()
                .entries(),
            17
        );
    }

    #[test]
    fn late_rows_of_a_chain_come_last() {
        let edges: Vec<_> = (1..9).map(|i| (i - 1, i, 1.0)).collect();
        let late: Vec<bool> = (0..9).map(|i| i == 8).collect();
        let factor = Factor::new(springs(9, &edges), &late).unwrap();
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
