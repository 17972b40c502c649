//! One linear system: elimination along the diagonal if the matrix is tridiagonal, else a general solver.

use nalgebra::{DMatrix, DVector};

/// x of A x = b; `None` if A has no inverse.
pub(super) fn solve(a: DMatrix<f64>, b: &DVector<f64>) -> Option<DVector<f64>> {
    if tridiagonal(&a) {
        Some(eliminate(&a, b))
    } else {
        a.lu().solve(b)
    }
}

fn tridiagonal(a: &DMatrix<f64>) -> bool {
    let n = a.nrows();
    (0..n).all(|i| (0..n).all(|j| i.abs_diff(j) <= 1 || a[(i, j)] == 0.0))
}

/// Without pivoting, because M and K of bars with a spring are symmetric positive definite.
fn eliminate(a: &DMatrix<f64>, b: &DVector<f64>) -> DVector<f64> {
    let n = b.len();
    let (mut pivot, mut x) = (vec![0.0; n], b.clone());
    for i in 0..n {
        pivot[i] = a[(i, i)];
        if i > 0 {
            let factor = a[(i, i - 1)] / pivot[i - 1];
            pivot[i] -= factor * a[(i - 1, i)];
            x[i] -= factor * x[i - 1];
        }
    }
    for i in (0..n).rev() {
        if i + 1 < n {
            x[i] -= a[(i, i + 1)] * x[i + 1];
        }
        x[i] /= pivot[i];
    }
    x
}
