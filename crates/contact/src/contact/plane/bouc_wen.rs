//! The isotropic Bouc-Wen model in a plane.
//!
//! ```text
//! u_y dz = dr - z |z|^(n-2) (beta |z . dr| + gamma z . dr),   S = L z,   beta + gamma = 1
//! ```
//!
//! In one direction it is the scalar model. It is isotropic, as the part with gamma of the model of Park, Wen and Ang (1986), and
//! |z| <= 1.

use super::{Over, PlaneLaw, PlaneStep, PlaneTrial, Root};
use crate::contact::BoucWen;
use crate::contact::pair::{Pair, cut, dot, length, map, root};

/// Of the two implicit stages, which are of second order and damp what is much faster than a step: 1 - 1/sqrt 2.
const GAMMA: f64 = 1.0 - std::f64::consts::FRAC_1_SQRT_2;

impl PlaneLaw for BoucWen {
    type Step = ();
    type Memory = ();

    fn step(&self, _: &PlaneStep) {}

    fn answer(&self, Over { on, .. }: &Over<Self>, trial: &PlaneTrial) -> (Pair, ()) {
        if self.limit <= 0.0 {
            return ([0.0; 2], ());
        }
        let yield_displacement = self.compliance * self.limit;
        let before = cut(trial.force, self.limit).map(|s| s / self.limit);
        let after = |force: Pair| {
            let u = map(trial.change, force, |c, s| {
                (c - on.h * s) / yield_displacement
            });
            over([self.exponent, self.d()], before, u)
        };
        if on.h == 0.0 {
            return (after([0.0; 2]).map(|z| self.limit * z), ());
        }
        // As far as the elastic part goes.
        let share = 1.0 / (self.compliance + on.h);
        let elastic = map(trial.force, trial.change, |s, c| {
            (self.compliance * s + c) * share
        });
        let residual = |force: Pair| map(force, after(force), |s, z| s - self.limit * z);
        let start = cut(elastic, self.limit);
        (root(residual, start, 1e-6 * self.limit), ())
    }

    fn slopes(&self, over: &Over<Self>, root: &Root) -> (Pair, Pair) {
        over.slopes_by_differences(self, root, 1e-6 * (self.compliance * self.limit))
    }

    fn bound(&self) -> f64 {
        self.limit
    }

    fn rate(&self, z: Pair, rdot: Pair) -> Pair {
        if self.limit <= 0.0 {
            return [0.0; 2];
        }
        let along = turning(self.d(), dot(z, rdot));
        let size = length(z);
        let turn = match size > 0.0 {
            true => libm::pow(size / self.limit, self.exponent) * along / (size * size),
            false => 0.0,
        };
        map(rdot, z, |v, z| (v - turn * z) / self.compliance)
    }
}

/// beta |z . dr| + gamma z . dr of z . dr, d = beta - gamma.
fn turning(d: f64, along: f64) -> f64 {
    along.max(0.0) + d * (-along).max(0.0)
}

/// z after a straight motion u in units of u_y, of n and d.
fn over([n, d]: [f64; 2], z: Pair, u: Pair) -> Pair {
    let slope = |z: Pair| {
        let along = turning(d, dot(z, u));
        let size = length(z);
        let turn = match n {
            2.0 => along,
            _ if size == 0.0 => 0.0,
            1.0 => along / size,
            _ => along * libm::pow(size, n - 2.0),
        };
        map(u, z, |u, z| u - turn * z)
    };
    let stage = |from: Pair| {
        let rest = |to: Pair| {
            let slope = slope(to);
            std::array::from_fn(|i| to[i] - from[i] - GAMMA * slope[i])
        };
        root(rest, cut(map(from, u, |z, u| z + GAMMA * u), 1.0), 1e-7)
    };
    let first = stage(z);
    let extended = (1.0 - GAMMA) / GAMMA;
    let second = stage(map(z, first, |z, first| z + extended * (first - z)));
    cut(second, 1.0)
}
