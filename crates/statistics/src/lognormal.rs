//! A lognormal fragility function, fitted by maximum likelihood.

use super::normal::{cumulative, hazard, log_cumulative, quantile};
use libm::{exp, log};
use std::fmt;

/// Steps of Newton's method at most: each one at least quarters the distance in the likelihood of well posed data.
const STEPS: usize = 200;

/// Relative size of a last step.
const CONVERGED: f64 = 1e-13;

/// Trials at one value, and how many of them exceeded a limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trials {
    /// The value, such as the scale of a record.
    pub at: f64,
    /// How many exceeded.
    pub exceeded: u64,
    /// How many in all.
    pub count: u64,
}

/// P(x) = Phi(ln(x/median)/dispersion).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fragility {
    /// Where half of the trials exceed.
    pub median: f64,
    /// Standard deviation of the logarithm of the value from which on a trial exceeds.
    pub dispersion: f64,
}

/// Why data have no fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NoFit {
    /// A trial exceeds at a value that is not positive, where the probability is zero.
    NotPositive,
    /// No trial exceeds.
    None,
    /// Every trial exceeds.
    All,
    /// All trials that exceed are at values no smaller than all others: any smaller dispersion is more likely.
    Separable,
    /// The most likely probability does not rise.
    NotRising,
    /// There are less capacities or cases than this.
    Few(usize),
    /// A value or the limit is not positive, so that it has no logarithm.
    NoLogarithm,
    /// All capacities are the same, or all cases are at one value or on one line.
    Equal,
    /// The metric does not rise with the value beyond its scatter.
    NotRisingEnough,
    /// So many members do not exceed at the largest value.
    Beyond(usize),
    /// So many members exceed at the smallest value.
    Before(usize),
}

impl fmt::Display for NoFit {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            NoFit::Few(least) => return write!(f, "less than {least} values"),
            NoFit::Beyond(count) => {
                return write!(
                    f,
                    "{count} of the ensemble do not exceed the limit at the largest value"
                );
            }
            NoFit::Before(count) => {
                return write!(
                    f,
                    "{count} of the ensemble exceed the limit at the smallest value"
                );
            }
            NoFit::NoLogarithm => {
                "a value or the limit is not positive, so that it has no logarithm"
            }
            NoFit::Equal => "the values have no scatter",
            NoFit::NotRisingEnough => "the metric does not rise with x beyond its scatter",
            NoFit::NotPositive => "a case exceeds the limit at a value that is not positive",
            NoFit::None => "no case exceeds the limit",
            NoFit::All => "every case exceeds the limit",
            NoFit::Separable => {
                "no value exceeds in some cases below one that does not exceed in others"
            }
            NoFit::NotRising => "the probability does not rise",
        })
    }
}

impl Fragility {
    /// The probability of exceeding at a value.
    pub fn probability(&self, x: f64) -> f64 {
        match x > 0.0 {
            true => cumulative(log(x / self.median) / self.dispersion),
            false => 0.0,
        }
    }

    /// The function with the largest likelihood of binomial trials (Baker, Efficient analytical fragility function fitting
    /// using dynamic structural analysis, Earthquake Spectra 31 (2015), eq. 11). With a = -ln(median)/dispersion and
    /// b = 1/dispersion its logarithm is concave, so that Newton's method with shortened steps finds the largest one.
    ///
    /// # Errors
    /// Why there is none.
    pub fn fit(trials: &[Trials]) -> Result<Fragility, NoFit> {
        // Without one that exceeds, trials at zero are certain for any median and dispersion.
        let certain = |t: &&Trials| t.at > 0.0 || t.exceeded > 0;
        let trials: Vec<Trials> = trials.iter().filter(certain).copied().collect();
        solvable(&trials)?;
        let points: Vec<Point> = trials.iter().map(Point::of).collect();
        // About the middle of the logarithms, so that both unknowns are of order 1.
        let weight: f64 = points.iter().map(Point::count).sum();
        let middle = points.iter().map(|p| p.count() * p.z).sum::<f64>() / weight;
        let points: Vec<Point> = points
            .iter()
            .map(|p| Point {
                z: p.z - middle,
                ..*p
            })
            .collect();
        let part = points.iter().map(|p| p.yes).sum::<f64>() / weight;
        let mut at = [quantile(part), 0.0];
        let mut likelihood = log_likelihood(&points, at);
        for _ in 0..STEPS {
            let step = newton(&points, at);
            let (mut next, mut length) = (at, 1.0);
            let mut reached = likelihood;
            while length > 1e-9 {
                next = [0, 1].map(|k| at[k] + length * step[k]);
                reached = log_likelihood(&points, next);
                if reached >= likelihood {
                    break;
                }
                length /= 2.0;
            }
            if reached < likelihood {
                break;
            }
            let moved = (next[0] - at[0]).abs().max((next[1] - at[1]).abs());
            let size = 1.0 + next[0].abs().max(next[1].abs());
            (at, likelihood) = (next, reached);
            if moved <= CONVERGED * size {
                break;
            }
        }
        let [a, b] = at;
        match b > 0.0 {
            true => Ok(Fragility {
                median: exp(middle - a / b),
                dispersion: 1.0 / b,
            }),
            false => Err(NoFit::NotRising),
        }
    }
}

/// Whether a largest likelihood exists: trials of both kinds overlap.
fn solvable(trials: &[Trials]) -> Result<(), NoFit> {
    if trials.iter().any(|t| t.at.is_nan() || t.at <= 0.0) {
        return Err(NoFit::NotPositive);
    }
    let range = |of: &dyn Fn(&Trials) -> bool| {
        let own = trials.iter().filter(|t| of(t)).map(|t| t.at);
        own.fold(None, |range: Option<[f64; 2]>, x| {
            let [low, high] = range.unwrap_or([x, x]);
            Some([low.min(x), high.max(x)])
        })
    };
    let Some(yes) = range(&|t| t.exceeded > 0) else {
        return Err(NoFit::None);
    };
    let Some(no) = range(&|t| t.exceeded < t.count) else {
        return Err(NoFit::All);
    };
    if yes[0] >= no[1] {
        return Err(NoFit::Separable);
    }
    if yes[1] <= no[0] {
        return Err(NoFit::NotRising);
    }
    Ok(())
}

/// The trials at one logarithm.
#[derive(Debug, Clone, Copy)]
struct Point {
    z: f64,
    yes: f64,
    no: f64,
}

impl Point {
    fn of(trials: &Trials) -> Point {
        Point {
            z: log(trials.at),
            yes: trials.exceeded as f64,
            no: trials.count.saturating_sub(trials.exceeded) as f64,
        }
    }

    fn count(&self) -> f64 {
        self.yes + self.no
    }
}

/// The logarithm of the likelihood of Phi(a + b z), without the binomial coefficients.
fn log_likelihood(points: &[Point], [a, b]: [f64; 2]) -> f64 {
    let of = |p: &Point| {
        let u = a + b * p.z;
        p.yes * log_cumulative(u) + p.no * log_cumulative(-u)
    };
    points.iter().map(of).sum()
}

/// Newton's step towards the largest likelihood.
fn newton(points: &[Point], [a, b]: [f64; 2]) -> [f64; 2] {
    let (mut g, mut h) = ([0.0; 2], [0.0; 3]);
    for p in points {
        let u = a + b * p.z;
        let (up, down) = (hazard(u), hazard(-u));
        let slope = p.yes * up - p.no * down;
        // The negative second derivative; both terms are positive.
        let bend = p.yes * up * (up + u) + p.no * down * (down - u);
        g = [g[0] + slope, g[1] + slope * p.z];
        h = [h[0] + bend, h[1] + bend * p.z, h[2] + bend * p.z * p.z];
    }
    let determinant = h[0] * h[2] - h[1] * h[1];
    if determinant.is_nan() || determinant <= 0.0 {
        return [0.0; 2];
    }
    [
        (h[2] * g[0] - h[1] * g[1]) / determinant,
        (h[0] * g[1] - h[1] * g[0]) / determinant,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Value, trials that exceed, and all trials.
    type Row = (f64, u64, u64);

    fn trials(rows: &[Row]) -> Vec<Trials> {
        let of = |(at, exceeded, count): &Row| Trials {
            at: *at,
            exceeded: *exceeded,
            count: *count,
        };
        rows.iter().map(of).collect()
    }

    #[test]
    fn two_values_are_fitted_exactly() {
        // Two unknowns: the function goes through both parts, Phi(-1) and Phi(1) of many.
        let many = 1_000_000_000_000_u64;
        let below = (cumulative(-1.0) * many as f64) as u64;
        let found = Fragility::fit(&trials(&[(0.5, below, many), (2.0, many - below, many)]));
        let found = found.unwrap();
        // Median 1 and dispersion ln 2, as far as whole trials allow.
        assert!((found.median - 1.0).abs() < 1e-10, "{found:?}");
        assert!(
            (found.dispersion - std::f64::consts::LN_2).abs() < 1e-10,
            "{found:?}"
        );
        assert!((found.probability(2.0) - cumulative(1.0)).abs() < 1e-10);
        assert_eq!(found.probability(0.0), 0.0);
    }

    #[test]
    fn data_without_a_fit_say_why() {
        let why = |rows: &[Row]| Fragility::fit(&trials(rows)).unwrap_err();
        assert_eq!(why(&[]), NoFit::None);
        assert_eq!(why(&[(1.0, 0, 5), (2.0, 0, 5)]), NoFit::None);
        assert_eq!(why(&[(1.0, 5, 5), (2.0, 5, 5)]), NoFit::All);
        assert_eq!(why(&[(1.0, 0, 5), (2.0, 5, 5)]), NoFit::Separable);
        assert_eq!(
            why(&[(1.0, 0, 5), (2.0, 3, 5), (3.0, 5, 5)]),
            NoFit::Separable
        );
        assert_eq!(why(&[(2.0, 3, 5)]), NoFit::Separable);
        assert_eq!(why(&[(1.0, 5, 5), (2.0, 0, 5)]), NoFit::NotRising);
        assert_eq!(why(&[(1.0, 4, 5), (2.0, 1, 5)]), NoFit::NotRising);
        assert_eq!(why(&[(0.0, 1, 5), (2.0, 3, 5)]), NoFit::NotPositive);
        assert_eq!(why(&[(-1.0, 1, 5), (2.0, 3, 5)]), NoFit::NotPositive);
    }

    #[test]
    fn fits_are_the_largest_likelihoods() {
        for (rows, median, dispersion) in MPMATH {
            let found = Fragility::fit(&trials(rows)).unwrap();
            assert!(
                (found.median / median - 1.0).abs() < 1e-11,
                "{found:?} {median}"
            );
            assert!(
                (found.dispersion / dispersion - 1.0).abs() < 1e-11,
                "{found:?} {dispersion}"
            );
        }
    }

    #[test]
    fn trials_at_zero_that_do_not_exceed_change_nothing() {
        let rows = [(0.5, 1, 9), (1.0, 4, 9), (2.0, 8, 9)];
        let with: Vec<_> = [(0.0, 0, 9)].iter().chain(&rows).copied().collect();
        assert_eq!(
            Fragility::fit(&trials(&with)),
            Fragility::fit(&trials(&rows))
        );
    }

    /// Trials, and the median and dispersion where mpmath finds the derivatives of the likelihood to be zero, in 40 digits.
    /// The probit regression of statsmodels agrees to nine digits.
    const MPMATH: [(&[Row], f64, f64); 4] = [
        (
            &[
                (0.25, 0, 20),
                (0.5, 2, 20),
                (0.75, 7, 20),
                (1.0, 11, 20),
                (1.5, 16, 20),
                (2.0, 20, 20),
            ],
            0.919520337321997,
            0.45062880295815643,
        ),
        (
            &[
                (0.1, 1, 5),
                (0.2, 1, 5),
                (0.3, 2, 5),
                (0.4, 1, 5),
                (0.8, 4, 5),
            ],
            0.48671126943513887,
            1.33408883940055,
        ),
        (
            &[(1.0, 1, 2), (1.1, 0, 3), (1.2, 3, 3)],
            1.1056538374062406,
            0.11350751694040106,
        ),
        (
            &[(1e-3, 40, 100), (2e-3, 45, 100), (3e-3, 55, 100)],
            0.002351777392594556,
            3.0468863739221625,
        ),
    ];
}
