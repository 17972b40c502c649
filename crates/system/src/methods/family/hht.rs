//! The alpha method of Hilber, Hughes and Taylor.

use crate::methods::{Coefficients, Description, Method, MethodParameter};
use crate::range::Range;

/// Names and parameters.
pub(in crate::methods) const DESCRIPTION: Description = Description {
    name: "hht",
    meaning: "alpha method of Hilber, Hughes and Taylor (1977): equilibrium within the step, numerical damping by hht_alpha",
    parameters: &[MethodParameter {
        name: "hht_alpha",
        symbol: "*α*_H_",
        range: Range::HilberHughesTaylor,
        default: -0.1,
        tried: &[-0.05, -0.1, -0.3333],
        meaning: "alpha of Hilber, Hughes and Taylor; no numerical damping at 0",
    }],
    method: |numbers| match *numbers {
        [alpha] => Some(Method::Family(Coefficients::hht(alpha))),
        _ => None,
    },
};

impl Coefficients {
    /// The method of Hilber, Hughes and Taylor (1977), for alpha from -1/3 (most dissipation) to 0 (none): alpha_f = -alpha,
    /// beta = (1 - alpha)^2/4, gamma = 1/2 - alpha.
    pub const fn hht(alpha: f64) -> Self {
        Coefficients {
            alpha_m: 0.0,
            alpha_f: -alpha,
            beta: 0.25 * (1.0 - alpha) * (1.0 - alpha),
            gamma: 0.5 - alpha,
        }
    }
}
