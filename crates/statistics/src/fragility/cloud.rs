//! The function of a cloud of cases, each a value of an intensity measure and one of a metric.

use super::likelihood::{self, Local, Point};
use super::spread::{self, Spread};
use super::{Fit, Fragility, Line, NoFit};
use crate::CONFIDENCE;
use libm::{exp, log};

/// A cloud of cases by logarithms.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Cloud {
    /// ln x and ln y.
    points: Vec<[f64; 2]>,
    /// ln x of cases whose y is beyond a bound by an unknown amount.
    beyond: Vec<f64>,
    /// Whether a case has no logarithm.
    lacks_logarithm: bool,
}

impl Cloud {
    /// The cloud of points (x, y); an infinite y is beyond the bound of the fit by an unknown amount.
    pub fn new(points: &[[f64; 2]]) -> Cloud {
        let mut cloud = Cloud::default();
        for [x, y] in points {
            let has_logarithm = *x > 0.0 && x.is_finite() && *y > 0.0;
            match y.is_finite() {
                _ if !has_logarithm => cloud.lacks_logarithm = true,
                true => cloud.points.push([log(*x), log(*y)]),
                false => cloud.beyond.push(log(*x)),
            }
        }
        cloud
    }

    /// Several clouds as one.
    pub fn together<'a>(clouds: impl Iterator<Item = &'a Cloud>) -> Cloud {
        clouds.fold(Cloud::default(), |mut joined, cloud| {
            joined.points.extend(&cloud.points);
            joined.beyond.extend(&cloud.beyond);
            joined.lacks_logarithm |= cloud.lacks_logarithm;
            joined
        })
    }

    /// The logarithms of the cases with a known y.
    pub fn logarithms(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// The function where ln y = a + b ln x + e, with e normal of the standard deviation s (n - 2), exceeds ln `limit`: median
    /// exp((ln limit - a)/b), dispersion s/b (Cornell et al. 2002). With cases beyond a bound by an unknown amount a, b and s
    /// are of the largest likelihood: the density of each y, for each case beyond the probability that y is not below the bound
    /// `collapse` (Tobin 1958).
    ///
    /// # Errors
    /// There are less than three, one has no logarithm, or y does not rise with x beyond its scatter.
    pub fn fit(&self, limit: f64, collapse: f64) -> Result<Fit, NoFit> {
        if self.lacks_logarithm || limit.is_nan() || limit <= 0.0 {
            return Err(NoFit::NoLogarithm);
        }
        if self.points.len() < 3 {
            return Err(NoFit::Few(3));
        }
        let fitted = Line::through(&self.points).filter(|line| line.deviation > 0.0);
        let line = fitted.ok_or(NoFit::Equal)?;
        if !self.beyond.is_empty() {
            return self.of_bounded([limit, collapse].map(log), &line);
        }
        // So that Fieller's interval has ends.
        if line.slope <= 0.0 || line.p_of_slope() >= 1.0 - CONFIDENCE {
            return Err(NoFit::NotRisingEnough);
        }
        let height = log(limit) - line.y;
        Ok(Fit {
            function: Fragility {
                median: exp(line.x + height / line.slope),
                dispersion: line.deviation / line.slope,
            },
            line: Some(line),
            spread: Spread::Cloud { line, height },
        })
    }

    /// By the largest likelihood. With v = ln(y/collapse), z = ln x and u = a + b z the logarithm of the density of a case is
    /// ln t - (t v - u)^2/2, t = 1/s, which is largest by t at a root of t^2 Svv - t Svu - n = 0. The derivatives are those of
    /// the likelihood that is largest by t (Olsen 1978 shows that it is concave). The limit is d = ln(collapse/limit) below: its
    /// median is where u + t d = 0.
    fn of_bounded(&self, [limit, collapse]: [f64; 2], line: &Line) -> Result<Fit, NoFit> {
        let middle = line.x;
        let shifted = self.points.iter().map(|[x, y]| [x - middle, y - collapse]);
        let points: Vec<[f64; 2]> = shifted.collect();
        let point = |z: &f64| Point {
            z: z - middle,
            yes: 1.0,
            no: 0.0,
        };
        let beyond: Vec<Point> = self.beyond.iter().map(point).collect();
        let sum = |of: &dyn Fn(&[f64; 2]) -> f64| points.iter().map(of).sum::<f64>();
        let [zv, zz, vv] = [
            sum(&|[z, v]| z * v),
            sum(&|[z, _]| z * z),
            sum(&|[_, v]| v * v),
        ];
        let [z, v, n] = [sum(&|p| p[0]), sum(&|p| p[1]), points.len() as f64];
        let scale = |[a, b]: [f64; 2]| {
            let vu = a * v + b * zv;
            (vu + (vu * vu + 4.0 * n * vv).sqrt()) / (2.0 * vv)
        };
        let of = |at: [f64; 2]| {
            let ([a, b], t) = (at, scale(at));
            let residual = |[z, v]: &[f64; 2]| t * v - a - b * z;
            let bend = vv + n / (t * t);
            Local {
                value: n * log(t) - 0.5 * sum(&|p| residual(p) * residual(p)),
                slope: [sum(&residual), sum(&|p| residual(p) * p[0])],
                bend: [n - v * v / bend, z - v * zv / bend, zz - zv * zv / bend],
            }
        };
        // From the line through the other cases.
        let start = [
            (line.y - collapse) / line.deviation,
            line.slope / line.deviation,
        ];
        let mut fit = likelihood::largest(middle, start, |at| {
            of(at).and(likelihood::of_trials(&beyond, at))
        })
        .map_err(|_| NoFit::NotRisingEnough)?;
        let Fragility { median, dispersion } = fit.function;
        let b = 1.0 / dispersion;
        let a = b * (middle - log(median));
        let t = scale([a, b]);
        let below = collapse - limit;
        let median = middle - (a + t * below) / b;
        // The derivatives of ln(median) by a, b and t. Given a and b, t has the variance 1/bend and follows them by v/bend and zv/bend.
        let by_t = -below / b;
        let bend = vv + n / (t * t);
        let by = [
            -1.0 / b + by_t * v / bend,
            (a + t * below) / (b * b) + by_t * zv / bend,
        ];
        let information = of([a, b]).and(likelihood::of_trials(&beyond, [a, b])).bend;
        fit.spread = Spread::Bounded {
            variances: spread::variances(by, by_t * by_t / bend, b, information),
            free: line.free(),
        };
        fit.function.median = exp(median);
        let deviation = 1.0 / t;
        fit.line = Some(Line {
            x: median,
            y: limit,
            slope: b * deviation,
            deviation,
            ..*line
        });
        Ok(fit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fragility::tests::compare;
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::{Rng, SeedableRng};

    const X: [f64; 8] = [0.1, 0.2, 0.35, 0.5, 0.6, 0.9, 1.3, 0.15];
    const Y: [f64; 8] = [0.012, 0.02, 0.05, 0.048, 0.09, 0.12, 0.15, 0.017];

    fn points() -> Vec<[f64; 2]> {
        X.into_iter().zip(Y).map(|(x, y)| [x, y]).collect()
    }

    #[test]
    fn clouds_have_the_numbers_of_scipy() {
        // scipy.stats.linregress and t, and brentq for the ends of Fieller's interval: roots by bisection on both sides.
        let fit = Cloud::new(&points()).fit(0.07, 0.07).unwrap();
        let expected = [
            0.5726330681270653,
            0.1609224353657489,
            0.4943500283878246,
            0.6797801861192778,
            0.08998544595337081,
            0.28778020633984075,
        ];
        compare(&fit, expected, 1e-10);
    }

    #[test]
    fn cases_beyond_are_those_of_the_largest_likelihood() {
        // tests/reference/structures/fragility.py, by Newton's method on the likelihood of intercept, slope and deviation in 40 digits.
        for (beyond, line, expected) in [
            (
                &[1.2, 1.6][..],
                [1.0426878049973496, 0.14531199820853444],
                [
                    0.5726330629301091,
                    0.13936290183129532,
                    0.5000186470854256,
                    0.6557927922729985,
                    0.07433752182786296,
                    0.2612680370461255,
                ],
            ),
            (
                &[0.4],
                [1.0479218085181834, 0.20042651069848813],
                [
                    0.5442923345265861,
                    0.19126094052942919,
                    0.4574103337780376,
                    0.6476769839838402,
                    0.09855672375710404,
                    0.37116440134877227,
                ],
            ),
        ] {
            let beyond = beyond.iter().map(|x| [*x, f64::INFINITY]);
            let every_point: Vec<[f64; 2]> = points().into_iter().chain(beyond).collect();
            let fit = Cloud::new(&every_point).fit(0.07, 0.07).unwrap();
            // Rounding of the likelihood, whose square root is that of its place; the last full step is far closer.
            compare(&fit, expected, 1e-11);
            let line_of_fit = fit.line.unwrap();
            let close = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-11, "{a} {b}");
            close(line_of_fit.slope, line[0]);
            close(line_of_fit.deviation, line[1]);
        }
    }

    #[test]
    fn a_limit_below_the_bound_has_the_median_of_the_line() {
        // The same program; two of the cases are at 0.11 or above, and their y is not known.
        let known = |[x, y]: [f64; 2]| [x, if y < 0.11 { y } else { f64::INFINITY }];
        let every_point: Vec<[f64; 2]> = points().into_iter().map(known).collect();
        let fit = Cloud::new(&every_point).fit(0.07, 0.11).unwrap();
        let expected = [
            0.541368669562324,
            0.1435351624881833,
            0.436694344921112,
            0.6711331158561833,
            0.06488632649768071,
            0.3175143976018674,
        ];
        compare(&fit, expected, 1e-11);
        assert!((fit.line.unwrap().slope / 1.1018938505346747 - 1.0).abs() < 1e-11);
    }

    #[test]
    fn intervals_hold_the_truth_as_often_as_they_say() {
        // ln y = ln 0.02 + 1.3 ln x + 0.35 e: at the limit 0.05 the median is 2.5^(1/1.3), the dispersion 0.35/1.3.
        let truth = [libm::pow(2.5, 1.0 / 1.3), 0.35 / 1.3];
        let mut random = ChaCha8Rng::seed_from_u64(7);
        let mut uniform = || (random.next_u64() >> 11) as f64 * 2f64.powi(-53) + 2f64.powi(-54);
        for (cases, collapse) in [(40, 0.12), (100, 0.06), (200, 0.06), (200, 0.12)] {
            let (mut hits, mut mean, samples) = ([0; 2], 0.0, 1000);
            for _ in 0..samples {
                let point = |i: usize| {
                    let x = 0.3 * exp(log(20.0) * i as f64 / (cases - 1) as f64);
                    let e = crate::normal::quantile(uniform());
                    let y = 0.02 * libm::pow(x, 1.3) * exp(0.35 * e);
                    [x, if y < collapse { y } else { f64::INFINITY }]
                };
                let points: Vec<[f64; 2]> = (0..cases).map(point).collect();
                let fit = Cloud::new(&points).fit(0.05, collapse).unwrap();
                mean += log(fit.function.median / truth[0]) / f64::from(samples);
                for ((hit, [low, high]), truth) in hits.iter_mut().zip(fit.intervals()).zip(truth) {
                    *hit += i32::from(low <= truth && truth <= high);
                }
            }
            let parts = hits.map(|hits| f64::from(hits) / f64::from(samples));
            // 1000 samples: 0.95 with a standard deviation of 0.007; that of a mean of medians is below 0.07/sqrt(1000).
            let is_right = |part: &f64| (0.92..=0.98).contains(part);
            assert!(parts.iter().all(is_right), "{cases} {collapse}: {parts:?}");
            assert!(mean.abs() < 0.01, "{cases} {collapse}: {mean}");
        }
    }

    #[test]
    fn clouds_without_a_fit_say_why() {
        let cloud = |points: &[[f64; 2]]| Cloud::new(points).fit(1.0, 1.0).unwrap_err();
        assert_eq!(cloud(&[[1.0, 1.0], [2.0, 3.0]]), NoFit::Few(3));
        assert_eq!(
            cloud(&[[1.0, 1.0], [2.0, 0.0], [3.0, 1.0]]),
            NoFit::NoLogarithm
        );
        assert_eq!(cloud(&[[1.0, 1.0], [1.0, 2.0], [1.0, 3.0]]), NoFit::Equal);
        let falling = [[1.0, 3.0], [2.0, 2.0], [3.0, 1.1], [4.0, 0.8]];
        assert_eq!(cloud(&falling), NoFit::NotRisingEnough);
        let level = [[1.0, 3.0], [2.0, 1.0], [3.0, 3.1], [4.0, 1.2]];
        assert_eq!(cloud(&level), NoFit::NotRisingEnough);
        // It rises, but a slope like this has a probability of 0.45 without any (t of 2 degrees of freedom, in closed form).
        let scattered = [[1.0, 1.0], [2.0, 3.0], [3.0, 1.2], [4.0, 2.9]];
        assert_eq!(cloud(&scattered), NoFit::NotRisingEnough);
        let beyond = [[1.0, f64::INFINITY]; 3];
        assert_eq!(cloud(&beyond), NoFit::Few(3));
        let falling = [[1.0, 3.0], [2.0, 0.5], [3.0, 0.2], [1.0, f64::INFINITY]];
        assert_eq!(cloud(&falling), NoFit::NotRisingEnough);
    }
}
