//! A linear structure as its modes, seen through one relative displacement r = b^T u.

pub mod bar;

use nalgebra::{DMatrix, DVector, SymmetricEigen};

/// One mode in the scaled coordinate x_k = phi_k q_k, which is its own share of r = sum x_k.
///
/// With mass-normalised shapes, phi_k = b^T shape_k, and a resisting force S: x_k'' + omega2 x_k = -phi2 S.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mode {
    /// omega_k^2, >= 0; zero for a rigid-body mode.
    pub omega2: f64,
    /// phi_k^2, the inverse of the mass that the contact feels in this mode.
    pub phi2: f64,
}

/// A structure with its modes from a symmetric eigensolver.
#[derive(Debug, Clone)]
pub struct Modal {
    /// The modes, by rising frequency.
    pub modes: Vec<Mode>,
    /// Maps displacements or velocities of the degrees of freedom to scaled coordinates, modes by degrees of freedom.
    pub to_modes: DMatrix<f64>,
}

impl Modal {
    /// Modes of M u'' + K u + b S = 0 for symmetric positive definite M and symmetric K.
    ///
    /// `None` where M is not positive definite.
    pub fn new(m: &DMatrix<f64>, k: &DMatrix<f64>, b: &DVector<f64>) -> Option<Modal> {
        // M = L L^T turns the pair into the one symmetric matrix L^-1 K L^-T.
        let lower = m.clone().cholesky()?.l();
        let half = lower.solve_lower_triangular(k)?;
        let standard = lower.solve_lower_triangular(&half.transpose())?;
        let eigen = SymmetricEigen::new((&standard + standard.transpose()) * 0.5);
        let mut order: Vec<usize> = (0..b.len()).collect();
        order.sort_by(|&i, &j| eigen.eigenvalues[i].total_cmp(&eigen.eigenvalues[j]));
        let mut modes = Vec::new();
        let mut to_modes = DMatrix::zeros(b.len(), b.len());
        for (row, &i) in order.iter().enumerate() {
            let shape = lower
                .transpose()
                .solve_upper_triangular(&eigen.eigenvectors.column(i))?;
            let phi = b.dot(&shape);
            modes.push(Mode {
                // Round-off can leave a rigid-body mode slightly below zero.
                omega2: eigen.eigenvalues[i].max(0.0),
                phi2: phi * phi,
            });
            // q = shape^T M u, x = phi q
            to_modes.set_row(row, &((m * shape).transpose() * phi));
        }
        Some(Modal { modes, to_modes })
    }
}
