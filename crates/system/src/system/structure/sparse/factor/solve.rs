//! Solutions with a factor.

use super::{Columns, Factor, Triangle};
use crate::lane::Lane;

impl Factor {
    /// Replaces b by A^-1 b, in the order of the matrix.
    pub fn solve(&self, b: &mut [f64]) {
        let order = self.order();
        let mut x: Vec<f64> = order.iter().map(|row| b[*row]).collect();
        match &self.triangle {
            Triangle::Columns {
                reciprocals,
                columns,
            } => solve(reciprocals, columns, &mut x),
            Triangle::Blocks(blocks) => {
                let mut lanes: Vec<Lane<1>> = x.iter().map(|x| Lane([*x])).collect();
                blocks.eliminate(&mut lanes);
                blocks.substitute(&mut lanes);
                for (x, lane) in x.iter_mut().zip(lanes) {
                    *x = lane.0[0];
                }
            }
        }
        for (row, x) in order.iter().zip(x) {
            b[*row] = x;
        }
    }
}

fn solve(reciprocals: &[f64], columns: &Columns, x: &mut [f64]) {
    for i in 0..x.len() {
        for entry in columns.column(i).iter().rev() {
            x[entry.at] -= entry.value * x[i];
        }
    }
    for i in (0..x.len()).rev() {
        let column = columns.column(i).iter();
        let sum: f64 = column.map(|entry| entry.value * x[entry.at]).sum();
        x[i] = x[i] * reciprocals[i] - sum;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::structure::Symmetric;

    #[test]
    fn the_solution_fulfils_the_equations() {
        let mut matrix = Symmetric::zeros(5);
        for (i, j, k) in [
            (0, 1, 3.0),
            (1, 4, 2.0),
            (4, 2, 7.0),
            (2, 3, 1.0),
            (0, 3, 0.5),
        ] {
            matrix.add_spring([Some(i), Some(j)], k);
        }
        matrix.add_spring([None, Some(2)], 1.5);
        let x = [1.0, -2.0, 0.25, 4.0, 3.0];
        let mut b = [0.0; 5];
        matrix.add_product(&x, &mut b);
        let factor = Factor::new(&matrix, &[false; 5]).unwrap();
        factor.solve(&mut b);
        for (solved, x) in b.iter().zip(x) {
            // Round-off times a condition of about 30.
            assert!((solved - x).abs() < 1e-13);
        }
    }
}
