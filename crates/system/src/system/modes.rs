//! Modes of a linear structure, mass-normalised, with a row of contacts each.

use crate::methods::Mode;
use nalgebra::{DMatrix, DVector, SymmetricEigen};

/// The mass-normalised modes of a structure with any number of contacts, by rising frequency: q_k'' + omega2_k q_k =
/// -sum phi_kc S_c, r_c = sum phi_kc q_k.
#[derive(Debug, Clone)]
pub struct Modal {
    /// omega_k^2, >= 0.
    pub omega2: Vec<f64>,
    /// phi_kc: a row for each mode, a column for each contact.
    pub phi: DMatrix<f64>,
    /// Maps displacements or velocities of the degrees of freedom to q, modes by degrees of freedom.
    to_modes: DMatrix<f64>,
}

impl Modal {
    /// Modes of M u'' + K u + B S = 0 for symmetric positive definite M and symmetric K, from a symmetric eigensolver. B has a
    /// column b for each contact, r = b^T u.
    ///
    /// `None` where M is not positive definite.
    pub fn new(m: &DMatrix<f64>, k: &DMatrix<f64>, b: &DMatrix<f64>) -> Option<Modal> {
        // M = L L^T turns the pair into the one symmetric matrix L^-1 K L^-T.
        let lower = m.clone().cholesky()?.l();
        let half = lower.solve_lower_triangular(k)?;
        let standard = lower.solve_lower_triangular(&half.transpose())?;
        let eigen = SymmetricEigen::new((&standard + standard.transpose()) * 0.5);
        let size = m.nrows();
        let mut order: Vec<usize> = (0..size).collect();
        order.sort_by(|&i, &j| eigen.eigenvalues[i].total_cmp(&eigen.eigenvalues[j]));
        let mut omega2 = Vec::with_capacity(size);
        let mut phi = DMatrix::zeros(size, b.ncols());
        let mut to_modes = DMatrix::zeros(size, size);
        for (row, &i) in order.iter().enumerate() {
            let shape = lower
                .transpose()
                .solve_upper_triangular(&eigen.eigenvectors.column(i))?;
            // Round-off can leave a rigid-body mode slightly below zero.
            omega2.push(eigen.eigenvalues[i].max(0.0));
            phi.set_row(row, &(shape.transpose() * b));
            to_modes.set_row(row, &(m * shape).transpose());
        }
        Some(Modal {
            omega2,
            phi,
            to_modes,
        })
    }

    /// The modes as one contact sees them, in its scaled coordinates.
    pub fn modes(&self, contact: usize) -> Vec<Mode> {
        let phi = self.phi.column(contact);
        let modes = self.omega2.iter().zip(phi.iter());
        modes
            .map(|(&omega2, phi)| Mode::new(omega2, phi * phi))
            .collect()
    }

    /// The scaled coordinates of a contact, its shares in r or rdot, for displacements or velocities of the degrees of freedom.
    pub fn shares(&self, contact: usize, u: &DVector<f64>) -> DVector<f64> {
        (&self.to_modes * u).component_mul(&self.phi.column(contact))
    }

    /// Kinetic and strain energy at these displacements and velocities of the degrees of freedom.
    pub fn energy(&self, u: &DVector<f64>, v: &DVector<f64>) -> f64 {
        let (q, rate) = (&self.to_modes * u, &self.to_modes * v);
        let terms = q.iter().zip(rate.iter()).zip(&self.omega2);
        terms
            .map(|((q, rate), omega2)| 0.5 * (rate * rate + omega2 * q * q))
            .sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{dmatrix, dvector};

    fn three() -> (DMatrix<f64>, DMatrix<f64>, DMatrix<f64>) {
        (
            dmatrix![2.0, 0.3, 0.0; 0.3, 1.0, -0.2; 0.0, -0.2, 0.5],
            dmatrix![3.0, -1.0, 0.0; -1.0, 2.5, -1.5; 0.0, -1.5, 2.0],
            dmatrix![-1.0, 0.0; 0.0, 1.0; 1.0, 0.0],
        )
    }

    #[test]
    fn modes_answer_forces_as_the_matrices_do() {
        // B^T (K + s M)^-1 B = sum phi phi^T/(omega2 + s) for every s: three values of s fix all three modes.
        let (m, k, b) = three();
        let modal = Modal::new(&m, &k, &b).unwrap();
        for s in [0.0, 0.7, 10.0, 1000.0] {
            let direct = b.transpose() * (&k + &m * s).lu().solve(&b).unwrap();
            let weights = DVector::from_fn(3, |i, _| 1.0 / (modal.omega2[i] + s));
            let sum = modal.phi.transpose() * DMatrix::from_diagonal(&weights) * &modal.phi;
            // Round-off of a 3 by 3 solver and eigensolver.
            let tolerance = 1e-13 * direct.amax();
            assert!(
                (&sum - &direct).amax() < tolerance,
                "s = {s}: {sum} {direct}"
            );
            let seen: f64 = modal
                .modes(0)
                .iter()
                .map(|mode| mode.phi2 / (mode.omega2 + s))
                .sum();
            assert!((seen - direct[(0, 0)]).abs() < tolerance, "s = {s}");
        }
        assert!(modal.omega2.is_sorted());
    }

    #[test]
    fn shares_sum_to_r_and_all_modes_carry_the_energy() {
        let (m, k, b) = three();
        let modal = Modal::new(&m, &k, &b).unwrap();
        let (u, v) = (dvector![0.7, -1.3, 2.1], dvector![0.2, 1.1, -0.4]);
        for contact in 0..2 {
            let r = b.column(contact).dot(&u);
            assert!((modal.shares(contact, &u).sum() - r).abs() < 1e-14 * 10.0);
        }
        let direct = 0.5 * (v.dot(&(&m * &v)) + u.dot(&(&k * &u)));
        assert!((modal.energy(&u, &v) / direct - 1.0).abs() < 1e-12);
        let [x, rate] = [&u, &v].map(|u| modal.shares(0, u));
        let modes = modal.modes(0);
        let seen: f64 = (0..3).map(|i| modes[i].energy(x[i], rate[i])).sum();
        assert!((seen / direct - 1.0).abs() < 1e-12);
    }

    #[test]
    fn a_mode_that_a_contact_does_not_move_has_energy_and_no_share() {
        // Two equal masses on equal springs to the ground, joined by a third: they move together or against each other. A
        // contact between them sees only the second.
        let modal = Modal::new(
            &DMatrix::identity(2, 2),
            &dmatrix![2.0, -1.0; -1.0, 2.0],
            &dmatrix![-1.0; 1.0],
        )
        .unwrap();
        let (u, v) = (dvector![0.3, 0.3], dvector![0.5, 0.5]);
        assert!(modal.shares(0, &u).amax() < 1e-15);
        assert!((modal.energy(&u, &v) - 0.5 * (2.0 * 0.25 + 2.0 * 0.09)).abs() < 1e-14);
        let unmoved = Mode::new(1.0, 0.0);
        assert_eq!(unmoved.energy(0.0, 0.0), 0.0);
    }

    #[test]
    fn free_structures_have_a_rigid_mode_and_bad_masses_none() {
        // Two masses on one spring: omega^2 = 0 and k (1/m1 + 1/m2), all of the relative motion in the second.
        let modal = Modal::new(
            &dmatrix![2.0, 0.0; 0.0, 3.0],
            &dmatrix![6.0, -6.0; -6.0, 6.0],
            &dmatrix![-1.0; 1.0],
        )
        .unwrap();
        let modes = modal.modes(0);
        let [rigid, other] = [modes[0], modes[1]];
        assert!((0.0..1e-14).contains(&rigid.omega2) && rigid.phi2 < 1e-14);
        assert!((other.omega2 - 5.0).abs() < 1e-14 * 5.0 && (other.phi2 - 5.0 / 6.0).abs() < 1e-14);
        let (_, k, b) = three();
        assert!(Modal::new(&DMatrix::from_diagonal(&dvector![1.0, 0.0, 1.0]), &k, &b).is_none());
    }
}
