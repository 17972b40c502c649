//! The factor of the part of a matrix that belongs to the free contacts.

use super::matrix::Matrix;

/// A pivot below this part of its terms is round-off: 1e-16 of the factor and some 1e-15 of a matrix that was itself computed.
/// Stiffness ratios of 1e12 leave pivots of 1e-12.
const SINGULAR: f64 = 1e-14;

/// A_FF = L D L^T, in the rows and columns of A; the others are zero.
#[derive(Debug, Clone)]
pub(super) struct Factor {
    width: usize,
    /// Row k: row k of L, 1/D_k, column k of L; so both substitutions run along rows.
    rows: Vec<f64>,
    /// Row k of L D, then A_(k-1)^-1 a_k.
    row: Vec<f64>,
}

impl Factor {
    /// The factor without free contacts, for matrices with `width` columns.
    pub(super) fn new(width: usize) -> Factor {
        Factor {
            width,
            rows: vec![0.0; width * width],
            row: vec![0.0; width],
        }
    }

    /// Factors the rows and columns `free` of a matrix; false if they are singular to round-off.
    pub(super) fn compute(&mut self, matrix: &Matrix, free: &[usize]) -> bool {
        let width = self.width;
        self.rows.fill(0.0);
        for (before, &k) in free.iter().enumerate() {
            let a = matrix.row(k);
            let before = &free[..before];
            let mut pivot = a[k];
            self.row.fill(0.0);
            for &i in before {
                let above = &self.rows[i * width..][..i];
                let ld = above
                    .iter()
                    .zip(&self.row)
                    .fold(a[i], |sum, (l, ld)| sum - l * ld);
                let l = ld * self.rows[i * width + i];
                pivot -= ld * l;
                self.row[i] = ld;
                self.rows[k * width + i] = l;
                self.rows[i * width + k] = l;
            }
            // The pivot is v^T A v of v = (-A_(k-1)^-1 a_k, 1), with round-off of the sizes of these terms.
            self.row[..k].copy_from_slice(&self.rows[k * width..][..k]);
            let mut terms = a[k];
            for &i in before.iter().rev() {
                let v = self.row[i];
                terms += matrix.row(i)[i] * v * v;
                for (x, l) in self.row.iter_mut().zip(&self.rows[i * width..][..i]) {
                    *x -= l * v;
                }
            }
            let regular = pivot > SINGULAR * terms;
            if !regular {
                return false;
            }
            self.rows[k * width + k] = 1.0 / pivot;
        }
        true
    }

    /// Solves A_FF x_F = b_F in place; the other x become 0.
    #[inline(always)]
    pub(super) fn solve(&self, width: usize, x: &mut [f64]) {
        let (x, rows) = (&mut x[..width], &self.rows[..width * width]);
        for k in 0..width {
            let row = &rows[k * width..][..width];
            let y = x[k];
            for i in k + 1..width {
                x[i] -= row[i] * y;
            }
            x[k] = y * row[k];
        }
        for k in (0..width).rev() {
            let row = &rows[k * width..][..width];
            let s = x[k];
            for i in 0..k {
                x[i] -= row[i] * s;
            }
        }
    }
}
