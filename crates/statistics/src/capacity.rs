//! Lognormal functions with intervals from values of a logarithm: capacities, or a cloud of cases.

use super::lognormal::{Fragility, NoFit};
use super::{CONFIDENCE, beta, gamma};
use libm::{exp, log};

/// A lognormal function with 95 % intervals of its two numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The function.
    pub function: Fragility,
    /// The interval of the median.
    pub median: [f64; 2],
    /// The interval of the dispersion.
    pub dispersion: [f64; 2],
}

/// The function of capacities: the values of `x` at which each member reaches a limit.
///
/// The median is that of a lognormal distribution, the exponential of the mean logarithm; the dispersion is the standard deviation
/// of the logarithms (n - 1). The intervals are exact for such capacities: Student's t and chi-square.
///
/// # Errors
/// There are less than two, one is not positive, or all are the same.
pub fn of_capacities(capacities: &[f64]) -> Result<Estimate, NoFit> {
    if capacities.iter().any(|x| x.is_nan() || *x <= 0.0) {
        return Err(NoFit::NoLogarithm);
    }
    let n = capacities.len();
    if n < 2 {
        return Err(NoFit::Few(2));
    }
    let logs: Vec<f64> = capacities.iter().map(|x| log(*x)).collect();
    let count = n as f64;
    let mean = logs.iter().sum::<f64>() / count;
    let squares: f64 = logs.iter().map(|z| (z - mean) * (z - mean)).sum();
    let free = count - 1.0;
    let deviation = (squares / free).sqrt();
    if deviation <= 0.0 {
        return Err(NoFit::Equal);
    }
    let half = student(free) * deviation / count.sqrt();
    let part = |p: f64| deviation * (free / chi_square(free, p)).sqrt();
    Ok(Estimate {
        function: Fragility {
            median: exp(mean),
            dispersion: deviation,
        },
        median: [exp(mean - half), exp(mean + half)],
        dispersion: [part(0.5 + 0.5 * CONFIDENCE), part(0.5 - 0.5 * CONFIDENCE)],
    })
}

/// The function of a cloud of cases (x, y): where ln y = a + b ln x + e, with e normal of the standard deviation s (n - 2), exceeds
/// ln `limit`. Median exp((ln limit - a)/b), dispersion s/b (Cornell et al. 2002).
///
/// The interval of the median is Fieller's, exact for such a cloud. That of the dispersion is that of the logarithm of s/b with the
/// variance 1/(2 (n - 2)) + s^2/(b^2 Sxx), which holds for many cases.
///
/// # Errors
/// There are less than three, one has no logarithm, or y does not rise with x beyond its scatter.
pub fn of_cloud(points: &[[f64; 2]], limit: f64) -> Result<Estimate, NoFit> {
    let has_logarithms = |point: &[f64; 2]| point.iter().all(|x| *x > 0.0 && x.is_finite());
    if !points.iter().all(has_logarithms) || limit.is_nan() || limit <= 0.0 {
        return Err(NoFit::NoLogarithm);
    }
    let n = points.len();
    if n < 3 {
        return Err(NoFit::Few(3));
    }
    let count = n as f64;
    let logs: Vec<[f64; 2]> = points.iter().map(|point| point.map(log)).collect();
    let mean = |j: usize| logs.iter().map(|z| z[j]).sum::<f64>() / count;
    let [x, y] = [mean(0), mean(1)];
    let product = |i: usize, j: usize| -> f64 {
        let means = [x, y];
        let of = |z: &[f64; 2]| (z[i] - means[i]) * (z[j] - means[j]);
        logs.iter().map(of).sum()
    };
    let sxx = product(0, 0);
    if sxx <= 0.0 {
        return Err(NoFit::Equal);
    }
    let slope = product(0, 1) / sxx;
    let free = count - 2.0;
    let residual = |z: &[f64; 2]| z[1] - y - slope * (z[0] - x);
    let squares: f64 = logs.iter().map(|z| residual(z) * residual(z)).sum();
    let deviation = (squares / free).sqrt();
    if deviation <= 0.0 {
        return Err(NoFit::Equal);
    }
    let t = student(free);
    // (b d - h)^2 = t^2 s^2 (1/n + d^2/Sxx), d = ln x - mean.
    let height = log(limit) - y;
    let width = t * deviation;
    let leading = slope * slope - width * width / sxx;
    if slope <= 0.0 || leading <= 0.0 {
        return Err(NoFit::NotRisingEnough);
    }
    let constant = height * height - width * width / count;
    let root = (slope * slope * height * height - leading * constant)
        .max(0.0)
        .sqrt();
    let ends = [-1.0, 1.0].map(|side| exp(x + (slope * height + side * root) / leading));
    let dispersion = deviation / slope;
    let variance = 0.5 / free + dispersion * dispersion / sxx;
    let half = super::normal::quantile(0.5 + 0.5 * CONFIDENCE) * variance.sqrt();
    Ok(Estimate {
        function: Fragility {
            median: exp(x + height / slope),
            dispersion,
        },
        median: ends,
        dispersion: [dispersion * exp(-half), dispersion * exp(half)],
    })
}

/// The t of Student's distribution that is exceeded in magnitude with probability 0.05.
fn student(free: f64) -> f64 {
    // P(|T| > t) = I_(v/(v + t^2))(v/2, 1/2).
    let beyond = |t: f64| beta::regularised(0.5 * free, 0.5, free / (free + t * t));
    rising(|t| 1.0 - beyond(t), CONFIDENCE)
}

/// The quantile of the chi-square distribution.
fn chi_square(free: f64, p: f64) -> f64 {
    rising(|x| gamma::regularised(0.5 * free, 0.5 * x), p)
}

/// Where a function that rises from 0 at 0 reaches p, by bisection.
fn rising(f: impl Fn(f64) -> f64, p: f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    while f(high) < p && high < 1e12 {
        high *= 2.0;
    }
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        match f(middle) < p {
            true => low = middle,
            false => high = middle,
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(a: f64, b: f64, tolerance: f64) {
        assert!((a / b - 1.0).abs() < tolerance, "{a} {b}");
    }

    #[test]
    fn quantiles_are_those_of_printed_tables() {
        // Tables of Student's t and of chi-square; half a unit of the last digit.
        for (free, t) in [
            (1.0, 12.7062),
            (5.0, 2.5706),
            (19.0, 2.0930),
            (120.0, 1.9799),
        ] {
            assert!((student(free) - t).abs() < 5.1e-5, "{}", student(free));
        }
        for (free, p, x) in [
            (1.0, 0.975, 5.024),
            (10.0, 0.025, 3.247),
            (19.0, 0.975, 32.852),
            (100.0, 0.025, 74.222),
        ] {
            assert!(
                (chi_square(free, p) - x).abs() < 5.1e-4,
                "{}",
                chi_square(free, p)
            );
        }
    }

    #[test]
    fn capacities_and_clouds_have_the_numbers_of_scipy() {
        // scipy.stats.t, chi2 and linregress, and brentq for the ends of Fieller's interval.
        let all = [0.21, 0.33, 0.5, 0.47, 0.8, 0.29, 1.1];
        let found = of_capacities(&all).unwrap();
        let compare = |found: Estimate, expected: [f64; 6]| {
            let own = [found.function.median, found.function.dispersion];
            let own = own.into_iter().chain(found.median).chain(found.dispersion);
            // Roots by bisection on both sides.
            own.zip(expected)
                .for_each(|(own, expected)| near(own, expected, 1e-10));
        };
        compare(
            found,
            [
                0.456890029751511,
                0.5789971849891411,
                0.26745722365922925,
                0.7804930314849369,
                0.37310196921840266,
                1.2749900804836622,
            ],
        );
        let x = [0.1, 0.2, 0.35, 0.5, 0.6, 0.9, 1.3, 0.15];
        let y = [0.012, 0.02, 0.05, 0.048, 0.09, 0.12, 0.15, 0.017];
        let points: Vec<[f64; 2]> = x.into_iter().zip(y).map(|(x, y)| [x, y]).collect();
        compare(
            of_cloud(&points, 0.07).unwrap(),
            [
                0.5726330681270653,
                0.1609224353657489,
                0.4943500283878246,
                0.6797801861192778,
                0.08998544595337081,
                0.28778020633984075,
            ],
        );
    }

    #[test]
    fn data_without_an_estimate_say_why() {
        assert_eq!(of_capacities(&[1.0]), Err(NoFit::Few(2)));
        assert_eq!(of_capacities(&[1.0, -1.0]), Err(NoFit::NoLogarithm));
        assert_eq!(of_capacities(&[2.0, 2.0]), Err(NoFit::Equal));
        let cloud = |points: &[[f64; 2]]| of_cloud(points, 1.0);
        assert_eq!(cloud(&[[1.0, 1.0], [2.0, 3.0]]), Err(NoFit::Few(3)));
        assert_eq!(
            cloud(&[[1.0, 1.0], [2.0, 0.0], [3.0, 1.0]]),
            Err(NoFit::NoLogarithm)
        );
        assert_eq!(
            cloud(&[[1.0, 1.0], [1.0, 2.0], [1.0, 3.0]]),
            Err(NoFit::Equal)
        );
        let falling = [[1.0, 3.0], [2.0, 2.0], [3.0, 1.1], [4.0, 0.8]];
        assert_eq!(cloud(&falling), Err(NoFit::NotRisingEnough));
        let level = [[1.0, 3.0], [2.0, 1.0], [3.0, 3.1], [4.0, 1.2]];
        assert_eq!(cloud(&level), Err(NoFit::NotRisingEnough));
    }
}
