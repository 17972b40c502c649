//! Pivots of matrices that should be positive semidefinite.

use super::{Factor, NotPositive};
use crate::system::structure::Symmetric;

/// Part of the largest entry by which a pivot may be negative: round-off of a matrix that another program wrote.
const ROUND_OFF: f64 = 1e-9;

/// Part of the largest entry by which the sums of springs are round-off, far below what a pivot may be negative.
const SPRINGS: f64 = 1e-13;

/// Whether no entry of the diagonal is below the sum of the others in its row, as of springs that pull back: then all pivots are >= 0.
fn is_dominated_by_its_diagonal(matrix: &Symmetric) -> bool {
    let mut rows = vec![0.0; matrix.size()];
    for ((i, j), entry) in matrix.entries() {
        if i == j {
            rows[i] += entry;
        } else {
            rows[i] -= f64::abs(entry);
            rows[j] -= f64::abs(entry);
        }
    }
    let largest = matrix.largest();
    rows.iter().all(|row| *row >= -SPRINGS * largest)
}

/// A row with a negative pivot, one below -1e-9 of the largest entry; `None` of a positive semidefinite matrix.
pub fn negative_pivot(matrix: &Symmetric) -> Option<usize> {
    let (n, largest) = (matrix.size(), matrix.largest());
    if largest == 0.0 || is_dominated_by_its_diagonal(matrix) {
        return None;
    }
    let mut shifted = matrix.clone();
    for i in 0..n {
        shifted.add(i, i, ROUND_OFF * largest);
    }
    let factor = Factor::new(shifted, &vec![false; n]);
    factor.err().map(|NotPositive { row }| row)
}
