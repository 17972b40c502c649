//! A mode of a structure with one contact.

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
    /// An undamped mode with omega^2 and phi^2.
    pub const fn new(omega2: f64, phi2: f64) -> Mode {
        Mode { omega2, phi2 }
    }

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
