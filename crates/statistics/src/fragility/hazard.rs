//! Mean annual frequencies of exceeding a limit, from a hazard curve.

use super::Fragility;
use crate::normal::{cumulative, log_cumulative};
use libm::{exp, log};

/// How often a year an intensity measure exceeds its values: straight between points of the logarithms, and on beyond them.
#[derive(Debug, Clone, PartialEq)]
pub struct Hazard {
    /// Logarithms of the value and of its annual frequency, by rising value; at least two.
    points: Vec<[f64; 2]>,
}

impl Hazard {
    /// The curve through points of values, rising, and annual frequencies, falling; all are positive. `None` for less than two.
    pub fn new(points: &[[f64; 2]]) -> Option<Hazard> {
        let points: Vec<[f64; 2]> = points.iter().map(|point| point.map(log)).collect();
        (points.len() > 1).then_some(Hazard { points })
    }

    /// The annual frequency of values above `x`.
    pub fn frequency(&self, x: f64) -> f64 {
        let z = log(x);
        let [at, height] = self.points[self.segment(z)];
        exp(height - self.steepness(self.segment(z)) * (z - at))
    }

    /// The segment with the logarithm `z`.
    fn segment(&self, z: f64) -> usize {
        let inner = &self.points[1..self.points.len() - 1];
        inner.iter().take_while(|point| point[0] < z).count()
    }

    /// -d ln(frequency)/d ln(x) of a segment.
    fn steepness(&self, i: usize) -> f64 {
        let [[x0, y0], [x1, y1]] = [self.points[i], self.points[i + 1]];
        (y0 - y1) / (x1 - x0)
    }

    /// The mean of the frequency over the capacities between `low` and `high`, times their probability: the integral of
    /// H dP. From 0 to infinity it is the mean annual frequency of exceeding the limit. Each segment H = h x^-k is integrated in
    /// closed form, so that the error is that of rounding.
    pub fn between(&self, function: &Fragility, low: f64, high: f64) -> f64 {
        let (median, beta) = (log(function.median), function.dispersion);
        let [low, high] = [low, high].map(log);
        let last = self.points.len() - 2;
        let part = |i: usize| {
            let from = if i == 0 {
                low
            } else {
                low.max(self.points[i][0])
            };
            let to = match i == last {
                true => high,
                false => high.min(self.points[i + 1][0]),
            };
            if from >= to {
                return 0.0;
            }
            let k = self.steepness(i);
            let [at, height] = self.points[i];
            let normal = |z: f64| (z - median) / beta + k * beta;
            let factor = height - k * (median - at) + 0.5 * k * k * beta * beta;
            normal_between(factor, normal(from), normal(to))
        };
        (0..=last).map(part).sum()
    }

    /// The mean annual frequency of exceeding the limit.
    pub fn annual(&self, function: &Fragility) -> f64 {
        self.between(function, 0.0, f64::INFINITY)
    }

    /// The part of it that is from beyond the ends of the curve.
    pub fn outside(&self, function: &Fragility) -> f64 {
        let [first, last] = [0, self.points.len() - 1].map(|i| exp(self.points[i][0]));
        let below = self.between(function, 0.0, first);
        let above = self.between(function, last, f64::INFINITY);
        (below + above) / self.annual(function)
    }

    /// The closed form of Cornell et al. (2002): k0 median^-k exp(k^2 dispersion^2/2), of the curve's tangent k0 x^-k at the
    /// median.
    pub fn closed_form(&self, function: &Fragility) -> f64 {
        let k = self.steepness(self.segment(log(function.median)));
        let spread = k * function.dispersion;
        self.frequency(function.median) * exp(0.5 * spread * spread)
    }

    /// The mean of the frequency over the capacities between `low` and `high`, or at the capacity `low` = `high`.
    pub fn mean_between(&self, function: &Fragility, [low, high]: [f64; 2]) -> f64 {
        if low == high {
            return self.frequency(low);
        }
        let normal = |x: f64| (log(x) - log(function.median)) / function.dispersion;
        self.between(function, low, high) / normal_between(0.0, normal(low), normal(high))
    }
}

/// exp(`factor`) times the probability of a normal value between `low` and `high`, also where both are in one tail.
fn normal_between(factor: f64, low: f64, high: f64) -> f64 {
    if low > 0.0 {
        return normal_between(factor, -high, -low);
    }
    match high > 0.0 {
        true => exp(factor) * (cumulative(high) - cumulative(low)),
        false => exp(factor + log_cumulative(high)) - exp(factor + log_cumulative(low)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: f64, b: f64) {
        // Rounding of exponents up to 20.
        assert!((a / b - 1.0).abs() < 1e-13, "{a} {b}");
    }

    #[test]
    fn frequencies_are_those_of_quadrature() {
        // tests/reference/structures/fragility.py: the integral of P |dH| by mpmath in 40 digits, and the closed form.
        let curve = [
            [0.05, 0.02],
            [0.1, 0.008],
            [0.3, 0.001],
            [0.8, 1e-4],
            [2.0, 5e-6],
        ];
        let hazard = Hazard::new(&curve).unwrap();
        for (median, dispersion, annual, outside, closed) in [
            (
                0.9,
                0.45,
                0.00012602312931371076,
                0.0009334715994877114,
                0.00020080934595431517,
            ),
            (
                0.2,
                0.3,
                0.002520980511063776,
                1.6449176316776603e-5,
                0.002531164074874449,
            ),
            (
                5.0,
                0.6,
                1.6591892833682316e-6,
                0.34255547439180717,
                1.7121261641359587e-6,
            ),
        ] {
            let function = Fragility { median, dispersion };
            close(hazard.annual(&function), annual);
            close(hazard.outside(&function), outside);
            close(hazard.closed_form(&function), closed);
        }
        curve
            .iter()
            .for_each(|[x, y]| close(hazard.frequency(*x), *y));
    }

    #[test]
    fn a_power_law_has_the_closed_form() {
        let hazard = Hazard::new(&[[1.0, 1e-3], [10.0, 1e-6]]).unwrap();
        let function = Fragility {
            median: 0.7,
            dispersion: 0.5,
        };
        // 1e-3 0.7^-3 exp(9 0.25/2).
        let expected = 1e-3 / 0.343 * exp(1.125);
        close(hazard.annual(&function), expected);
        close(hazard.closed_form(&function), expected);
        // Parts add up, also far in a tail.
        let limits = [0.0, 1e-9, 0.7, 1e9, f64::INFINITY];
        let parts = limits
            .windows(2)
            .map(|p| hazard.between(&function, p[0], p[1]));
        close(parts.sum(), expected);
        // In a narrow interval it is the frequency there.
        for x in [0.01, 0.7, 50.0] {
            let narrow = hazard.mean_between(&function, [x, x * (1.0 + 1e-6)]);
            assert!(
                (narrow / hazard.frequency(x) - 1.0).abs() < 1e-5,
                "{narrow}"
            );
            close(hazard.mean_between(&function, [x, x]), hazard.frequency(x));
        }
        assert!(Hazard::new(&[[1.0, 1e-3]]).is_none());
    }
}
