//! The interval of a probability from the number of successes.

use super::CONFIDENCE;
use super::beta::{regularised, root};

/// Halvings of an interval of probabilities: the ends are exact to the rounding of 1.
const HALVINGS: usize = 60;

/// The 95 % interval of a probability, of which `successes` of `trials` independent trials are an estimate, after Clopper
/// and Pearson (1934): the probabilities with which neither as many successes nor as few have a probability below 2.5 %.
/// Of the usual intervals only this one contains the probability at least 95 times in 100 for every probability and number
/// of trials, like the bands and intervals of medians next to it; for few trials it is wider than needed.
pub fn interval(successes: u64, trials: u64) -> [f64; 2] {
    let tail = (1.0 - CONFIDENCE) / 2.0;
    let (k, n) = (successes as f64, trials as f64);
    let low = match successes {
        0 => 0.0,
        _ => root(|p| regularised(k, n - k + 1.0, p), tail, 1.0, HALVINGS),
    };
    let high = match successes >= trials {
        true => 1.0,
        false => root(
            |p| regularised(k + 1.0, n - k, p),
            1.0 - tail,
            1.0,
            HALVINGS,
        ),
    };
    [low, high]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn intervals_are_those_of_scipy() {
        // scipy 1.17: binomtest(k, n).proportion_ci(0.95, method="exact").
        for (k, n, low, high) in SCIPY {
            let [found_low, found_high] = interval(k, n);
            assert!((found_low - low).abs() < 1e-12, "{k} of {n}: {found_low}");
            assert!(
                (found_high - high).abs() < 1e-12,
                "{k} of {n}: {found_high}"
            );
        }
    }

    /// Successes, trials, lower and upper end.
    const SCIPY: [(u64, u64, f64, f64); 7] = [
        (0, 12, 0.0, 0.26464846939705117),
        (1, 10, 0.0025285785444625728, 0.44501611702819543),
        (7, 20, 0.1539092047845412, 0.5921885345328283),
        (20, 20, 0.8315665290169145, 1.0),
        (50, 100, 0.39832112950330095, 0.6016788704966991),
        (3, 1000, 0.0006190999316499173, 0.008742023238657654),
        (99_000, 100_000, 0.9893638884706609, 0.9906074439109318),
    ];

    #[test]
    fn ends_have_closed_forms_without_and_with_only_successes() {
        for n in [1, 5, 40] {
            let bound = libm::pow(0.025, 1.0 / n as f64);
            let [low, high] = interval(0, n);
            assert!(low == 0.0 && (high - (1.0 - bound)).abs() < 1e-14);
            let [low, high] = interval(n, n);
            assert!(high == 1.0 && (low - bound).abs() < 1e-14);
        }
    }

    #[test]
    fn the_probability_is_contained_at_least_95_times_in_100() {
        // Exactly, by the sum over all numbers of successes.
        for n in [5_u64, 20, 60] {
            let intervals: Vec<[f64; 2]> = (0..=n).map(|k| interval(k, n)).collect();
            for p in (1..200).map(|i| f64::from(i) / 200.0) {
                let (mut term, mut contained) = (libm::pow(1.0 - p, n as f64), 0.0);
                for (k, [low, high]) in intervals.iter().enumerate() {
                    if (*low..=*high).contains(&p) {
                        contained += term;
                    }
                    term *= (n - k as u64) as f64 / (k as f64 + 1.0) * p / (1.0 - p);
                }
                assert!(contained >= 0.95 - 1e-12, "{n} {p}: {contained}");
            }
        }
    }
}
