//! Modes of the pair of bars with the contact open, and with the spring between the bars.
//!
//! With the contact open, the mass-normalised coordinates q_k give r = sum phi_k q_k. The spring adds the energy K r^2/2. So the
//! modes in contact are the eigenvectors of diag(omega_k^2) + K phi phi^T, and their eigenvalues lambda are the roots of
//!
//! ```text
//! 1 = K sum phi_k^2/(lambda - omega_k^2)
//! ```
//!
//! There is one root above each omega_k^2. Mode i has in q_k the component K psi_i phi_k/(lambda_i - omega_k^2), where psi_i is
//! its participation in r.

use crate::exact::bisect;
use crate::system::Mode;
use libm::sqrt;

/// Frequencies and participations in r of mass-normalised coordinates.
#[derive(Debug, Clone)]
pub(super) struct ModalBasis {
    pub omega: Vec<f64>,
    /// phi_k > 0 in r = sum phi_k q_k.
    pub phi: Vec<f64>,
}

impl ModalBasis {
    /// The modes with the contact open.
    pub fn free(modes: &[Mode]) -> ModalBasis {
        ModalBasis {
            omega: modes.iter().map(|mode| sqrt(mode.omega2)).collect(),
            phi: modes.iter().map(|mode| sqrt(mode.phi2)).collect(),
        }
    }
}

/// The modes with the spring between the bars, and the transformation from and to the free ones.
#[derive(Debug, Clone)]
pub(super) struct ContactModes {
    pub basis: ModalBasis,
    /// The components of each mode in the free coordinates, one row for each mode.
    shapes: Vec<Vec<f64>>,
}

/// Displacements and rates of modal coordinates.
pub(super) type Coordinates = (Vec<f64>, Vec<f64>);

impl ContactModes {
    pub fn new(modes: &[Mode], spring: f64) -> ContactModes {
        let mut basis = ModalBasis {
            omega: Vec::new(),
            phi: Vec::new(),
        };
        let mut shapes = Vec::new();
        for i in 0..modes.len() {
            // lambda - omega_k^2 for every k, from the pole below, so that a small difference keeps its digits.
            let shift = shift(modes, spring, i);
            let difference = |k: &Mode| pole_distance(modes, i, k) + shift;
            let squares = |k: &Mode| k.phi2 / (difference(k) * difference(k));
            let sum: f64 = modes.iter().map(squares).sum();
            let psi = 1.0 / (spring * sqrt(sum));
            let component = |k: &Mode| spring * psi * sqrt(k.phi2) / difference(k);
            shapes.push(modes.iter().map(component).collect());
            basis.omega.push(sqrt(modes[i].omega2 + shift));
            basis.phi.push(psi);
        }
        ContactModes { basis, shapes }
    }

    /// From free coordinates to those in contact.
    pub fn contact_coordinates(&self, q: &[f64], rate: &[f64]) -> Coordinates {
        let transform = |q: &[f64]| {
            let project = |shape: &Vec<f64>| shape.iter().zip(q).map(|(s, q)| s * q).sum();
            self.shapes.iter().map(project).collect()
        };
        (transform(q), transform(rate))
    }

    /// From coordinates in contact to the free ones.
    pub fn free_coordinates(&self, y: &[f64], rate: &[f64]) -> Coordinates {
        let transform = |y: &[f64]| {
            let mut q = vec![0.0; y.len()];
            for (shape, y) in self.shapes.iter().zip(y) {
                for (q, s) in q.iter_mut().zip(shape) {
                    *q += s * y;
                }
            }
            q
        };
        (transform(y), transform(rate))
    }
}

/// omega_i^2 - omega_k^2.
fn pole_distance(modes: &[Mode], i: usize, k: &Mode) -> f64 {
    modes[i].omega2 - k.omega2
}

/// lambda_i - omega_i^2 of root `i` of the frequency equation.
fn shift(modes: &[Mode], spring: f64, i: usize) -> f64 {
    // The left side falls from infinity above the pole.
    let past = |shift: f64| {
        let term = |k: &Mode| k.phi2 / (pole_distance(modes, i, k) + shift);
        let excess = spring * modes.iter().map(term).sum::<f64>() - 1.0;
        excess <= 0.0
    };
    // The last root is at most omega^2 + K phi^T phi; the factor 2 covers round-off.
    let top = 2.0 * spring * modes.iter().map(|k| k.phi2).sum::<f64>();
    let next = modes.get(i + 1);
    let limit = next.map_or(top, |next| pole_distance(modes, i, next).abs());
    let [low, high] = bisect([0.0, limit], past);
    0.5 * (low + high)
}
