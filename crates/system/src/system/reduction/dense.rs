//! All modes of a small structure, by full matrices.

use super::ReductionFault;
use super::held::Held;
use super::mode::Mode;
use crate::system::structure::sparse::factor::Factor;
use nalgebra::SymmetricEigen;

/// All modes of the free rows; the rows without mass follow those with mass, u_s = -K_ss^-1 K_sr u_r.
pub(super) fn all_modes(of: &Held) -> Result<Vec<Mode>, ReductionFault> {
    let (massive, massless) = (&of.massive, &of.massless);
    if massive.is_empty() {
        return Ok(Vec::new());
    }
    let following = following(of)?;
    // K_rr - K_rs K_ss^-1 K_sr.
    let mut stiffness = of.stiffness.block(massive).full();
    for ((i, j), k) in of.stiffness.entries() {
        for (row, column) in [(i, j), (j, i)] {
            let places = (massive.binary_search(&row), massless.binary_search(&column));
            if let (Ok(row), Ok(column)) = places {
                for (other, follower) in following.iter().enumerate() {
                    stiffness[(row, other)] += k * follower[column];
                }
            }
        }
    }
    let no_mass = || ReductionFault::Mass;
    let root = of
        .mass
        .block(massive)
        .full()
        .cholesky()
        .ok_or_else(no_mass)?
        .l();
    let left = root
        .solve_lower_triangular(&stiffness)
        .ok_or_else(no_mass)?;
    let scaled = root
        .solve_lower_triangular(&left.transpose())
        .ok_or_else(no_mass)?;
    let eigen = SymmetricEigen::new((&scaled + scaled.transpose()) * 0.5);
    let shapes = root
        .tr_solve_lower_triangular(&eigen.eigenvectors)
        .ok_or_else(no_mass)?;
    let pairs = eigen.eigenvalues.iter().zip(shapes.column_iter());
    let mut modes: Vec<Mode> = pairs
        .map(|(omega2, massive_shape)| {
            let mut shape = vec![0.0; of.free.len()];
            for ((row, x), follower) in massive.iter().zip(massive_shape.iter()).zip(&following) {
                shape[*row] = *x;
                for (massless, factor) in massless.iter().zip(follower) {
                    shape[*massless] += factor * x;
                }
            }
            Mode {
                omega2: *omega2,
                shape,
            }
        })
        .collect();
    modes.sort_by(|a, b| a.omega2.total_cmp(&b.omega2));
    Ok(modes)
}

/// For each row with mass the displacements of the rows without mass where it is displaced by 1: a column of -K_ss^-1 K_sr.
fn following(of: &Held) -> Result<Vec<Vec<f64>>, ReductionFault> {
    let (massive, massless) = (&of.massive, &of.massless);
    let mut columns = vec![vec![0.0; massless.len()]; massive.len()];
    if massless.is_empty() {
        return Ok(columns);
    }
    // K_ff is positive definite, so that K_ss is.
    let of_massless = of.stiffness.block(massless);
    let factor = Factor::new(&of_massless, &vec![false; of_massless.size()])
        .map_err(|_| ReductionFault::Mass)?;
    for ((i, j), k) in of.stiffness.entries() {
        for (row, column) in [(i, j), (j, i)] {
            if let (Ok(row), Ok(column)) =
                (massless.binary_search(&row), massive.binary_search(&column))
            {
                columns[column][row] -= k;
            }
        }
    }
    columns.iter_mut().for_each(|column| factor.solve(column));
    Ok(columns)
}
