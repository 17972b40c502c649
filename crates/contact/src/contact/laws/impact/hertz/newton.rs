//! Newton's iteration in lanes, and bounds of roots.

use crate::lane::Lane;

/// More iterations than any root needs.
const MOST: usize = 100;

/// Newton's iteration of each lane from `x` > 0; `step` gives x - x(next). A lane stays after its first step of at most
/// `last` x, so it does not depend on other lanes.
#[inline(always)]
pub(in crate::contact) fn newton<const L: usize>(
    mut x: Lane<L>,
    last: f64,
    step: impl Fn(Lane<L>) -> Lane<L>,
) -> Lane<L> {
    let mut before: Lane<L> = Lane::splat(f64::INFINITY);
    for _ in 0..MOST {
        let step = step(x);
        let mut moves = false;
        for l in 0..L {
            let goes = before.0[l] > last * x.0[l];
            let step = if goes { step.0[l] } else { 0.0 };
            x.0[l] -= step;
            before.0[l] = step.abs();
            moves |= step.abs() > last * x.0[l];
        }
        if !moves {
            break;
        }
    }
    x
}

/// An upper bound of the cube root of x >= 0, at most 8.4 % above it for normal numbers.
#[inline(always)]
pub(super) fn above_cube_root(x: f64) -> f64 {
    // 2/3 of the exponent's bias.
    root_of_bits(x, 0x5555_5556, 682 << 20)
}

/// An upper bound of the fifth root of x >= 0, at most 8.4 % above it for normal numbers.
#[inline(always)]
pub(super) fn above_fifth_root(x: f64) -> f64 {
    // 4/5 of the exponent's bias.
    root_of_bits(x, 0x3333_3334, 0x3326_6667)
}

/// x^(1/n) from the upper half of the bits, which is nearly proportional to the logarithm: bits/n + bias (1 - 1/n).
///
/// 1 + m is above 2^m for 0 < m < 1, by up to 6.2 %: the logarithm of x is too small by at most 0.0861/n, the power is not too
/// small. The factor 1.021 > 2^(0.0861/3) makes the result an upper bound.
#[inline(always)]
fn root_of_bits(x: f64, inverse: u64, bias: u64) -> f64 {
    let high = (x.to_bits() >> 32) & 0x7fff_ffff;
    f64::from_bits((((high * inverse) >> 32) + bias) << 32) * 1.021
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_of_bits_are_upper_bounds() {
        let mut x = 1e-300_f64;
        while x < 1e300 {
            for (bound, root) in [
                (above_cube_root(x), libm::cbrt(x)),
                (above_fifth_root(x), libm::pow(x, 0.2)),
            ] {
                let above = bound / root;
                assert!((1.0..1.084).contains(&above), "{x}: {above}");
            }
            x *= 1.0173;
        }
        assert!(above_cube_root(0.0) > 0.0 && above_cube_root(0.0) < 1e-100);
    }

    #[test]
    fn a_lane_stays_when_it_has_converged() {
        let squares = Lane([2.0, 1e6, 1.0]);
        let half = |x: Lane<3>| x.zip(squares, |x, a| (x * x - a) / (2.0 * x));
        let Lane(roots) = newton(Lane([2.0, 1e6, 1.0]), 1e-9, half);
        for (root, square) in roots.into_iter().zip(squares.0) {
            let alone = newton(Lane([square]), 1e-9, |x| {
                x.map(|x| (x * x - square) / (2.0 * x))
            });
            assert_eq!(Lane([root]), alone);
            // Rounded once or twice.
            assert!((root / square.sqrt() - 1.0).abs() <= 2.0 * f64::EPSILON);
        }
    }
}
