//! K or C in the coordinates of a model.

use super::row::{dot, sum};
use super::sparse::Rows;

/// A symmetric matrix.
#[derive(Debug, Clone)]
pub enum Matrix {
    /// Between nodes: few entries.
    Sparse(Rows),
    /// Between modes: the diagonal.
    Diagonal(Vec<f64>),
    /// Between modes: all entries, by rows.
    Dense(Vec<f64>),
}

impl Matrix {
    /// Whether nothing is stored; zeros between modes are stored as a matrix without entries.
    pub fn is_zero(&self) -> bool {
        match self {
            Matrix::Sparse(rows) => rows.is_zero(),
            Matrix::Diagonal(_) | Matrix::Dense(_) => false,
        }
    }

    /// Number of stored entries.
    pub fn entries(&self) -> usize {
        match self {
            Matrix::Sparse(rows) => rows.entries(),
            Matrix::Diagonal(list) | Matrix::Dense(list) => list.len(),
        }
    }

    /// Subtracts `factor` times the product with `x`.
    pub fn subtract_product(&self, factor: f64, x: &[f64], from: &mut [f64]) {
        match self {
            Matrix::Sparse(rows) => rows.subtract_product(factor, x, from),
            Matrix::Diagonal(diagonal) => {
                for ((from, a), x) in from.iter_mut().zip(diagonal).zip(x) {
                    *from -= factor * (a * x);
                }
            }
            Matrix::Dense(entries) => {
                for (from, row) in from.iter_mut().zip(entries.chunks_exact(x.len())) {
                    *from -= factor * dot(row, x);
                }
            }
        }
    }

    /// x^T A x.
    pub fn form(&self, x: &[f64]) -> f64 {
        match self {
            Matrix::Sparse(rows) => rows.form(x, x),
            Matrix::Diagonal(diagonal) => sum(diagonal, x, |a, x| a * x * x),
            Matrix::Dense(entries) => {
                let rows = entries.chunks_exact(x.len()).zip(x);
                rows.map(|(row, x_i)| x_i * dot(row, x)).sum()
            }
        }
    }

    /// Adds the sums of the absolute values of the terms of the product with `x`.
    pub fn add_terms(&self, x: &[f64], to: &mut [f64]) {
        match self {
            Matrix::Sparse(rows) => {
                for (i, to) in to.iter_mut().enumerate() {
                    let row = rows.row(i).iter();
                    *to += row.map(|(j, value)| (value * x[*j]).abs()).sum::<f64>();
                }
            }
            Matrix::Diagonal(diagonal) => {
                for ((to, a), x) in to.iter_mut().zip(diagonal).zip(x) {
                    *to += (a * x).abs();
                }
            }
            Matrix::Dense(entries) => {
                for (to, row) in to.iter_mut().zip(entries.chunks_exact(x.len())) {
                    *to += sum(row, x, |a, x| (a * x).abs());
                }
            }
        }
    }
}
