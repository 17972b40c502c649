//! The forces of contacts in a plane without compliance.
//!
//! A contact that sticks keeps its velocity: B^T a + G'' = 0.

use crate::exact::events::Model;
use crate::exact::events::numerics::cholesky::Cholesky;

/// Least limit over the largest one by which forces are shared.
const LEAST: f64 = 1e-3;

/// The accelerations that contacts leave: a of the coordinates, and G'' of each gap.
pub struct Accelerations<'a> {
    /// M a without the contacts whose forces are wanted.
    pub sums: &'a [f64],
    /// G'' of each contact.
    pub gaps: &'a dyn Fn(usize) -> f64,
}

/// The forces that hold these rows. Contacts that hold a body together share its force as their limits.
pub fn held(model: &Model, rows: &[usize], of: &Accelerations, limits: &[f64]) -> Vec<f64> {
    let a: Vec<f64> = of
        .sums
        .iter()
        .zip(&model.inverse_masses)
        .map(|(sum, w)| sum * w)
        .collect();
    let mut forces: Vec<f64> = rows
        .iter()
        .map(|row| model.columns[*row].dot(&a) + (of.gaps)(*row))
        .collect();
    let most = limits.iter().copied().fold(0.0, f64::max);
    let weight = |i: usize| match most > 0.0 {
        true => most / limits[i].max(LEAST * most),
        false => 1.0,
    };
    if let Some(factor) = Cholesky::sharing(model.flexibility(rows), rows.len(), weight) {
        factor.solve(&mut forces);
    }
    forces
}
