//! Linear algebra of a few dimensions. Products are plain loops: those of the library depend on the processor from six rows on.

use nalgebra::{DMatrix, DVector, SymmetricEigen};

/// Sweeps of the eigensolver at most; it needs two or three for each row.
const SWEEPS: usize = 1000;

/// The smallest diagonal of a triangular factor relative to its largest, below which a fit has no unique solution.
const SINGULAR: f64 = 1e-10;

/// The eigenvalues of a symmetric matrix, rising, and their vectors of length 1.
#[derive(Debug, Clone, PartialEq)]
pub struct Eigen {
    pub values: Vec<f64>,
    pub vectors: Vec<Vec<f64>>,
}

impl Eigen {
    /// `None` if the matrix is not finite.
    pub fn of(matrix: &[Vec<f64>]) -> Option<Eigen> {
        if !matrix.iter().flatten().all(|x| x.is_finite()) {
            return None;
        }
        if matrix.is_empty() {
            return Some(Eigen::unit(0));
        }
        let solved = SymmetricEigen::try_new(dense(matrix), f64::EPSILON, SWEEPS)?;
        let mut order: Vec<usize> = (0..matrix.len()).collect();
        order.sort_by(|i, j| solved.eigenvalues[*i].total_cmp(&solved.eigenvalues[*j]));
        let vector = |i: &usize| solved.eigenvectors.column(*i).iter().copied().collect();
        Some(Eigen {
            values: order.iter().map(|i| solved.eigenvalues[*i]).collect(),
            vectors: order.iter().map(vector).collect(),
        })
    }

    /// The unit matrix.
    pub fn unit(dimensions: usize) -> Eigen {
        Eigen {
            values: vec![1.0; dimensions],
            vectors: (0..dimensions).map(|k| axis(dimensions, k)).collect(),
        }
    }

    /// The matrix with the same vectors and other eigenvalues.
    pub fn with(&self, values: &[f64]) -> Vec<Vec<f64>> {
        let n = values.len();
        let mut matrix = vec![vec![0.0; n]; n];
        for (value, vector) in values.iter().zip(&self.vectors) {
            for (row, x) in matrix.iter_mut().zip(vector) {
                for (to, y) in row.iter_mut().zip(vector) {
                    *to += value * x * y;
                }
            }
        }
        matrix
    }
}

/// The direction of a coordinate.
pub fn axis(dimensions: usize, k: usize) -> Vec<f64> {
    (0..dimensions).map(|i| f64::from(i == k)).collect()
}

pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

pub fn times(matrix: &[Vec<f64>], vector: &[f64]) -> Vec<f64> {
    matrix.iter().map(|row| dot(row, vector)).collect()
}

/// The rows and columns of a matrix at these places.
pub fn block(matrix: &[Vec<f64>], rows: &[usize], columns: &[usize]) -> Vec<Vec<f64>> {
    let row = |i: &usize| columns.iter().map(|j| matrix[*i][*j]).collect();
    rows.iter().map(row).collect()
}

/// x of A x = b; `None` if A is not positive definite.
pub fn solve(matrix: &[Vec<f64>], right: &[f64]) -> Option<Vec<f64>> {
    let factor = dense(matrix).cholesky()?;
    let solution = factor.solve(&DVector::from_column_slice(right));
    let finite = solution.iter().all(|x| x.is_finite());
    finite.then(|| solution.iter().copied().collect())
}

/// The x for which the sum of squares of A x - b is smallest, by QR; `None` if it is not unique.
pub fn least_squares(rows: &[Vec<f64>], right: &[f64]) -> Option<Vec<f64>> {
    let columns = rows.first()?.len();
    if rows.len() < columns {
        return None;
    }
    let factors = dense(rows).qr();
    let mut right = DVector::from_column_slice(right);
    factors.q_tr_mul(&mut right);
    let triangle = factors.r();
    let diagonal = || (0..columns).map(|i| triangle[(i, i)].abs());
    if diagonal().fold(f64::INFINITY, f64::min) <= SINGULAR * diagonal().fold(0.0, f64::max) {
        return None;
    }
    let solution = triangle.solve_upper_triangular(&right.rows(0, columns))?;
    let finite = solution.iter().all(|x| x.is_finite());
    finite.then(|| solution.iter().copied().collect())
}

fn dense(rows: &[Vec<f64>]) -> DMatrix<f64> {
    let columns = rows.first().map_or(0, Vec::len);
    DMatrix::from_fn(rows.len(), columns, |i, j| rows[i][j])
}
