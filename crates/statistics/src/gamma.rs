//! The regularised incomplete gamma function, of which the chi-square distribution is a value.

use libm::{exp, lgamma, log};

/// Terms at most: both forms need about the root of the parameter.
const TERMS: usize = 100_000;

/// P(a, x) for a > 0 and x >= 0: by the series of DLMF 8.11.4 below the mean, and by the continued fraction of DLMF 8.9.2 in the
/// form of Lentz above.
pub fn regularised(a: f64, x: f64) -> f64 {
    if x <= 0.0 {
        return 0.0;
    }
    let front = exp(a * log(x) - x - lgamma(a));
    match x < a + 1.0 {
        true => front * series(a, x),
        false => 1.0 - front * fraction(a, x),
    }
}

fn series(a: f64, x: f64) -> f64 {
    let mut term = 1.0 / a;
    let mut sum = term;
    for n in 1..TERMS {
        term *= x / (a + n as f64);
        sum += term;
        if term < 1e-17 * sum {
            break;
        }
    }
    sum
}

fn fraction(a: f64, x: f64) -> f64 {
    let nonzero = |y: f64| if y.abs() < 1e-300 { 1e-300 } else { y };
    let mut b = x + 1.0 - a;
    let mut c = 1e300;
    let mut d = 1.0 / nonzero(b);
    let mut value = d;
    for n in 1..TERMS {
        let n = n as f64;
        let numerator = -n * (n - a);
        b += 2.0;
        d = 1.0 / nonzero(b + numerator * d);
        c = nonzero(b + numerator / c);
        value *= c * d;
        if (c * d - 1.0).abs() < 1e-16 {
            break;
        }
    }
    value
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_has_its_closed_forms() {
        // P(1, x) = 1 - exp(-x), P(2, x) = 1 - (1 + x) exp(-x), P(1/2, x) = erf(sqrt x). Round-off of the powers.
        for x in [1e-3_f64, 0.3, 1.0, 1.9, 2.1, 5.0, 20.0] {
            for (a, expected) in [
                (1.0, 1.0 - (-x).exp()),
                (2.0, 1.0 - (1.0 + x) * (-x).exp()),
                (0.5, libm::erf(x.sqrt())),
            ] {
                let found = regularised(a, x);
                assert!(
                    (found - expected).abs() < 1e-14,
                    "{a} {x}: {found} {expected}"
                );
            }
        }
        assert_eq!(regularised(3.0, 0.0), 0.0);
    }
}
