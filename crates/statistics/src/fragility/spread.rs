//! What the intervals of a fitted function follow from.

use super::{Fragility, Line};
use crate::{CONFIDENCE, normal, student};
use libm::exp;

/// What the intervals of a fitted function follow from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Spread {
    /// The mean of the logarithms of this many capacities. Student's t and chi-square are exact.
    Capacities { mean: f64, count: f64 },
    /// A line through the logarithms of a cloud, and the height of the limit above its middle. The interval of the median is
    /// Fieller's, exact. That of the dispersion s/b has the variance 1/(2 (n - 2)) + s^2/(b^2 Sxx) of its logarithm, which
    /// holds for many cases.
    Cloud { line: Line, height: f64 },
    /// The variances of the logarithms of median and dispersion by the observed information, which hold for many trials.
    Information { variances: [f64; 2] },
    /// The same of a cloud with cases beyond a bound, by Student's t with the degrees of freedom of the line through the others: the
    /// deviation of few cases is too small on average.
    Bounded { variances: [f64; 2], free: f64 },
}

impl Spread {
    /// 95 % intervals of the median and of the dispersion of `function`.
    pub(super) fn intervals(&self, function: &Fragility) -> [[f64; 2]; 2] {
        let within = |x: f64, half: f64| [x * exp(-half), x * exp(half)];
        let normal = normal::quantile(0.5 + 0.5 * CONFIDENCE);
        let about = |x: f64, variance: f64| within(x, normal * variance.sqrt());
        let Fragility { median, dispersion } = *function;
        match *self {
            Spread::Capacities { mean, count } => {
                let free = count - 1.0;
                let half = student::quantile(free, CONFIDENCE) * dispersion / count.sqrt();
                let part = |p: f64| dispersion * (free / student::chi_square(free, p)).sqrt();
                let tails = [0.5 + 0.5 * CONFIDENCE, 0.5 - 0.5 * CONFIDENCE];
                [[exp(mean - half), exp(mean + half)], tails.map(part)]
            }
            Spread::Cloud { line, height } => {
                let variance = 0.5 / line.free() + dispersion * dispersion / line.sxx;
                [line.reaches(height), about(dispersion, variance)]
            }
            Spread::Information { variances } => {
                [about(median, variances[0]), about(dispersion, variances[1])]
            }
            Spread::Bounded { variances, free } => {
                let [of_median, of_dispersion] =
                    variances.map(|variance| student::quantile(free, CONFIDENCE) * variance.sqrt());
                [within(median, of_median), within(dispersion, of_dispersion)]
            }
        }
    }

    /// By the information `bend`, the negative second derivatives of the logarithm of the likelihood of Phi(a + b z) by a, a
    /// and b, and b: ln(median) is -a/b and more, ln(dispersion) is -ln b.
    pub(super) fn of_information([a, b]: [f64; 2], bend: [f64; 3]) -> Spread {
        let variances = variances([-1.0 / b, a / (b * b)], 0.0, b, bend);
        Spread::Information { variances }
    }
}

/// The variances of the logarithms of median and dispersion where ln(median) changes by `by` with a and b, and has a variance beside.
pub(super) fn variances(by: [f64; 2], beside: f64, b: f64, bend: [f64; 3]) -> [f64; 2] {
    let determinant = bend[0] * bend[2] - bend[1] * bend[1];
    let [aa, ab, bb] = [bend[2], -bend[1], bend[0]].map(|x| x / determinant);
    let median = by[0] * by[0] * aa + 2.0 * by[0] * by[1] * ab + by[1] * by[1] * bb;
    [median + beside, bb / (b * b)]
}

impl Line {
    /// Fieller's interval of the x at which the line is `height` above its middle, as exponentials: (b d - h)^2 <= t^2 s^2
    /// (1/n + d^2/Sxx) with d = x - mean.
    fn reaches(&self, height: f64) -> [f64; 2] {
        let width = self.width();
        let leading = self.slope * self.slope - width * width / self.sxx;
        let constant = height * height - width * width / self.count;
        let root = (self.slope * self.slope * height * height - leading * constant)
            .max(0.0)
            .sqrt();
        [-1.0, 1.0].map(|side| exp(self.x + (self.slope * height + side * root) / leading))
    }
}
