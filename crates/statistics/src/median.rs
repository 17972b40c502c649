//! The distribution-free interval of a median.

use super::CONFIDENCE;
use super::beta::regularised;

/// The places, from 0, of the two of `count` rising values between which the median of their distribution lies with a
/// probability of at least 95 %: as many values are below the median as there are successes in `count` trials of one half.
/// `None` for fewer than six values, of which even the smallest and largest contain it less often. It holds for any
/// distribution of independent values.
pub fn places(count: usize) -> Option<[usize; 2]> {
    let n = count as f64;
    // The probability that at most `below` values are below the median.
    let most = |below: usize| 1.0 - regularised(below as f64 + 1.0, n - below as f64, 0.5);
    let allowed = |below: usize| most(below) <= (1.0 - CONFIDENCE) / 2.0;
    if count == 0 || !allowed(0) {
        return None;
    }
    let (mut low, mut high) = (0, count / 2);
    while high - low > 1 {
        let middle = low + (high - low) / 2;
        match allowed(middle) {
            true => low = middle,
            false => high = middle,
        }
    }
    Some([low, count - 1 - low])
}

/// The interval of the median of `rising` values.
pub fn interval(rising: &[f64]) -> Option<[f64; 2]> {
    places(rising.len()).map(|places| places.map(|rank| rising[rank]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_those_of_the_tables() {
        // Conover, Practical Nonparametric Statistics (1999), and by hand: 2 (1/2)^6 = 0.03125 and 2 (1/2)^5 = 0.0625;
        // of 20 values 2 (1 + 20 + 190 + 1140 + 4845)/2^20 = 0.0118 for 5th and 0.0414 for the 6th of both ends.
        assert_eq!(places(0), None);
        assert_eq!(places(5), None);
        assert_eq!(places(6), Some([0, 5]));
        assert_eq!(places(10), Some([1, 8]));
        assert_eq!(places(20), Some([5, 14]));
        assert_eq!(places(100), Some([39, 60]));
        let rising: Vec<f64> = (0..20).map(f64::from).collect();
        assert_eq!(interval(&rising), Some([5.0, 14.0]));
    }

    #[test]
    fn places_are_the_innermost_that_contain_95_in_100() {
        // By the sum of the coefficients over 2^n.
        for count in 6..200_usize {
            let [low, high] = places(count).unwrap();
            assert_eq!(low + high, count - 1);
            let (mut term, mut below) = (libm::pow(0.5, count as f64), 0.0);
            let mut tails = Vec::new();
            for k in 0..=count {
                below += term;
                tails.push(below);
                term *= (count - k) as f64 / (k as f64 + 1.0);
            }
            assert!(tails[low] <= 0.025 && tails[low + 1] > 0.025, "{count}");
        }
        // Many values: 1.96 standard deviations of sqrt(n)/2 from the middle.
        let [low, _] = places(1_000_000).unwrap();
        assert!((500_000.0 - low as f64 - 979.98).abs() < 2.0, "{low}");
    }
}
