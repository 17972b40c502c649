//! The largest likelihood of a function Phi(a + b z) of a logarithm z.

use super::spread::Spread;
use super::{Fit, Fragility, NoFit};
use crate::normal::{hazard, log_cumulative};
use libm::{exp, log};

/// Steps of Newton's method at most: each one at least quarters the distance in the likelihood of well posed data.
const STEPS: usize = 200;

/// Relative size of a last step.
const CONVERGED: f64 = 1e-13;

/// The logarithm of a likelihood at a place (a, b).
#[derive(Debug, Clone, Copy)]
pub(super) struct Local {
    pub value: f64,
    /// Its derivatives by a and b.
    pub slope: [f64; 2],
    /// The negative second derivatives by a, by a and b, and by b; of a concave one they are not negative.
    pub bend: [f64; 3],
}

/// Trials at one logarithm.
#[derive(Debug, Clone, Copy)]
pub(super) struct Point {
    pub z: f64,
    /// How many exceed, and how many do not.
    pub yes: f64,
    pub no: f64,
}

impl Point {
    pub(super) fn count(&self) -> f64 {
        self.yes + self.no
    }
}

/// Trials at several logarithms: ln Phi(u) of each that exceeds and ln Phi(-u) of each other one, without the binomial
/// coefficients, u = a + b z.
pub(super) fn of_trials(points: &[Point], [a, b]: [f64; 2]) -> Local {
    // Most places have trials of one kind only.
    let of = |count: f64, x: f64, f: fn(f64) -> f64| if count > 0.0 { f(x) } else { 0.0 };
    let value = |p: &Point| {
        let u = a + b * p.z;
        p.yes * of(p.yes, u, log_cumulative) + p.no * of(p.no, -u, log_cumulative)
    };
    let (mut g, mut h) = ([0.0; 2], [0.0; 3]);
    for p in points {
        let u = a + b * p.z;
        let (up, down) = (of(p.yes, u, hazard), of(p.no, -u, hazard));
        let slope = p.yes * up - p.no * down;
        // The negative second derivative; both terms are positive.
        let bend = p.yes * up * (up + u) + p.no * down * (down - u);
        g = [g[0] + slope, g[1] + slope * p.z];
        h = [h[0] + bend, h[1] + bend * p.z, h[2] + bend * p.z * p.z];
    }
    Local {
        value: points.iter().map(value).sum(),
        slope: g,
        bend: h,
    }
}

impl Local {
    /// Together with another one.
    pub(super) fn and(self, other: Local) -> Local {
        Local {
            value: self.value + other.value,
            slope: [0, 1].map(|i| self.slope[i] + other.slope[i]),
            bend: [0, 1, 2].map(|i| self.bend[i] + other.bend[i]),
        }
    }

    /// Newton's step.
    fn step(&self) -> [f64; 2] {
        let (g, h) = (self.slope, self.bend);
        let determinant = h[0] * h[2] - h[1] * h[1];
        if determinant.is_nan() || determinant <= 0.0 {
            return [0.0; 2];
        }
        [
            (h[2] * g[0] - h[1] * g[1]) / determinant,
            (h[0] * g[1] - h[1] * g[0]) / determinant,
        ]
    }
}

/// The function of the largest concave likelihood, by Newton's method with shortened steps from `at`; z is the logarithm less
/// `middle`.
pub(super) fn largest(
    middle: f64,
    mut at: [f64; 2],
    of: impl Fn([f64; 2]) -> Local,
) -> Result<Fit, NoFit> {
    let mut local = of(at);
    for _ in 0..STEPS {
        let step = local.step();
        let (mut next, mut length) = (at, 1.0);
        let mut reached = local;
        while length > 1e-9 {
            next = [0, 1].map(|k| at[k] + length * step[k]);
            reached = of(next);
            if reached.value >= local.value {
                break;
            }
            length /= 2.0;
        }
        if reached.value.is_nan() || reached.value < local.value {
            break;
        }
        let moved = (next[0] - at[0]).abs().max((next[1] - at[1]).abs());
        let size = 1.0 + next[0].abs().max(next[1].abs());
        (at, local) = (next, reached);
        if moved <= CONVERGED * size {
            break;
        }
    }
    let [a, b] = at;
    match b > 0.0 {
        true => Ok(Fit {
            function: Fragility {
                median: exp(middle - a / b),
                dispersion: 1.0 / b,
            },
            line: None,
            spread: Spread::of_information(at, local.bend),
        }),
        false => Err(NoFit::NotRising),
    }
}

/// The logarithms of values.
pub(super) fn logarithms(values: &[f64]) -> Vec<f64> {
    values.iter().map(|x| log(*x)).collect()
}
