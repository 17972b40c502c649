//! The Cholesky factor of a small matrix, singular or not.

/// Smallest pivot over its diagonal entry of a matrix that is not singular.
const SMALLEST: f64 = 1e-11;

/// What is added to the diagonal of a singular matrix, over the entry.
const ADDED: f64 = 1e-6;

/// Corrections of a solution with a singular matrix; each one reduces the residual by about [`ADDED`].
const CORRECTIONS: usize = 2;

/// A lower triangle L with A = L L^T, by rows; for a singular A of a matrix next to it.
#[derive(Debug, Clone, Default)]
pub struct Cholesky {
    factor: Vec<f64>,
    size: usize,
    singular: Option<Vec<f64>>,
}

impl Cholesky {
    /// Factors a symmetric matrix > 0 of `size` rows; `None` if it is singular.
    pub fn new(mut a: Vec<f64>, size: usize) -> Option<Cholesky> {
        for i in 0..size {
            for j in 0..=i {
                let products = (0..j).map(|k| a[i * size + k] * a[j * size + k]);
                let rest = a[i * size + j] - products.sum::<f64>();
                if i > j {
                    a[i * size + j] = rest / a[j * size + j];
                } else if rest > SMALLEST * a[i * size + i] {
                    a[i * size + i] = rest.sqrt();
                } else {
                    return None;
                }
            }
        }
        Some(Cholesky {
            factor: a,
            size,
            singular: None,
        })
    }

    /// Factors a symmetric matrix >= 0 with a positive diagonal; `None` for another one.
    pub fn of_any(a: Vec<f64>, size: usize) -> Option<Cholesky> {
        Cholesky::sharing(a, size, |_| 1.0)
    }

    /// The same for a solution of a singular matrix in which contacts with equal parts share as the inverse of these weights, >= 1.
    pub fn sharing(a: Vec<f64>, size: usize, weight: impl Fn(usize) -> f64) -> Option<Cholesky> {
        Cholesky::new(a.clone(), size).or_else(|| {
            let mut more = regular(&a, size);
            for i in 0..size {
                more[i * size + i] += ADDED * (weight(i) - 1.0) * a[i * size + i];
            }
            let factor = Cholesky::new(more, size)?;
            Some(Cholesky {
                singular: Some(a),
                ..factor
            })
        })
    }

    /// Solves A x = b in place. For a singular A and a b that it can have, the solution has no part that A cancels, so that equal
    /// contacts have equal forces.
    pub fn solve(&self, b: &mut [f64]) {
        let Some(matrix) = &self.singular else {
            return self.substitute(b);
        };
        let mut x = vec![0.0; self.size];
        for _ in 0..=CORRECTIONS {
            let rows = matrix.chunks_exact(self.size).zip(&*b);
            let mut residual: Vec<f64> = rows
                .map(|(row, b)| b - row.iter().zip(&x).map(|(a, x)| a * x).sum::<f64>())
                .collect();
            self.substitute(&mut residual);
            for (x, residual) in x.iter_mut().zip(residual) {
                *x += residual;
            }
        }
        b.copy_from_slice(&x);
    }

    fn substitute(&self, b: &mut [f64]) {
        let (l, n) = (&self.factor, self.size);
        for i in 0..n {
            let products = (0..i).map(|k| l[i * n + k] * b[k]);
            b[i] = (b[i] - products.sum::<f64>()) / l[i * n + i];
        }
        for i in (0..n).rev() {
            let products = (i + 1..n).map(|k| l[k * n + i] * b[k]);
            b[i] = (b[i] - products.sum::<f64>()) / l[i * n + i];
        }
    }
}

/// The matrix with [`ADDED`] to its diagonal.
pub fn regular(a: &[f64], size: usize) -> Vec<f64> {
    let mut a = a.to_vec();
    for i in 0..size {
        a[i * size + i] *= 1.0 + ADDED;
    }
    a
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_contacts_have_equal_forces() {
        // Two contacts in parallel, and one in series with them.
        let a = vec![1.0, 1.0, -0.5, 1.0, 1.0, -0.5, -0.5, -0.5, 2.0];
        assert!(Cholesky::new(a.clone(), 3).is_none());
        let mut b = [1.0, 1.0, 3.0];
        Cholesky::of_any(a, 3).unwrap().solve(&mut b);
        // S1 + S2 - S3/2 = 1, -(S1 + S2)/2 + 2 S3 = 3.
        let (sum, third) = (2.0, 2.0);
        assert!((b[0] + b[1] - sum).abs() < 1e-14 && (b[2] - third).abs() < 1e-14);
        // Round-off over what is added to the diagonal.
        assert!((b[0] - b[1]).abs() < 1e-9, "{b:?}");
    }

    #[test]
    fn contacts_share_as_the_inverse_of_their_weights() {
        let mut b = [1.0, 1.0];
        let factor = Cholesky::sharing(vec![1.0; 4], 2, |i| [1.0, 4.0][i]);
        factor.unwrap().solve(&mut b);
        // What is added to the diagonal, and its round-off after corrections.
        assert!(
            (b[0] - 0.8).abs() < 1e-9 && (b[1] - 0.2).abs() < 1e-9,
            "{b:?}"
        );
    }

    #[test]
    fn a_contact_of_the_ground_with_itself_has_no_factor() {
        assert!(Cholesky::of_any(vec![0.0], 1).is_none());
    }
}
