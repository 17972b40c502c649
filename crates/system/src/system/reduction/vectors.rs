//! Products of long vectors, with sums in a fixed order.

/// Partial sums: a processor adds them at the same time.
const PARTS: usize = 8;

/// a^T b.
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; PARTS];
    let (a, rest_a) = a.as_chunks::<PARTS>();
    let (b, rest_b) = b.as_chunks::<PARTS>();
    for (a, b) in a.iter().zip(b) {
        for (sum, (a, b)) in sums.iter_mut().zip(a.iter().zip(b)) {
            *sum += a * b;
        }
    }
    let rest: f64 = rest_a.iter().zip(rest_b).map(|(a, b)| a * b).sum();
    sums.iter().sum::<f64>() + rest
}

/// Adds a factor times a vector to another one.
pub(super) fn add(to: &mut [f64], factor: f64, x: &[f64]) {
    for (to, x) in to.iter_mut().zip(x) {
        *to += factor * x;
    }
}

/// A sequence of numbers in -1..1 without a pattern, the same on every machine: SplitMix64.
#[derive(Debug)]
pub(super) struct Scattered(u64);

impl Scattered {
    /// The sequence from its beginning.
    pub(super) fn new() -> Scattered {
        Scattered(1)
    }

    /// The next vector of so many numbers.
    pub(super) fn vector(&mut self, len: usize) -> Vec<f64> {
        (0..len).map(|_| self.number()).collect()
    }

    fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        // 53 bits are exact.
        (z >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_are_sums_of_all_terms() {
        for len in [0, 1, 7, 8, 9, 50] {
            let a: Vec<f64> = (0..len).map(f64::from).collect();
            let mut b = vec![2.0; a.len()];
            // Whole numbers: no round-off.
            let n = f64::from(len);
            assert_eq!(dot(&a, &b), n * (n - 1.0));
            add(&mut b, 3.0, &a);
            assert_eq!(b.iter().sum::<f64>(), 2.0 * n + 3.0 * n * (n - 1.0) / 2.0);
        }
    }

    #[test]
    fn scattered_numbers_fill_their_interval_evenly() {
        let x = Scattered::new().vector(10_000);
        assert!(x.iter().all(|x| (-1.0..1.0).contains(x)));
        // Mean and variance of an even distribution, within four standard deviations.
        assert!(x.iter().sum::<f64>().abs() < 4.0 * (10_000.0_f64 / 3.0).sqrt());
        let squares: f64 = x.iter().map(|x| x * x).sum();
        assert!((squares / 10_000.0 - 1.0 / 3.0).abs() < 4.0 * 0.003);
    }
}
