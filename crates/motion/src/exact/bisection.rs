//! Bisection to neighbouring numbers.

/// The two neighbouring numbers between which `past` changes from false to true.
///
/// `past` is false at the first number of the range and true at the last one. The numbers are not negative.
pub fn bisect([mut low, mut high]: [f64; 2], past: impl Fn(f64) -> bool) -> [f64; 2] {
    loop {
        let middle = 0.5 * (low + high);
        if !(low < middle && middle < high) {
            return [low, high];
        }
        if past(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_root_is_between_neighbours() {
        for square in [2.0_f64, 1e-200, 3e200, 0.25] {
            // Round-off of x^2 is less than the change of x^2 between neighbours.
            let [low, high] = bisect([0.0, 1e120], |x| x * x >= square);
            assert_eq!(low.next_up(), high);
            assert!(low * low < square && square <= high * high, "{square}");
            assert!((high / square.sqrt() - 1.0).abs() < 2.0 * f64::EPSILON);
        }
    }
}
