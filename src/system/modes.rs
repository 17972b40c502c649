//! Modes of a linear structure, each scaled by its share in the relative displacement r = b^T u of a contact.

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

impl Mode {
    /// Kinetic and strain energy at coordinate `x` and velocity `v`; zero for a mode that the contact does not move, whose
    /// coordinate is always zero.
    pub fn energy(&self, x: f64, v: f64) -> f64 {
        if self.phi2 > 0.0 {
            0.5 * (v * v + self.omega2 * x * x) / self.phi2
        } else {
            0.0
        }
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{dmatrix, dvector};

    fn three() -> (DMatrix<f64>, DMatrix<f64>, DVector<f64>) {
        (
            dmatrix![2.0, 0.3, 0.0; 0.3, 1.0, -0.2; 0.0, -0.2, 0.5],
            dmatrix![3.0, -1.0, 0.0; -1.0, 2.5, -1.5; 0.0, -1.5, 2.0],
            dvector![-1.0, 0.0, 1.0],
        )
    }

    #[test]
    fn modes_answer_a_force_as_the_matrices_do() {
        // b^T (K + s M)^-1 b = sum phi2/(omega2 + s) for every s: three values of s fix all three modes.
        let (m, k, b) = three();
        let modal = Modal::new(&m, &k, &b).unwrap();
        for s in [0.0, 0.7, 10.0, 1000.0] {
            let direct = b.dot(&(&k + &m * s).lu().solve(&b).unwrap());
            let sum: f64 = modal
                .modes
                .iter()
                .map(|mode| mode.phi2 / (mode.omega2 + s))
                .sum();
            // Round-off of a 3 by 3 solver and eigensolver.
            assert!(
                (sum / direct - 1.0).abs() < 1e-13,
                "s = {s}: {sum} {direct}"
            );
        }
        assert!(modal.modes.is_sorted_by_key(|mode| mode.omega2));
    }

    #[test]
    fn scaled_coordinates_share_r_and_carry_the_energy() {
        let (m, k, b) = three();
        let modal = Modal::new(&m, &k, &b).unwrap();
        let u = dvector![0.7, -1.3, 2.1];
        let x = &modal.to_modes * &u;
        assert!((x.sum() - b.dot(&u)).abs() < 1e-14 * 10.0);
        let pairs = || x.iter().zip(&modal.modes);
        let kinetic: f64 = pairs().map(|(x, mode)| x * x / mode.phi2).sum();
        let strain: f64 = pairs()
            .map(|(x, mode)| mode.omega2 * x * x / mode.phi2)
            .sum();
        assert!((kinetic / u.dot(&(&m * &u)) - 1.0).abs() < 1e-12);
        assert!((strain / u.dot(&(&k * &u)) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn free_structures_have_a_rigid_mode_and_bad_masses_none() {
        // Two masses on one spring: omega^2 = 0 and k (1/m1 + 1/m2), all of the relative motion in the second.
        let modal = Modal::new(
            &dmatrix![2.0, 0.0; 0.0, 3.0],
            &dmatrix![6.0, -6.0; -6.0, 6.0],
            &dvector![-1.0, 1.0],
        )
        .unwrap();
        let [rigid, other] = [modal.modes[0], modal.modes[1]];
        assert!((0.0..1e-14).contains(&rigid.omega2) && rigid.phi2 < 1e-14);
        assert!((other.omega2 - 5.0).abs() < 1e-14 * 5.0 && (other.phi2 - 5.0 / 6.0).abs() < 1e-14);
        let (_, k, b) = three();
        assert!(Modal::new(&DMatrix::from_diagonal(&dvector![1.0, 0.0, 1.0]), &k, &b).is_none());
    }
}
