//! Forces or impulses that minimise 1/2 S^T A S - S^T d between bounds, unique or not.
//!
//! Where contacts depend on each other, A is singular. The motion is unique all the same, and so are the forces with the smallest
//! sum of A_ii S_i^2: equal contacts have equal forces, as far as their bounds allow.

use super::cholesky::{Cholesky, regular};
use crate::contact::CoupledForces;

/// There are no forces: a contact between the ground and itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Singular;

/// Computes the forces; the result is whether they are unique.
pub fn least(
    matrix: Vec<f64>,
    d: &[f64],
    [low, high]: &[Vec<f64>; 2],
    size: &[f64],
    force: &mut [f64],
) -> Result<bool, Singular> {
    let m = d.len();
    let unique = Cholesky::new(matrix.clone(), m).is_some();
    let other = if unique {
        matrix.clone()
    } else {
        regular(&matrix, m)
    };
    let mut problem = CoupledForces::new(other, m);
    problem
        .solve(d, low, high, size, force)
        .map_err(|_| Singular)?;
    if !unique {
        let free: Vec<usize> = (0..m).filter(|i| problem.is_free(*i)).collect();
        balance(&matrix, &free, d, force)?;
    }
    Ok(unique)
}

/// Computes the free forces again, with the matrix itself.
fn balance(matrix: &[f64], free: &[usize], d: &[f64], force: &mut [f64]) -> Result<(), Singular> {
    let m = d.len();
    let rows = free.iter().map(|i| &matrix[i * m..(i + 1) * m]);
    let block = rows.clone().flat_map(|row| free.iter().map(|j| row[*j]));
    let factor = Cholesky::of_any(block.collect(), free.len()).ok_or(Singular)?;
    let residuals = free.iter().zip(rows);
    let mut change: Vec<f64> = residuals
        .map(|(i, row)| d[*i] - row.iter().zip(&*force).map(|(a, s)| a * s).sum::<f64>())
        .collect();
    factor.solve(&mut change);
    for (i, change) in free.iter().zip(change) {
        force[*i] += change;
    }
    Ok(())
}
