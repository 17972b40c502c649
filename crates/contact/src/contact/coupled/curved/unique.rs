//! Whether the forces of a step are unique.

use super::{CurvedForces, LEVEL, Numbers};
use crate::contact::coupled::factor::Factor;
use crate::contact::coupled::matrix::{Matrix, ROUND_OFF};

impl CurvedForces {
    /// Whether the forces are the only ones: contacts whose forces can change are not singular.
    pub(super) fn is_unique(&self, step: Numbers) -> bool {
        if !self.singular {
            return true;
        }
        let m = self.contacts;
        let mut matrix = self.flexibility.clone();
        let mut free = Vec::new();
        let mut i = 0;
        while i < m {
            if step.laws.is_plane(i) {
                // A motion that is given has the forces of the law.
                if self.own[i] <= 0.0 {
                    i += 2;
                    continue;
                }
                let pair = |of: &[f64]| [of[i], of[i + 1]];
                let (y, force) = (pair(&self.now.y), pair(&self.now.answer));
                // In the directions of the law, so that no large 1/f' along hides what is left across.
                let directions = step.laws.directions(i, y, force);
                turn(&mut matrix, m, i, directions.along);
                for (row, slope) in directions.slopes.into_iter().enumerate() {
                    let (row, slope) = (i + row, slope.max(0.0));
                    if slope < LEVEL * self.own[i] {
                        free.push(row);
                        matrix[row * m + row] += slope;
                    }
                }
                i += 2;
                continue;
            }
            let y = self.now.y[i];
            let width = 10.0 * ROUND_OFF * self.now.terms[i];
            let compliance = [y - width, y, y + width].map(|y| {
                let force = step.laws.answer(i, y);
                step.compliance(i, y, force, width)
            });
            let least = compliance.into_iter().fold(f64::INFINITY, f64::min);
            if least < LEVEL * self.own[i] {
                free.push(i);
                matrix[i * m + i] += least;
            }
            i += 1;
        }
        Factor::new(m).compute(&Matrix::new(matrix, m), &free)
    }
}

/// Turns the rows and columns i and i + 1 of a symmetric matrix to a unit vector and the direction across it.
fn turn(matrix: &mut [f64], m: usize, i: usize, [x, z]: [f64; 2]) {
    let turned = |first: f64, second: f64| (x * first + z * second, x * second - z * first);
    for k in 0..m {
        let (row, next) = (i * m + k, (i + 1) * m + k);
        (matrix[row], matrix[next]) = turned(matrix[row], matrix[next]);
    }
    for k in 0..m {
        let (column, next) = (k * m + i, k * m + i + 1);
        (matrix[column], matrix[next]) = turned(matrix[column], matrix[next]);
    }
}
