//! The step of a force that approaches its limit exponentially, for the laws that have one.
//!
//! Over a step in one direction these laws are S = S(0) + c s(z), s(z) = m/(1 + d - d m) with m = 1 - exp(-z): an exponential for
//! d = 0, the hyperbolic tangent of z/2 for d = 1. The structure leaves z + C s(z) = w with C >= 0. The sum rises, so there is one
//! root.
//!
//! The iteration replaces exp(-x), x = z(k+1) - z(k), by (2 - x)/(2 + x) and solves the quadratic equation that remains. For x > 0
//! the replacement is smaller than exp(-x), so s is too large and the new z too small: from the left of the root the iteration
//! rises to it and never passes it. The error after it is below x^3/12, so most steps need two. It starts at the larger one of
//! two numbers left of the root: w - C, because s <= 1, and w/(1 + C/(1 + d)), because s is concave. Every lane stops by itself, so
//! its bits do not depend on other lanes.

use crate::lane::Lane;

/// Largest number of iterations: z <= 700 and each one gains 2 or is one of the last four. Up to C = 1e12 at most 15 are needed.
const MOST: usize = 400;

/// 1 - exp(-x) for x >= 0, to about one unit in the last place, in operations that compile to vectors.
///
/// The polynomial and the splitting of ln 2 are those of FDLIBM's `exp` (Sun Microsystems 1993).
#[inline(always)]
pub(super) fn rise(x: f64) -> f64 {
    // Beyond this 1 - exp(-x) is 1. A number that is not one stays so.
    let x = if x > 700.0 { 700.0 } else { x };
    // x = k ln 2 + r; adding 1.5 * 2^52 rounds to the integer k, which is then in the last bits.
    let shifted = x * std::f64::consts::LOG2_E + 6_755_399_441_055_744.0;
    let k = shifted - 6_755_399_441_055_744.0;
    let (high, low) = (
        x - k * 6.931_471_803_691_238e-1,
        k * 1.908_214_929_270_587_7e-10,
    );
    let y = low - high;
    let t = y * y;
    let polynomial = 1.666_666_666_666_660_2e-1
        + t * (-2.777_777_777_701_559_3e-3
            + t * (6.613_756_321_437_934e-5
                + t * (-1.653_390_220_546_525_2e-6 + t * 4.138_136_797_057_238_5e-8)));
    let c = y - t * polynomial;
    // exp(y) - 1 and 2^-k.
    let grown = y * c / (2.0 - c) + low - high;
    let scale = f64::from_bits((1023_u64 << 52).wrapping_sub(shifted.to_bits() << 52));
    (1.0 - scale) - scale * grown
}

/// m = 1 - exp(-z) at the root of z + C s(z) = w, for w >= 0, C >= 0 and 0 <= d <= 1.
#[inline(always)]
pub(super) fn root<const L: usize>(c: Lane<L>, d: Lane<L>, w: Lane<L>) -> Lane<L> {
    let mut z: Lane<L> = Lane::splat(0.0);
    for l in 0..L {
        let [saturated, linear] = [
            w.0[l] - c.0[l],
            w.0[l] * (1.0 + d.0[l]) / (1.0 + d.0[l] + c.0[l]),
        ];
        z.0[l] = if saturated > linear {
            saturated
        } else {
            linear
        };
    }
    // 1 while a lane has not reached its root.
    let (mut m, mut open): (Lane<L>, Lane<L>) = (Lane::splat(0.0), Lane::splat(1.0));
    for _ in 0..MOST {
        for l in 0..L {
            let [next, m_next, far] = iterate(c.0[l], d.0[l], w.0[l], z.0[l]);
            let now = open.0[l] > 0.0;
            z.0[l] = if now { next } else { z.0[l] };
            m.0[l] = if now { m_next } else { m.0[l] };
            open.0[l] = if now { far } else { 0.0 };
        }
        if open == Lane::splat(0.0) {
            break;
        }
    }
    m
}

/// The next z, its m, and 1 if z can still be left of the root by more than round-off.
#[inline(always)]
fn iterate(c: f64, d: f64, w: f64, z: f64) -> [f64; 3] {
    let m = rise(z);
    let e = 1.0 - m;
    let (sum, difference) = (1.0 + d * e, 1.0 - d * e);
    let rest = z - w;
    // difference x^2 + b x + 2 f = 0; f has the sign of the residual.
    let f = rest * sum + c * m;
    let b = 2.0 * sum + rest * difference + c * (1.0 + e);
    let square = b * b - 8.0 * difference * f;
    let step = -4.0 * f / (b + square.sqrt());
    let next = z + step;
    // An error of x^3/12 is below round-off then. Round-off can make x negative.
    let far = step * (step * step) > 2.0 * f64::EPSILON * next;
    [
        next,
        m + e * (2.0 * step / (2.0 + step)),
        if far { 1.0 } else { 0.0 },
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rise_has_the_digits_of_the_library_function() {
        for k in 0..200_000 {
            let x = 1e-12 * libm::pow(10.0, f64::from(k) * 8e-5);
            let expected = -libm::expm1(-x);
            // One unit in the last place of each function.
            assert!(
                (rise(x) - expected).abs() <= 2.0 * f64::EPSILON * expected,
                "{x}"
            );
        }
        assert_eq!([rise(0.0), rise(1e3), rise(f64::INFINITY)], [0.0, 1.0, 1.0]);
        assert!(rise(f64::NAN).is_nan());
    }

    #[test]
    fn the_root_is_reached_from_the_left_in_few_iterations() {
        let [mut most, mut sum, mut count] = [0, 0, 0];
        for d in [0.0, 0.3, 1.0] {
            for k in 0..180 {
                let c = libm::pow(10.0, f64::from(k) * 0.1 - 6.0);
                for j in 0..200 {
                    // Small, and near the knee at w = C.
                    let w = match j {
                        0..100 => (c + 10.0) * libm::pow(10.0, f64::from(j) * 0.14 - 14.0),
                        _ => c + f64::from(j - 100) * 0.3,
                    };
                    let linear = w * (1.0 + d) / (1.0 + d + c);
                    let mut z = if w - c > linear { w - c } else { linear };
                    let mut iterations = 0;
                    loop {
                        let [next, m, far] = iterate(c, d, w, z);
                        iterations += 1;
                        // Round-off of the terms, over the slope 1.
                        assert!(next >= z - 8.0 * f64::EPSILON * (z + w));
                        z = next;
                        if far == 0.0 {
                            let [found] = root(Lane([c]), Lane([d]), Lane([w])).0;
                            assert_eq!(found, m);
                            let residual = z + c * m / (1.0 + d - d * m) - w;
                            assert!(
                                residual.abs() <= 8.0 * f64::EPSILON * w,
                                "{c} {d} {w}: {residual}"
                            );
                            let expected = -libm::expm1(-z);
                            assert!((m - expected).abs() <= 8.0 * f64::EPSILON * expected);
                            break;
                        }
                    }
                    most = iterations.max(most);
                    (sum, count) = (sum + iterations, count + 1);
                }
            }
        }
        assert!(most <= 15 && sum < 3 * count, "{most} {sum} {count}");
        assert!(root(Lane([1.0]), Lane([0.0]), Lane([f64::NAN])).0[0].is_nan());
    }
}
