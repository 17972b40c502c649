//! The central difference method.

use crate::methods::{Coefficients, Description, Method};

/// Names and parameters.
pub(in crate::methods) const DESCRIPTION: Description = Description {
    name: "central-difference",
    meaning: "central differences, explicit; stable up to the critical step 2/omega_max",
    parameters: &[],
    method: |_| Some(Method::Family(Coefficients::central_difference())),
};

impl Coefficients {
    /// The central difference method in Newmark's form: beta = 0, gamma = 1/2. r at the end of a step does not depend on the
    /// contact's force there.
    pub const fn central_difference() -> Self {
        Self::newmark(0.0, 0.5)
    }
}
