//! The forces of contacts in a plane without compliance.
//!
//! A contact that sticks keeps its velocity: B^T a + G'' = 0. One that begins to slide has the limit along the force that would hold it.

use super::plane::Phase;
use crate::exact::events::Model;
use crate::exact::events::cholesky::Cholesky;

/// The accelerations that contacts leave: a of the coordinates, and G'' of each gap.
pub struct Accelerations<'a> {
    /// M a without the contacts whose forces are wanted.
    pub sums: &'a [f64],
    /// G'' of each contact.
    pub gaps: &'a dyn Fn(usize) -> f64,
}

/// The forces that hold these rows.
pub fn held(model: &Model, rows: &[usize], of: &Accelerations) -> Vec<f64> {
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
    let m = rows.len();
    let mut matrix = vec![0.0; m * m];
    for (i, row) in rows.iter().enumerate() {
        for (j, other) in rows.iter().enumerate() {
            matrix[i * m + j] =
                model.columns[*row].form(&model.inverse_masses, &model.columns[*other]);
        }
    }
    // Contacts of one body in one direction share its force.
    if let Some(factor) = Cholesky::of_any(matrix, m) {
        factor.solve(&mut forces);
    }
    forces
}

/// The rows of contacts in a plane whose phase this is, by their first rows.
pub fn rows(phases: &[(usize, Phase)], wanted: impl Fn(Phase) -> bool) -> Vec<usize> {
    let own = phases.iter().filter(|(_, phase)| wanted(*phase));
    own.flat_map(|(first, _)| [*first, *first + 1]).collect()
}
