//! Pivots of matrices that should be positive semidefinite.

use super::{Factor, NotPositive};
use crate::system::structure::Symmetric;

/// Part of the largest entry by which a pivot may be negative: round-off of a matrix that another program wrote.
const ROUND_OFF: f64 = 1e-9;

/// A row with a negative pivot, one below -1e-9 of the largest entry; `None` of a positive semidefinite matrix.
pub fn negative_pivot(matrix: &Symmetric) -> Option<usize> {
    let (n, largest) = (matrix.size(), matrix.largest());
    if largest == 0.0 {
        return None;
    }
    let mut shifted = matrix.clone();
    for i in 0..n {
        shifted.add(i, i, ROUND_OFF * largest);
    }
    let factor = Factor::new(shifted, &vec![false; n]);
    factor.err().map(|NotPositive { row }| row)
}
