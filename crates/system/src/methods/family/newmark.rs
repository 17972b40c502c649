//! Newmark's method.

use crate::methods::{Coefficients, Description, Method, MethodParameter};
use crate::range::Range;

/// Names and parameters.
pub(in crate::methods) const DESCRIPTION: Description = Description {
    name: "newmark",
    meaning: "Newmark's method with newmark_beta and newmark_gamma (Newmark 1959)",
    parameters: &[
        MethodParameter {
            name: "newmark_beta",
            symbol: "*β*_N_",
            range: Range::NotNegative,
            default: 0.3025,
            // The best damping of high frequencies at this gamma: beta = (gamma + 1/2)^2/4.
            tried: &[0.3025],
            meaning: "Newmark's beta; stable at every step if 2 beta >= gamma >= 1/2",
        },
        MethodParameter {
            name: "newmark_gamma",
            symbol: "*γ*_N_",
            range: Range::AtLeastHalf,
            default: 0.6,
            tried: &[0.6],
            meaning: "Newmark's gamma; numerical damping above 1/2, below no step is stable",
        },
    ],
    method: |numbers| match *numbers {
        [beta, gamma] => Some(Method::Family(Coefficients::newmark(beta, gamma))),
        _ => None,
    },
};

impl Coefficients {
    /// Newmark's method (1959). Second order for gamma = 1/2; stable for every step if 2 beta >= gamma >= 1/2.
    pub const fn newmark(beta: f64, gamma: f64) -> Self {
        Coefficients {
            alpha_m: 0.0,
            alpha_f: 0.0,
            beta,
            gamma,
        }
    }
}
