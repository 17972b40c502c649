//! The roots of rising functions of one number.

use crate::lane::Lane;

/// Iterations of Newton's method alone; after them every second one halves the bracket.
const FREE: usize = 12;

/// Largest number of iterations; halving a bracket to its last bit needs less than half of it.
const MOST: usize = 160;

/// A change by less than this part is the last one: the error after it is of the order of its square.
const LAST: f64 = 1e-10;

/// The root in `low..=high` of a rising function of each lane, from `start`. `f` gives value and slope for a lane and a number.
///
/// Newton's iteration with a bracket: a number outside the bracket, or a slope that is not positive, gives way to the middle. So it
/// ends for every continuous function that is <= 0 at `low` and >= 0 at `high`. Every lane stops by itself.
#[inline(always)]
pub(super) fn rising<const L: usize>(
    low: Lane<L>,
    high: Lane<L>,
    start: Lane<L>,
    f: impl Fn(usize, f64) -> [f64; 2],
) -> Lane<L> {
    let [mut low, mut high, mut x] = [low, high, start.larger(low).smaller(high)];
    // 1 while a lane has not reached its root.
    let mut open: Lane<L> = Lane::splat(1.0);
    for k in 0..MOST {
        let halve = k >= FREE && k % 2 == 1;
        for l in 0..L {
            let now = x.0[l];
            let [value, slope] = f(l, now);
            low.0[l] = if value < 0.0 { now } else { low.0[l] };
            high.0[l] = if value > 0.0 { now } else { high.0[l] };
            let newton = now - value / slope;
            let inside = !halve && slope > 0.0 && newton >= low.0[l] && newton <= high.0[l];
            let middle = 0.5 * (low.0[l] + high.0[l]);
            let estimate = if inside { newton } else { middle };
            // A value that is not a number gives one that is not.
            let next = if value == 0.0 {
                now
            } else {
                estimate + 0.0 * value
            };
            // A half of the bracket is not an estimate of the error: it has to be round-off.
            let last = if inside { LAST } else { f64::EPSILON };
            let far = (next - now).abs() > last * next.abs();
            x.0[l] = if open.0[l] > 0.0 { next } else { now };
            open.0[l] = if far { open.0[l] } else { 0.0 };
        }
        if open == Lane::splat(0.0) {
            break;
        }
    }
    x
}

/// The root for one number.
pub(super) fn rising_once(low: f64, high: f64, start: f64, f: impl Fn(f64) -> [f64; 2]) -> f64 {
    let [root] = rising(Lane([low]), Lane([high]), Lane([start]), |_, x| f(x)).0;
    root
}
