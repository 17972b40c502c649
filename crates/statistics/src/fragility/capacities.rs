//! The function of capacities, the values at which each member of an ensemble reaches a limit, some known by bounds only.

use super::likelihood::{self, Local, Point, logarithms};
use super::spread::Spread;
use super::{Fit, Fragility, NoFit};
use libm::{exp, log};

/// The values at which each member of an ensemble reaches a limit.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Capacities {
    /// Of members that reach it.
    pub reached: Vec<f64>,
    /// The largest values of members that do not: their capacities are beyond.
    pub beyond: Vec<f64>,
    /// The smallest values of members that exceed it there: their capacities are before.
    pub before: Vec<f64>,
}

impl Capacities {
    /// The function. If every member reaches the limit, the median is the exponential of the mean logarithm, the dispersion the
    /// standard deviation of the logarithms (n - 1), and the intervals are exact. Otherwise both are of the largest likelihood
    /// of truncated incremental analysis (Baker 2015, eq. 9): the density of each capacity, the probability of each bound.
    ///
    /// # Errors
    /// Less than two are reached, one is not positive, or all are the same.
    pub fn fit(&self) -> Result<Fit, NoFit> {
        let Capacities {
            reached,
            beyond,
            before,
        } = self;
        match (reached.len(), before.len(), beyond.len()) {
            (0, 0, beyond) if beyond > 0 => return Err(NoFit::Beyond(beyond)),
            (0, before, _) if before > 0 => return Err(NoFit::Before(before)),
            _ => {}
        }
        let mut capacities = reached.iter().chain(beyond).chain(before);
        if capacities.any(|x| x.is_nan() || *x <= 0.0) {
            return Err(NoFit::NoLogarithm);
        }
        if reached.len() < 2 {
            return Err(NoFit::Few(2));
        }
        match beyond.is_empty() && before.is_empty() {
            true => of_all(reached),
            false => self.of_bounded(),
        }
    }

    /// By the largest likelihood. With u = a + b z the logarithm of the density of a capacity is ln b - u^2/2.
    fn of_bounded(&self) -> Result<Fit, NoFit> {
        let [reached, beyond, before] =
            [&self.reached, &self.beyond, &self.before].map(|values| logarithms(values));
        let count = reached.len() as f64;
        let middle = reached.iter().sum::<f64>() / count;
        let reached: Vec<f64> = reached.iter().map(|z| z - middle).collect();
        let squares: f64 = reached.iter().map(|z| z * z).sum();
        let point = |z: &f64, yes: f64| Point {
            z: z - middle,
            yes,
            no: 1.0 - yes,
        };
        let yes = before.iter().map(|z| point(z, 1.0));
        let bounds: Vec<Point> = yes.chain(beyond.iter().map(|z| point(z, 0.0))).collect();
        // A step at equal capacities that contradicts no bound is infinitely likely.
        let at_step = |p: &Point| if p.yes > 0.0 { p.z >= 0.0 } else { p.z <= 0.0 };
        if squares <= 0.0 && bounds.iter().all(at_step) {
            return Err(NoFit::Equal);
        }
        let sum: f64 = reached.iter().sum();
        let of = |[a, b]: [f64; 2]| Local {
            value: count * log(b) - 0.5 * (count * a * a + 2.0 * a * b * sum + b * b * squares),
            slope: [-(count * a + b * sum), count / b - (a * sum + b * squares)],
            bend: [count, sum, count / (b * b) + squares],
        };
        // From the scatter of the capacities alone.
        let start = [0.0, (count / squares).sqrt().min(1e3)];
        likelihood::largest(middle, start, |at| {
            of(at).and(likelihood::of_trials(&bounds, at))
        })
    }
}

fn of_all(capacities: &[f64]) -> Result<Fit, NoFit> {
    let logs = logarithms(capacities);
    let count = logs.len() as f64;
    let mean = logs.iter().sum::<f64>() / count;
    let squares: f64 = logs.iter().map(|z| (z - mean) * (z - mean)).sum();
    let dispersion = (squares / (count - 1.0)).sqrt();
    if dispersion <= 0.0 {
        return Err(NoFit::Equal);
    }
    Ok(Fit {
        function: Fragility {
            median: exp(mean),
            dispersion,
        },
        line: None,
        spread: Spread::Capacities { mean, count },
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fragility::tests::compare;

    const REACHED: [f64; 7] = [0.21, 0.33, 0.5, 0.47, 0.8, 0.29, 1.1];

    fn fit(reached: &[f64], beyond: &[f64], before: &[f64]) -> Result<Fit, NoFit> {
        let [reached, beyond, before] = [reached, beyond, before].map(<[f64]>::to_vec);
        Capacities {
            reached,
            beyond,
            before,
        }
        .fit()
    }

    #[test]
    fn capacities_have_the_numbers_of_scipy() {
        // scipy.stats.t and chi2: roots by bisection on both sides.
        let expected = [
            0.456890029751511,
            0.5789971849891411,
            0.26745722365922925,
            0.7804930314849369,
            0.37310196921840266,
            1.2749900804836622,
        ];
        compare(&fit(&REACHED, &[], &[]).unwrap(), expected, 1e-10);
    }

    #[test]
    fn bounds_are_those_of_the_largest_likelihood() {
        // tests/reference/structures/fragility.py, by Newton's method on the likelihood of median and dispersion in 40 digits.
        for (reached, beyond, before, expected) in MPMATH {
            let fit = fit(reached, beyond, before).unwrap();
            // Rounding of the likelihood, whose square root is that of its place; the last full step is far closer.
            compare(&fit, expected, 1e-11);
        }
    }

    #[test]
    fn capacities_without_a_fit_say_why() {
        let why = |reached: &[f64], beyond: &[f64], before: &[f64]| {
            fit(reached, beyond, before).unwrap_err()
        };
        assert_eq!(why(&[1.0], &[], &[]), NoFit::Few(2));
        assert_eq!(why(&[], &[], &[]), NoFit::Few(2));
        assert_eq!(why(&[1.0], &[2.0, 2.0], &[]), NoFit::Few(2));
        assert_eq!(why(&[], &[2.0, 2.0], &[]), NoFit::Beyond(2));
        assert_eq!(why(&[], &[2.0], &[1.0]), NoFit::Before(1));
        assert_eq!(why(&[1.0, -1.0], &[], &[]), NoFit::NoLogarithm);
        assert_eq!(why(&[1.0, 2.0], &[0.0], &[]), NoFit::NoLogarithm);
        assert_eq!(why(&[2.0, 2.0], &[], &[]), NoFit::Equal);
        assert_eq!(why(&[2.0, 2.0], &[1.0, 2.0], &[3.0]), NoFit::Equal);
        assert_eq!(why(&[2.0, 2.0], &[], &[2.0]), NoFit::Equal);
    }

    /// Capacities reached, beyond and before; the function and the ends of the intervals.
    type Row = (&'static [f64], &'static [f64], &'static [f64], [f64; 6]);

    const MPMATH: [Row; 4] = [
        (
            &REACHED,
            &[1.5, 0.9],
            &[],
            [
                0.6194304824620487,
                0.7654463395608252,
                0.3688654386282627,
                1.0402007952549,
                0.44017720726830656,
                1.3310732338531341,
            ],
        ),
        (
            &REACHED,
            &[],
            &[0.2, 0.3],
            [
                0.3628300667836924,
                0.6631646233946116,
                0.2311168756097213,
                0.5696064253852406,
                0.38375760116444885,
                1.1460028840800942,
            ],
        ),
        (
            &REACHED,
            &[0.9, 1.5, 1.5],
            &[0.2],
            [
                0.6328386440027348,
                1.0388421030629715,
                0.33098499655333885,
                1.2099785594924428,
                0.5823514207115823,
                1.853164389601074,
            ],
        ),
        (
            &[3.0, 3.0],
            &[2.0, 4.0, 4.0],
            &[],
            [
                3.8161980762116867,
                0.25996163637691927,
                2.7924269996345035,
                5.2153083173841095,
                0.08643296174043505,
                0.7818782444446806,
            ],
        ),
    ];
}
