//! The generalised-alpha method.

use crate::methods::{Coefficients, Description, Method, MethodParameter};
use crate::range::Range;

/// Names and parameters.
pub(in crate::methods) const DESCRIPTION: Description = Description {
    name: "generalized-alpha",
    meaning: "generalized-alpha method of Chung and Hulbert (1993), numerical damping by rho_inf",
    parameters: &[MethodParameter {
        name: "rho_inf",
        symbol: "*ρ*_∞_",
        range: Range::UpToOne,
        default: 0.8,
        tried: &[0.0, 0.5, 0.8],
        meaning: "spectral radius of a mode of infinite frequency; no numerical damping at 1",
    }],
    method: |numbers| match *numbers {
        [rho_inf] => Some(Method::Family(Coefficients::generalized_alpha(rho_inf))),
        _ => None,
    },
};

impl Coefficients {
    /// The generalised-alpha method of Chung and Hulbert (1993), with the spectral radius `rho_inf` in [0, 1] at infinite
    /// frequency: alpha_m = (2 rho - 1)/(rho + 1), alpha_f = rho/(rho + 1), beta = (1 - alpha_m + alpha_f)^2/4,
    /// gamma = 1/2 - alpha_m + alpha_f.
    pub const fn generalized_alpha(rho_inf: f64) -> Self {
        let alpha_m = (2.0 * rho_inf - 1.0) / (rho_inf + 1.0);
        let alpha_f = rho_inf / (rho_inf + 1.0);
        let shift = 1.0 - alpha_m + alpha_f;
        Coefficients {
            alpha_m,
            alpha_f,
            beta: 0.25 * shift * shift,
            gamma: shift - 0.5,
        }
    }
}
