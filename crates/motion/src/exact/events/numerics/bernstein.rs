//! The first time at which a polynomial becomes negative, with a proof that there is no earlier one.
//!
//! On an interval a polynomial is between its smallest and largest Bernstein coefficient. If none is below -tolerance, there is
//! no event. If they fall, the polynomial falls, and there is at most one root. Any other interval is halved.

use crate::exact::bisect;

/// Terms of a polynomial of a piece.
pub const TERMS: usize = 25;

/// Coefficients of s^0, s^1, ..; s is the time from the start of the piece over its length.
pub type Polynomial = [f64; TERMS];

/// Length of an interval, in parts of the piece, that is not halved again.
const SHORTEST: f64 = 1e-15;

/// The value at `s`.
pub fn value(p: &Polynomial, s: f64) -> f64 {
    p.iter().rev().fold(0.0, |sum, c| sum * s + c)
}

/// The derivative with respect to s, at `s`.
pub fn slope(p: &Polynomial, s: f64) -> f64 {
    let terms = p.iter().enumerate().skip(1).rev();
    terms.fold(0.0, |sum, (k, c)| sum * s + k as f64 * c)
}

/// The first s in 0..=`until` after which `p` falls below -`tolerance`: the root before it, or 0.
pub fn first_negative(p: &Polynomial, until: f64, tolerance: f64) -> Option<f64> {
    // Round-off of the coefficients and of the sums below.
    let tolerance = tolerance + f64::EPSILON * p.iter().map(|c| c.abs()).sum::<f64>();
    let (mut lowest, mut power) = (p[0], 1.0);
    for c in &p[1..] {
        power *= until;
        lowest += (c * power).min(0.0);
    }
    if lowest >= -tolerance {
        return None;
    }
    let [low, high] = first_below(&bernstein(p, until), [0.0, until], tolerance)?;
    let early = last_positive(p, low);
    Some(early.map_or(low, |early| {
        bisect([early, high], |s| value(p, s) <= 0.0)[1]
    }))
}

/// Bernstein coefficients on 0..=`until`: b_j = sum_k binomial(j, k)/binomial(n, k) a_k until^k, by sums of neighbours.
fn bernstein(p: &Polynomial, until: f64) -> Polynomial {
    let mut b = *p;
    // a_k/binomial(n, k) are the differences of order k at the left end.
    let (mut power, mut binomial) = (1.0, 1.0);
    for (k, b) in b.iter_mut().enumerate() {
        *b *= power / binomial;
        power *= until;
        binomial *= (TERMS - 1 - k) as f64 / (k + 1) as f64;
    }
    for order in (1..TERMS).rev() {
        for k in order..TERMS {
            b[k] += b[k - 1];
        }
    }
    b
}

/// The first interval in which the polynomial falls and becomes less than -`tolerance`; it is not less before.
fn first_below(b: &Polynomial, [low, high]: [f64; 2], tolerance: f64) -> Option<[f64; 2]> {
    if b.iter().all(|b| *b >= -tolerance) {
        return None;
    }
    if b[0] < -tolerance || high - low < SHORTEST {
        return Some([low, low]);
    }
    if b.windows(2).all(|b| b[1] <= b[0]) {
        return Some([low, high]);
    }
    let middle = 0.5 * (low + high);
    let mut right = *b;
    // The row of order k has the ends left[k] and right[n - k].
    let left = std::array::from_fn(|k| {
        if k > 0 {
            for j in 0..TERMS - k {
                right[j] = 0.5 * (right[j] + right[j + 1]);
            }
        }
        right[0]
    });
    first_below(&left, [low, middle], tolerance)
        .or_else(|| first_below(&right, [middle, high], tolerance))
}

/// A time near `low`, not after it, at which the polynomial is positive. At `low` it is not less than -tolerance.
fn last_positive(p: &Polynomial, low: f64) -> Option<f64> {
    let mut back = 0.0;
    while back < low {
        if value(p, low - back) > 0.0 {
            return Some(low - back);
        }
        back = (2.0 * back).max(SHORTEST);
    }
    (p[0] > 0.0).then_some(0.0)
}

/// Most terms of u.
pub const ORDERS: usize = TERMS + 2;

#[cfg(test)]
mod tests {
    use super::*;

    /// The product of s - root, times a factor.
    fn product(roots: &[f64], factor: f64) -> Polynomial {
        let mut p = [0.0; TERMS];
        p[0] = factor;
        for root in roots {
            for k in (0..TERMS).rev() {
                p[k] = -root * p[k] + if k > 0 { p[k - 1] } else { 0.0 };
            }
        }
        p
    }

    #[test]
    fn bernstein_coefficients_are_those_of_the_definition() {
        // s^2 on 0..=1/2: b_j = j (j - 1)/(n (n - 1))/4.
        let b = bernstein(&product(&[0.0, 0.0], 1.0), 0.5);
        for (j, b) in b.into_iter().enumerate() {
            let expected = (j * j.saturating_sub(1)) as f64 / (24.0 * 23.0) / 4.0;
            assert!((b - expected).abs() < 1e-16);
        }
    }

    #[test]
    fn the_first_root_is_found() {
        for (roots, factor, first) in [
            (&[0.25][..], -1.0, 0.25),
            (&[0.25, 0.7], 1.0, 0.25),
            // A short time below 0.
            (&[0.3, 0.300_01], 1.0, 0.3),
            (&[0.2, 0.4, 0.6, 0.8, 0.9], -1.0, 0.2),
            (&[1.5, 0.99, -3.0], 1.0, 0.99),
            // It starts at 0.
            (&[0.0, 0.5], -1.0, 0.5),
            (&[0.0], -1.0, 0.0),
        ] {
            let p = product(roots, factor);
            let root = first_negative(&p, 1.0, 1e-13).unwrap();
            // Round-off over the slope, which is 1e-5 at the close roots.
            assert!((root - first).abs() < 1e-10, "{roots:?}: {root}");
            let before = first_negative(&p, first - 1e-9, 1e-13);
            assert!(first == 0.0 || before.is_none());
        }
    }

    #[test]
    fn a_root_that_is_not_passed_is_no_event() {
        assert_eq!(first_negative(&product(&[0.3, 0.3], 1.0), 1.0, 1e-13), None);
        assert_eq!(first_negative(&product(&[1.1, 1.3], 1.0), 1.0, 1e-13), None);
        // Below 0 by 2.5e-13 between close roots, with the tolerance 1e-12.
        let shallow = product(&[0.3, 0.300_001], 1.0);
        assert_eq!(first_negative(&shallow, 1.0, 1e-12), None);
    }
}
