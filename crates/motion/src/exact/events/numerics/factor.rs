//! The factor of the equations of constraints.

use super::cholesky::Cholesky;
use nalgebra::{DVectorViewMut, Dyn, LU};

/// B^T M^-1 B of constraints, or, where they press friction that slides, the matrix with this friction in it.
#[derive(Debug, Clone)]
pub enum Factor {
    /// Symmetric.
    Symmetric(Cholesky),
    /// Not symmetric.
    Pressed(LU<f64, Dyn, Dyn>),
}

impl Default for Factor {
    fn default() -> Factor {
        Factor::Symmetric(Cholesky::default())
    }
}

impl Factor {
    /// Solves A x = b in place.
    pub fn solve(&self, b: &mut [f64]) {
        match self {
            Factor::Symmetric(factor) => factor.solve(b),
            Factor::Pressed(factor) => {
                let mut x = DVectorViewMut::from_slice(b, b.len());
                factor.solve_mut(&mut x);
            }
        }
    }
}
