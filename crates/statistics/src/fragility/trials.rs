//! A lognormal fragility function of trials, by the largest likelihood.

use super::likelihood::{self, Point};
use super::{Fit, NoFit};
use crate::normal::quantile;
use libm::log;

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

/// The function with the largest likelihood of binomial trials (Baker, Efficient analytical fragility function fitting using
/// dynamic structural analysis, Earthquake Spectra 31 (2015), eq. 11), which is that of multiple stripes, too. With
/// a = -ln(median)/dispersion and b = 1/dispersion its logarithm is concave.
///
/// # Errors
/// Why there is none.
pub fn of_trials(trials: &[Trials]) -> Result<Fit, NoFit> {
    // Without one that exceeds, trials at zero are certain for any median and dispersion.
    let certain = |t: &&Trials| t.at > 0.0 || t.exceeded > 0;
    let trials: Vec<Trials> = trials.iter().filter(certain).copied().collect();
    solvable(&trials)?;
    let mut points: Vec<Point> = trials.iter().map(point).collect();
    // About the middle of the logarithms, so that both unknowns are of order 1.
    let weight: f64 = points.iter().map(Point::count).sum();
    let middle = points.iter().map(|p| p.count() * p.z).sum::<f64>() / weight;
    points.iter_mut().for_each(|p| p.z -= middle);
    let part = points.iter().map(|p| p.yes).sum::<f64>() / weight;
    likelihood::largest(middle, [quantile(part), 0.0], |at| {
        likelihood::of_trials(&points, at)
    })
}

fn point(trials: &Trials) -> Point {
    Point {
        z: log(trials.at),
        yes: trials.exceeded as f64,
        no: trials.count.saturating_sub(trials.exceeded) as f64,
    }
}

/// Whether a largest likelihood exists: trials of both kinds overlap.
fn solvable(trials: &[Trials]) -> Result<(), NoFit> {
    if trials.iter().any(|t| t.at.is_nan() || t.at <= 0.0) {
        return Err(NoFit::NotPositive);
    }
    let range = |of: &dyn Fn(&Trials) -> bool| {
        let measures = trials.iter().filter(|t| of(t)).map(|t| t.at);
        measures.fold(None, |range: Option<[f64; 2]>, x| {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::normal::cumulative;

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
        let fit = of_trials(&trials(&[(0.5, below, many), (2.0, many - below, many)]));
        let found = fit.unwrap().function;
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
        let why = |rows: &[Row]| of_trials(&trials(rows)).unwrap_err();
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
        for (rows, median, dispersion, intervals) in MPMATH {
            let fit = of_trials(&trials(rows)).unwrap();
            let found = fit.function;
            assert!(
                (found.median / median - 1.0).abs() < 1e-11,
                "{found:?} {median}"
            );
            assert!(
                (found.dispersion / dispersion - 1.0).abs() < 1e-11,
                "{found:?} {dispersion}"
            );
            for (found, end) in fit.intervals().iter().flatten().zip(intervals) {
                assert!((found / end - 1.0).abs() < 1e-11, "{found} {end}");
            }
        }
    }

    #[test]
    fn trials_at_zero_that_do_not_exceed_change_nothing() {
        let rows = [(0.5, 1, 9), (1.0, 4, 9), (2.0, 8, 9)];
        let with: Vec<_> = [(0.0, 0, 9)].iter().chain(&rows).copied().collect();
        assert_eq!(of_trials(&trials(&with)), of_trials(&trials(&rows)));
    }

    /// Trials, and the median and dispersion where mpmath finds the derivatives of the likelihood to be zero, in 40 digits, with
    /// the intervals of the second derivatives (tests/reference/structures/fragility.py).
    /// The probit regression of statsmodels agrees to nine digits.
    const MPMATH: [(&[Row], f64, f64, [f64; 4]); 4] = [
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
            0.45062880295815644,
            [
                0.8041388932325327,
                1.051457226934877,
                0.32801513970973367,
                0.6190760531212002,
            ],
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
            [
                0.2064969110634764,
                1.147173866064979,
                0.4579992675712065,
                3.8860172000960604,
            ],
        ),
        (
            &[(1.0, 1, 2), (1.1, 0, 3), (1.2, 3, 3)],
            1.1056538374062406,
            0.11350751694040107,
            [
                0.9945264300543102,
                1.2291985122048368,
                0.02452282461908982,
                0.525386312633248,
            ],
        ),
        (
            &[(1e-3, 40, 100), (2e-3, 45, 100), (3e-3, 55, 100)],
            0.002351777392594556,
            3.0468863739221623,
            [
                0.0014294112766807994,
                0.003869325081275359,
                1.1658482856358379,
                7.96288564298865,
            ],
        ),
    ];
}
