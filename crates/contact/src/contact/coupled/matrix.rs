//! The matrix A = H + diag(g), and the round-off of q = d - A S.

use super::step::Step;

/// Round-off of q as part of the sum of its terms: some 500 times the unit round-off, for sums of many terms and solutions of
/// blocks. As part of d alone, which may be a small difference of large numbers, it would be too small.
pub(super) const ROUND_OFF: f64 = 1e-13;

/// A.
#[derive(Debug, Clone)]
pub(super) struct Matrix {
    width: usize,
    entries: Vec<f64>,
    /// 1/A_ii; 0 where A_ii is 0.
    inverse: Vec<f64>,
}

impl Matrix {
    pub(super) fn new(entries: Vec<f64>, width: usize) -> Matrix {
        let inverse = (0..width).map(|i| match entries[i * width + i] {
            0.0 => 0.0,
            a => 1.0 / a,
        });
        Matrix {
            width,
            inverse: inverse.collect(),
            entries,
        }
    }

    /// A + `part` diag(A).
    pub(super) fn softened(&self, part: f64) -> Matrix {
        let mut entries = self.entries.clone();
        for i in 0..self.width {
            entries[i * self.width + i] += part * self.row(i)[i];
        }
        Matrix::new(entries, self.width)
    }

    /// Changes an entry of the diagonal.
    pub(super) fn set_diagonal(&mut self, i: usize, value: f64) {
        self.entries[i * self.width + i] = value;
        self.inverse[i] = 1.0 / value;
    }

    /// Changes the entries of two neighbouring rows among each other: A_ii, A_ij and A_jj, j = i + 1.
    pub(super) fn set_pair(&mut self, i: usize, [first, between, next]: [f64; 3]) {
        self.set_diagonal(i, first);
        self.set_diagonal(i + 1, next);
        self.entries[i * self.width + i + 1] = between;
        self.entries[(i + 1) * self.width + i] = between;
    }

    /// Number of rows and columns.
    pub(super) fn width(&self) -> usize {
        self.width
    }

    #[inline(always)]
    pub(super) fn row(&self, row: usize) -> &[f64] {
        &self.entries[row * self.width..][..self.width]
    }

    /// Takes the part of a force off q.
    #[inline(always)]
    pub(super) fn take(&self, contact: usize, force: f64, q: &mut [f64]) {
        // A is symmetric: the row is the column. The length of q may be known to the compiler.
        let column = &self.entries[contact * q.len()..][..q.len()];
        for (q, a) in q.iter_mut().zip(column) {
            *q -= a * force;
        }
    }

    /// Whether q_i is round-off of size_i + sum_j |A_ij| (|S_j| + size_j/A_jj). The last term is for an S_j that is itself a small
    /// difference of large numbers.
    #[inline(always)]
    pub(super) fn is_round_off(&self, contact: usize, q: f64, step: Step, force: &[f64]) -> bool {
        let (q, size) = (q.abs(), step.size[contact]);
        // Most often the first term is enough.
        q <= ROUND_OFF * size || q <= ROUND_OFF * (size + self.sum_of_terms(contact, step, force))
    }

    fn sum_of_terms(&self, contact: usize, step: Step, force: &[f64]) -> f64 {
        let mut sum = 0.0;
        for (j, a) in self.row(contact).iter().enumerate() {
            sum += a.abs() * (force[j].abs() + step.size[j] * self.inverse[j]);
        }
        sum
    }
}
