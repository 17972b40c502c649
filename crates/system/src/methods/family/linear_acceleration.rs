//! The linear acceleration method.

use crate::methods::{Coefficients, Description, Method};

/// Names and parameters.
pub(in crate::methods) const DESCRIPTION: Description = Description {
    name: "linear-acceleration",
    meaning: "linear acceleration, Newmark's method with beta = 1/6, gamma = 1/2",
    parameters: &[],
    method: |_| Some(Method::Family(Coefficients::linear_acceleration())),
};

impl Coefficients {
    /// The linear acceleration method (Newmark 1959): beta = 1/6, gamma = 1/2, stable up to omega dt = sqrt(12).
    pub const fn linear_acceleration() -> Self {
        Self::newmark(1.0 / 6.0, 0.5)
    }
}
