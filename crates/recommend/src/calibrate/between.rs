//! How a parameter varies between tests, from its value in each test with a standard error.
//!
//! Values are normal about a mean, with the scatter tau between tests and the error of each test: y_i has the variance s_i^2 + tau^2. With
//! weights w_i = 1/(s_i^2 + tau^2) the mean is sum w y/sum w, and Q = sum w (y - mean)^2 has the chi-square distribution of k - 1 degrees
//! of freedom. The estimate of tau has Q = k - 1 (Paule and Mandel 1982), the ends of its interval have the quantiles of Q (Viechtbauer
//! 2007). The interval of the mean is by Student's t with the variance max(1, Q/(k - 1))/sum w (Knapp and Hartung 2003). Errors are
//! taken as known. A parameter that all tests have in common has tau = 0, and a mean with the variance 1/sum w.

use slipgap_statistics::{CONFIDENCE, fisher, gamma, normal};

/// Halvings of a range of tau^2: to the rounding of its numbers.
const HALVINGS: usize = 200;

/// What tests say about a parameter together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Between {
    /// The mean of all tests that could be made, with its 95 % interval.
    pub mean: f64,
    /// Its interval.
    pub mean_interval: [f64; 2],
    /// The standard deviation tau between tests.
    pub scatter: f64,
    /// Its interval.
    pub scatter_interval: [f64; 2],
    /// The probability of values as different as these if they differ by their errors alone.
    pub p_common: f64,
}

impl Between {
    /// From the values of a parameter in each test with their standard errors; `None` for fewer than two tests, and for an error that is
    /// not positive. A parameter that does not vary has no scatter.
    pub fn of(values: &[f64], errors: &[f64], varies: bool) -> Option<Between> {
        let errors_are_known = errors.iter().all(|s| *s > 0.0 && s.is_finite());
        if values.len() < 2 || values.len() != errors.len() || !errors_are_known {
            return None;
        }
        let weighted = |square: f64| Weighted::of(values, errors, square);
        let freedom = (values.len() - 1) as f64;
        let below = |q: f64| gamma::regularised(0.5 * freedom, 0.5 * q);
        // tau^2 at which a function of Q, which falls with tau^2, reaches a value.
        let at = |reached: &dyn Fn(f64) -> bool| {
            if !varies || !reached(weighted(0.0).q) {
                return 0.0;
            }
            let (mut low, mut high) = (0.0, errors.iter().fold(0.0, |sum, s| sum + s * s));
            while reached(weighted(high).q) && high.is_finite() {
                high *= 2.0;
            }
            for _ in 0..HALVINGS {
                let middle = 0.5 * (low + high);
                match reached(weighted(middle).q) {
                    true => low = middle,
                    false => high = middle,
                }
            }
            0.5 * (low + high)
        };
        let tail = 0.5 * (1.0 - CONFIDENCE);
        let square = at(&|q| q > freedom);
        let ends = [1.0 - tail, tail].map(|p| at(&|q| below(q) > p));
        let mean = weighted(square);
        let half = match varies {
            true => {
                let t = fisher::quantile(CONFIDENCE, 1.0, freedom).sqrt();
                t * ((mean.q / freedom).max(1.0) / mean.weight).sqrt()
            }
            false => normal::quantile(1.0 - tail) / mean.weight.sqrt(),
        };
        Some(Between {
            mean: mean.mean,
            mean_interval: [mean.mean - half, mean.mean + half],
            scatter: square.sqrt(),
            scatter_interval: ends.map(f64::sqrt),
            p_common: 1.0 - below(weighted(0.0).q),
        })
    }
}

/// The mean with the weights of a scatter.
struct Weighted {
    mean: f64,
    weight: f64,
    q: f64,
}

impl Weighted {
    fn of(values: &[f64], errors: &[f64], square: f64) -> Weighted {
        let pairs = || {
            values
                .iter()
                .zip(errors.iter().map(|s| 1.0 / (s * s + square)))
        };
        let weight: f64 = pairs().map(|(_, w)| w).sum();
        let mean = pairs().map(|(y, w)| w * y).sum::<f64>() / weight;
        let q = pairs().map(|(y, w)| w * (y - mean) * (y - mean)).sum();
        Weighted { mean, weight, q }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::{Rng, SeedableRng};

    /// Vaccinated and not: diseased and healthy persons in 13 trials (Colditz et al. 1994).
    const TRIALS: [[f64; 4]; 13] = [
        [4.0, 119.0, 11.0, 128.0],
        [6.0, 300.0, 29.0, 274.0],
        [3.0, 228.0, 11.0, 209.0],
        [62.0, 13536.0, 248.0, 12619.0],
        [33.0, 5036.0, 47.0, 5761.0],
        [180.0, 1361.0, 372.0, 1079.0],
        [8.0, 2537.0, 10.0, 619.0],
        [505.0, 87886.0, 499.0, 87892.0],
        [29.0, 7470.0, 45.0, 7232.0],
        [17.0, 1699.0, 65.0, 1600.0],
        [186.0, 50448.0, 141.0, 27197.0],
        [5.0, 2493.0, 3.0, 2338.0],
        [27.0, 16886.0, 29.0, 17825.0],
    ];

    fn compare(found: Between, expected: [f64; 7]) {
        let computed = [found.mean].into_iter().chain(found.mean_interval);
        let numbers = computed
            .chain([found.scatter])
            .chain(found.scatter_interval);
        for (number, expected) in numbers.chain([found.p_common]).zip(expected) {
            // Roots on both sides; p is a difference to 1.
            let error = (number - expected).abs();
            assert!(error < 1e-9 * expected.abs() + 1e-15, "{number} {expected}");
        }
    }

    #[test]
    fn numbers_are_those_of_scipy() {
        // By brentq and the quantiles of scipy.stats, from the formulas above.
        compare(
            vaccine(),
            [
                -0.7149681534934444,
                -1.1090983812022404,
                -0.3208379257846486,
                0.5639755776671754,
                0.34600341203702156,
                1.0542670838364105,
                1.9967645908458624e-26,
            ],
        );
        let errors = [0.1, 0.2, 0.15, 0.1, 0.3];
        compare(
            Between::of(&[8.1, 7.4, 8.9, 8.3, 7.7], &errors, true).unwrap(),
            [
                8.10293335750153,
                7.390627515607376,
                8.815239199395686,
                0.5450329045780857,
                0.2916003514698058,
                1.6450004666944618,
                1.3485446961093677e-08,
            ],
        );
        compare(
            Between::of(&[1.0, 1.1, 0.9, 1.05], &[0.2, 0.2, 0.2, 0.3], true).unwrap(),
            [
                1.006451612903226,
                0.6635010749965413,
                1.3494021508099105,
                0.0,
                0.0,
                0.24286184356082754,
                0.9135449376351484,
            ],
        );
        compare(
            Between::of(&[8.1, 7.4, 8.9, 8.3, 7.7], &errors, false).unwrap(),
            [
                8.219801980198023,
                8.102787756832653,
                8.336816203563393,
                0.0,
                0.0,
                0.0,
                1.3485446961093677e-08,
            ],
        );
    }

    #[test]
    fn the_interval_of_the_scatter_is_the_published_one() {
        // Viechtbauer (2007) and the manual of metafor for these trials: tau^2 from 0.1197 to 1.1115; half a unit of the last digit.
        let found = vaccine();
        let [low, high] = found.scatter_interval.map(|x| x * x);
        assert!(
            (low - 0.1197).abs() < 5e-5 && (high - 1.1115).abs() < 5e-5,
            "{low} {high}"
        );
    }

    fn vaccine() -> Between {
        let values = TRIALS.map(|[a, b, c, d]| (a / (a + b) * (c + d) / c).ln());
        let errors =
            TRIALS.map(|[a, b, c, d]| (1.0 / a - 1.0 / (a + b) + 1.0 / c - 1.0 / (c + d)).sqrt());
        Between::of(&values, &errors, true).unwrap()
    }

    #[test]
    fn intervals_hold_the_truth_in_95_of_100_sets() {
        let mut random = ChaCha8Rng::seed_from_u64(5);
        let mut normal =
            || normal::quantile((f64::from(random.next_u32()) + 0.5) / 4_294_967_296.0);
        for (count, scatter) in [(5, 0.0), (5, 0.3), (12, 0.1), (12, 0.5)] {
            let mut held = [0; 2];
            for _ in 0..400 {
                let errors: Vec<f64> = (0..count).map(|i| 0.05 + 0.02 * f64::from(i)).collect();
                let values: Vec<f64> = { errors.iter() }
                    .map(|s| 8.0 + scatter * normal() + s * normal())
                    .collect();
                let found = Between::of(&values, &errors, true).unwrap();
                let holds = |[low, high]: [f64; 2], x: f64| usize::from(low <= x && x <= high);
                held[0] += holds(found.mean_interval, 8.0);
                held[1] += holds(found.scatter_interval, scatter);
            }
            // Of 400 intervals that hold the truth with 95 %, fewer than 369 do so with a probability of 0.9 % (binomial).
            assert!(
                held.iter().all(|hits| *hits >= 369),
                "{count} {scatter}: {held:?}"
            );
        }
    }

    #[test]
    fn few_tests_have_no_scatter() {
        assert_eq!(Between::of(&[1.0], &[0.1], true), None);
        assert_eq!(Between::of(&[1.0, 2.0], &[0.1, 0.0], true), None);
        // Equal values: no scatter at all.
        let found = Between::of(&[1.0, 1.0, 1.0], &[0.1, 0.2, 0.1], true).unwrap();
        assert_eq!([found.mean, found.scatter, found.p_common], [1.0, 0.0, 1.0]);
        assert_eq!(found.scatter_interval, [0.0, 0.0]);
    }
}
