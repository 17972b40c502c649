//! The normal distribution.

use libm::{erfc, exp, log};
use std::f64::consts::{FRAC_1_SQRT_2, PI};

/// Below this argument the probability is near the smallest numbers, and an asymptotic series is exact to rounding.
const FAR: f64 = -30.0;

/// The probability of a value below `z`.
pub fn cumulative(z: f64) -> f64 {
    0.5 * erfc(-z * FRAC_1_SQRT_2)
}

/// Its logarithm, also where it is smaller than the smallest number.
pub fn log_cumulative(z: f64) -> f64 {
    if z > FAR {
        return log(cumulative(z));
    }
    -0.5 * z * z - log(-z) - 0.5 * log(2.0 * PI) + log(series(z))
}

/// The density over the probability of a value below `z`: the derivative of [`log_cumulative`].
pub fn hazard(z: f64) -> f64 {
    if z > FAR {
        return exp(-0.5 * z * z) / (2.0 * PI).sqrt() / cumulative(z);
    }
    -z / series(z)
}

/// 1 - 1/z^2 + 3/z^4 - 15/z^6 + 105/z^8 (Abramowitz and Stegun 26.2.12); the next term is 2e-12 at most.
fn series(z: f64) -> f64 {
    let t = 1.0 / (z * z);
    1.0 - t * (1.0 - 3.0 * t * (1.0 - 5.0 * t * (1.0 - 7.0 * t)))
}

/// The value below which the probability is `p`, for p between 0 and 1.
pub fn quantile(p: f64) -> f64 {
    let [mut low, mut high] = [-40.0, 40.0];
    for _ in 0..70 {
        let middle = 0.5 * (low + high);
        match cumulative(middle) < p {
            true => low = middle,
            false => high = middle,
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_values_hold() {
        // Abramowitz and Stegun, table 26.1, and scipy's norm.logcdf(-40) = -804.6084420137538.
        assert!((cumulative(1.0) - 0.841_344_746_068_542_9).abs() < 1e-15);
        assert!((quantile(0.975) - 1.959_963_984_540_054).abs() < 1e-14);
        assert!((log_cumulative(-40.0) + 804.608_442_013_753_8).abs() < 1e-9);
        assert_eq!(cumulative(0.0), 0.5);
    }

    #[test]
    fn series_and_function_agree_where_they_meet() {
        let (near, far) = (FAR + 1e-9, FAR);
        assert!((log_cumulative(near) - log_cumulative(far) - 30.0e-9).abs() < 1e-9);
        assert!((hazard(near) - hazard(far)).abs() < 1e-8);
    }

    #[test]
    fn the_hazard_is_the_slope_of_the_logarithm() {
        for z in [-50.0, -20.0, -3.0, 0.0, 2.0, 6.0] {
            let h = 1e-4;
            let slope = (log_cumulative(z + h) - log_cumulative(z - h)) / (2.0 * h);
            // The error of the difference is h^2/6 times the third derivative, and rounding of 1e-16 |ln|/h.
            assert!((hazard(z) - slope).abs() < 1e-8, "{z}");
        }
    }
}
