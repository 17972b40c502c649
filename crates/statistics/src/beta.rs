//! The regularised incomplete beta function, of which the tails of a binomial distribution are values.

use libm::{exp, lgamma, log, log1p};

/// Terms of the continued fraction at most: it needs about the root of the larger parameter.
const TERMS: usize = 100_000;

/// I_x(a, b) for a, b > 0 and x from 0 to 1: the probability of at least `a` successes in `a + b - 1` trials that each
/// succeed with probability `x`. By the continued fraction of DLMF 8.17.22 in the form of Lentz.
pub fn regularised(a: f64, b: f64, x: f64) -> f64 {
    if x <= 0.0 {
        return 0.0;
    }
    if x >= 1.0 {
        return 1.0;
    }
    // The fraction converges fast below the mean.
    if x > (a + 1.0) / (a + b + 2.0) {
        return 1.0 - front(b, a, 1.0 - x) * fraction(b, a, 1.0 - x) / b;
    }
    front(a, b, x) * fraction(a, b, x) / a
}

/// x^a (1 - x)^b / B(a, b).
fn front(a: f64, b: f64, x: f64) -> f64 {
    exp(lgamma(a + b) - lgamma(a) - lgamma(b) + a * log(x) + b * log1p(-x))
}

fn fraction(a: f64, b: f64, x: f64) -> f64 {
    let nonzero = |y: f64| if y.abs() < 1e-300 { 1e-300 } else { y };
    let (mut c, mut d) = (1.0, 1.0 / nonzero(1.0 - (a + b) * x / (a + 1.0)));
    let mut value = d;
    for m in 1..TERMS {
        let m = m as f64;
        let even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
        d = 1.0 / nonzero(1.0 + even * d);
        c = nonzero(1.0 + even / c);
        value *= c * d;
        let odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
        d = 1.0 / nonzero(1.0 + odd * d);
        c = nonzero(1.0 + odd / c);
        value *= c * d;
        if (c * d - 1.0).abs() < 1e-16 {
            break;
        }
    }
    value
}

/// Where a rising function of numbers from 0 to `end` has a value, by halving the interval so many times.
pub fn root(rising: impl Fn(f64) -> f64, value: f64, end: f64, halvings: usize) -> f64 {
    let [mut low, mut high] = [0.0, end];
    for _ in 0..halvings {
        let middle = low + (high - low) / 2.0;
        match rising(middle) < value {
            true => low = middle,
            false => high = middle,
        }
    }
    low + (high - low) / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_the_tail_of_a_binomial_distribution() {
        // Tails of n = 12 trials by hand from the coefficients.
        for x in [0.03_f64, 0.3, 0.5, 0.9] {
            let (n, mut tail, mut coefficient) = (12, 0.0, 1.0);
            let mut terms = Vec::new();
            for k in 0..=n {
                terms.push(coefficient * x.powi(k) * (1.0 - x).powi(n - k));
                coefficient *= f64::from(n - k) / f64::from(k + 1);
            }
            for k in (1..=n).rev() {
                tail += terms[k as usize];
                let found = regularised(f64::from(k), f64::from(n - k + 1), x);
                // A few roundings of logarithms below 30.
                assert!((found - tail).abs() < 1e-13, "{k} {x}: {found} {tail}");
            }
        }
    }

    #[test]
    fn closed_forms_hold() {
        for x in [0.0, 0.1, 0.5, 0.77, 1.0] {
            assert!((regularised(1.0, 1.0, x) - x).abs() < 1e-15);
            assert!((regularised(3.0, 1.0, x) - x * x * x).abs() < 1e-15);
            let arcsine = 2.0 / std::f64::consts::PI * libm::asin(libm::sqrt(x));
            assert!((regularised(0.5, 0.5, x) - arcsine).abs() < 1e-13);
        }
        // Symmetric for any size; logarithms of the size of a cause errors of 1e-16 a.
        for a in [10.0, 1e3, 1e5] {
            assert!((regularised(a, a, 0.5) - 0.5).abs() < 1e-15 * a + 1e-14);
        }
    }
}
