//! Student's t and chi-square: the distributions of a mean and of a variance of normal values.

use super::{beta, gamma};

/// Halvings of an interval, to rounding also near its lower end.
const HALVINGS: usize = 100;

/// The probability of a larger magnitude of t: I_(v/(v + t^2))(v/2, 1/2).
pub fn beyond(t: f64, free: f64) -> f64 {
    beta::regularised(0.5 * free, 0.5, free / (free + t * t))
}

/// The t whose magnitude is not exceeded with probability `p`.
pub fn quantile(free: f64, p: f64) -> f64 {
    rising(|t| 1.0 - beyond(t, free), p)
}

/// The quantile of the chi-square distribution.
pub fn chi_square(free: f64, p: f64) -> f64 {
    rising(|x| gamma::regularised(0.5 * free, 0.5 * x), p)
}

/// Where a function that rises from 0 at 0 reaches p, by bisection.
fn rising(f: impl Fn(f64) -> f64, p: f64) -> f64 {
    let mut end = 1.0;
    while f(end) < p && end < 1e12 {
        end *= 2.0;
    }
    beta::root(f, p, end, HALVINGS)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_those_of_printed_tables() {
        // Tables of Student's t and of chi-square; half a unit of the last digit.
        for (free, t) in [
            (1.0, 12.7062),
            (5.0, 2.5706),
            (19.0, 2.0930),
            (120.0, 1.9799),
        ] {
            let found = quantile(free, 0.95);
            assert!((found - t).abs() < 5.1e-5, "{found}");
        }
        for (free, p, x) in [
            (1.0, 0.975, 5.024),
            (10.0, 0.025, 3.247),
            (19.0, 0.975, 32.852),
            (100.0, 0.025, 74.222),
        ] {
            let found = chi_square(free, p);
            assert!((found - x).abs() < 5.1e-4, "{found}");
        }
    }
}
