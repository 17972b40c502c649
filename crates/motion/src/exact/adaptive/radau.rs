//! Collocation at the five points of Radau (Radau IIA), of order 9. Fast motions that fade leave no error in it, and nothing is
//! evaluated at the start of a step.

/// Number of points.
pub const POINTS: usize = 5;

/// The points: zeros of P5 - P4, as parts of a step.
pub const NODES: [f64; POINTS] = [
    0.057_104_196_114_517_68,
    0.276_843_013_638_123_8,
    0.583_590_432_368_916_8,
    0.860_240_135_656_219_5,
    1.0,
];

/// Weights of the rates at the points, for the change from the start to each point.
pub fn weights() -> [[f64; POINTS]; POINTS] {
    let mut weights = [[0.0; POINTS]; POINTS];
    for j in 0..POINTS {
        // The polynomial that is 1 at point j and 0 at the others, by rising powers.
        let mut polynomial = vec![1.0];
        let others = NODES.iter().enumerate().filter(|(m, _)| *m != j);
        for (_, node) in others {
            let scale = 1.0 / (NODES[j] - node);
            let mut next = vec![0.0; polynomial.len() + 1];
            for (k, c) in polynomial.iter().enumerate() {
                next[k] -= node * scale * c;
                next[k + 1] += scale * c;
            }
            polynomial = next;
        }
        for i in 0..POINTS {
            let falling = polynomial.iter().enumerate().rev();
            let integral = falling.fold(0.0, |sum, (k, c)| sum * NODES[i] + c / (k + 1) as f64);
            weights[i][j] = integral * NODES[i];
        }
    }
    weights
}

/// Solves A x = b by elimination with the largest pivots; A by rows. False if A is singular.
pub fn eliminate(a: &mut [f64], b: &mut [f64]) -> bool {
    let n = b.len();
    for column in 0..n {
        let size = |row: &usize| a[row * n + column].abs();
        let Some(pivot) = (column..n).max_by(|i, j| size(i).total_cmp(&size(j))) else {
            return false;
        };
        if size(&pivot) <= 0.0 || !size(&pivot).is_finite() {
            return false;
        }
        for k in 0..n {
            a.swap(column * n + k, pivot * n + k);
        }
        b.swap(column, pivot);
        for row in column + 1..n {
            let factor = a[row * n + column] / a[column * n + column];
            for k in column..n {
                a[row * n + k] -= factor * a[column * n + k];
            }
            b[row] -= factor * b[column];
        }
    }
    for row in (0..n).rev() {
        let known: f64 = (row + 1..n).map(|k| a[row * n + k] * b[k]).sum();
        b[row] = (b[row] - known) / a[row * n + row];
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Weights of order 9 at the end of a step, and of order 5 at the points, integrate these powers.
    #[test]
    fn powers_are_integrated() {
        let weights = weights();
        for power in 0..9 {
            let integral = |row: &[f64; POINTS]| -> f64 {
                let terms = row.iter().zip(NODES);
                terms.map(|(w, x)| w * x.powi(power)).sum()
            };
            let rows = if power < 5 { 0 } else { POINTS - 1 };
            for (row, x) in weights.iter().zip(NODES).skip(rows) {
                let known = x.powi(power + 1) / f64::from(power + 1);
                // Round-off of polynomials whose coefficients are up to 40.
                assert!((integral(row) - known).abs() < 1e-14, "{power}");
            }
        }
    }

    #[test]
    fn a_matrix_without_a_first_pivot_is_eliminated() {
        let (mut a, mut b) = (vec![0.0, 2.0, 1.0, 3.0], vec![4.0, 5.0]);
        assert!(eliminate(&mut a, &mut b));
        assert_eq!(b, [-1.0, 2.0]);
        assert!(!eliminate(&mut [1.0, 2.0, 2.0, 4.0], &mut [1.0, 1.0]));
    }
}
