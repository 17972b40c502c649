//! The root of a rising function of one number.

/// Iterations of Newton's method alone; after them every second one halves the bracket.
const FREE: usize = 12;

/// Largest number of iterations; halving a bracket to its last bit needs less than half of it.
const MOST: usize = 160;

/// The root in `low..=high` of a rising function, from `start`. `f` gives its value and its slope.
///
/// Newton's iteration with a bracket: a number outside the bracket, or a slope that is not positive, gives way to the middle. So it
/// ends for every continuous function that is <= 0 at `low` and >= 0 at `high`. It stops when a change is round-off.
pub fn rising(low: f64, high: f64, start: f64, f: impl Fn(f64) -> [f64; 2]) -> f64 {
    let [mut low, mut high] = [low, high];
    let mut x = if start > low { start } else { low };
    x = if x < high { x } else { high };
    for k in 0..MOST {
        let [value, slope] = f(x);
        if value < 0.0 {
            low = x;
        } else if value > 0.0 {
            high = x;
        } else {
            // At the root, or not a number.
            return x + value;
        }
        let newton = x - value / slope;
        let inside = slope > 0.0 && newton >= low && newton <= high;
        let next = if inside && (k < FREE || k % 2 == 0) {
            newton
        } else {
            0.5 * (low + high)
        };
        let change = (next - x).abs();
        x = next;
        if change <= 2.0 * f64::EPSILON * x.abs() {
            break;
        }
    }
    x
}
