//! The evolution strategy CMA-ES with weighted recombination of all points, also with negative weights, after N. Hansen, The CMA
//! Evolution Strategy: A Tutorial, arXiv:1604.00772 `[H]`, asked for points and given their misfits.

use super::linear::{Eigen, dot};
use libm::{exp, log};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::Rng;
use slipgap_statistics::normal;

/// A normal distribution of points that adapts to the misfit. Points outside of the unit cube are reflected into it.
#[derive(Debug)]
pub struct CmaEs {
    mean: Vec<f64>,
    sigma: f64,
    covariance: Vec<Vec<f64>>,
    /// Of the covariance, with the roots of its eigenvalues.
    shape: Eigen,
    path_of_sigma: Vec<f64>,
    path: Vec<f64>,
    generation: i32,
    points: Vec<Vec<f64>>,
    /// (x - m)/sigma of the points.
    steps: Vec<Vec<f64>>,
    random: ChaCha8Rng,
    rates: Rates,
}

/// The constants of the strategy, `[H, table 1]`.
#[derive(Debug)]
struct Rates {
    /// By rank.
    weights: Vec<f64>,
    /// Number of points with positive weights.
    parents: usize,
    mu_eff: f64,
    c_sigma: f64,
    d_sigma: f64,
    c_c: f64,
    c_1: f64,
    c_mu: f64,
    /// The mean length of a normal vector.
    chi: f64,
}

impl Rates {
    fn new(dimensions: usize, population: usize) -> Rates {
        let n = dimensions as f64;
        let half = (population as f64 + 1.0) / 2.0;
        let raw: Vec<f64> = (1..=population)
            .map(|i| log(half) - log(i as f64))
            .collect();
        let parents = population / 2;
        let (positive, negative) = raw.split_at(parents);
        let sum = |part: &[f64]| part.iter().sum::<f64>();
        let effective = |part: &[f64]| sum(part) * sum(part) / dot(part, part);
        let mu_eff = effective(positive);
        let c_1 = 2.0 / ((n + 1.3) * (n + 1.3) + mu_eff);
        let unbounded =
            2.0 * (0.25 + mu_eff + 1.0 / mu_eff - 2.0) / ((n + 2.0) * (n + 2.0) + mu_eff);
        let c_mu = unbounded.min(1.0 - c_1);
        let c_sigma = (mu_eff + 2.0) / (n + mu_eff + 5.0);
        // [H, (50) to (53)]
        let mu_eff_negative = effective(negative);
        let largest = (1.0 + c_1 / c_mu)
            .min(1.0 + 2.0 * mu_eff_negative / (mu_eff + 2.0))
            .min((1.0 - c_1 - c_mu) / (n * c_mu));
        let weight = |w: &f64| match *w > 0.0 {
            true => w / sum(positive),
            false => w * largest / -sum(negative),
        };
        Rates {
            weights: raw.iter().map(weight).collect(),
            parents,
            mu_eff,
            c_sigma,
            d_sigma: 1.0 + 2.0 * (((mu_eff - 1.0) / (n + 1.0)).sqrt() - 1.0).max(0.0) + c_sigma,
            c_c: (4.0 + mu_eff / n) / (n + 4.0 + 2.0 * mu_eff / n),
            c_1,
            c_mu,
            chi: n.sqrt() * (1.0 - 1.0 / (4.0 * n) + 1.0 / (21.0 * n * n)),
        }
    }
}

impl CmaEs {
    /// `population` points a generation round `mean`, first with the standard deviation `sigma` in all directions.
    pub fn new(mean: Vec<f64>, sigma: f64, population: usize, random: ChaCha8Rng) -> CmaEs {
        let n = mean.len();
        let shape = Eigen::unit(n);
        CmaEs {
            covariance: shape.with(&shape.values),
            shape,
            sigma,
            path_of_sigma: vec![0.0; n],
            path: vec![0.0; n],
            generation: 0,
            points: Vec::new(),
            steps: Vec::new(),
            random,
            rates: Rates::new(n, population),
            mean,
        }
    }

    /// The points of the next generation.
    pub fn ask(&mut self) -> Vec<Vec<f64>> {
        self.steps.clear();
        self.points.clear();
        for _ in 0..self.rates.weights.len() {
            let mut point = self.mean.clone();
            for (length, direction) in self.shape.values.iter().zip(&self.shape.vectors) {
                let step = self.sigma * length * standard_normal(&mut self.random);
                point
                    .iter_mut()
                    .zip(direction)
                    .for_each(|(x, b)| *x += step * b);
            }
            point.iter_mut().for_each(|x| *x = reflected(*x));
            let step = point.iter().zip(&self.mean);
            self.steps
                .push(step.map(|(x, m)| (x - m) / self.sigma).collect());
            self.points.push(point);
        }
        self.points.clone()
    }

    /// Adapts the distribution to the misfits of the points of [`ask`](CmaEs::ask).
    pub fn tell(&mut self, misfits: &[f64]) {
        let (n, rates) = (self.mean.len(), &self.rates);
        let mut order: Vec<usize> = (0..self.steps.len()).collect();
        order.sort_by(|a, b| misfits[*a].total_cmp(&misfits[*b]));
        let mut mean_step = vec![0.0; n];
        for (weight, point) in rates.weights.iter().zip(&order).take(rates.parents) {
            let step = mean_step.iter_mut().zip(&self.steps[*point]);
            step.for_each(|(to, y)| *to += weight * y);
        }
        let moved = self.mean.iter_mut().zip(&mean_step);
        moved.for_each(|(m, y)| *m = reflected(*m + self.sigma * y));
        // [H, (43), (44)]: the path of sigma, in coordinates in which the distribution is a sphere.
        self.generation += 1;
        let factor = (rates.c_sigma * (2.0 - rates.c_sigma) * rates.mu_eff).sqrt();
        let round = whitened(&self.shape, &mean_step);
        let path = self.path_of_sigma.iter_mut().zip(&round);
        path.for_each(|(p, y)| *p = (1.0 - rates.c_sigma) * *p + factor * y);
        let length = dot(&self.path_of_sigma, &self.path_of_sigma).sqrt();
        let grown = rates.c_sigma / rates.d_sigma * (length / rates.chi - 1.0);
        // [H, (45)]: the path of the covariance stalls while sigma grows fast.
        let age = 1.0 - libm::pow(1.0 - rates.c_sigma, 2.0 * f64::from(self.generation));
        let limit = (1.4 + 2.0 / (n as f64 + 1.0)) * rates.chi;
        let stalled = length / age.sqrt() >= limit;
        let factor = (rates.c_c * (2.0 - rates.c_c) * rates.mu_eff).sqrt();
        for (p, y) in self.path.iter_mut().zip(&mean_step) {
            *p = (1.0 - rates.c_c) * *p + if stalled { 0.0 } else { factor * y };
        }
        // [H, (46), (47)]
        let sum: f64 = rates.weights.iter().sum();
        let lost = if stalled {
            rates.c_c * (2.0 - rates.c_c)
        } else {
            0.0
        };
        let kept = 1.0 + rates.c_1 * lost - rates.c_1 - rates.c_mu * sum;
        self.covariance
            .iter_mut()
            .flatten()
            .for_each(|c| *c *= kept);
        add(&mut self.covariance, rates.c_1, &self.path);
        for (weight, point) in rates.weights.iter().zip(&order) {
            let step = &self.steps[*point];
            let round = whitened(&self.shape, step);
            let scale = if *weight < 0.0 {
                n as f64 / dot(&round, &round).max(1e-300)
            } else {
                1.0
            };
            add(&mut self.covariance, rates.c_mu * weight * scale, step);
        }
        self.sigma *= exp(grown.min(1.0));
        self.reshape();
    }

    /// Axes and lengths of the covariance. A matrix that rounding made indefinite is replaced by a sphere.
    fn reshape(&mut self) {
        let positive = |eigen: &Eigen| eigen.values.iter().all(|x| *x > 0.0);
        self.shape = match Eigen::of(&self.covariance).filter(positive) {
            Some(mut eigen) => {
                eigen.values.iter_mut().for_each(|x| *x = x.sqrt());
                eigen
            }
            None => {
                let unit = Eigen::unit(self.mean.len());
                self.covariance = unit.with(&unit.values);
                unit
            }
        };
        // Wider distributions are uniform after reflection.
        self.sigma = self.sigma.min(
            1.0 / self
                .shape
                .values
                .iter()
                .fold(f64::MIN_POSITIVE, |a, b| a.max(*b)),
        );
    }

    /// A point of the last generation.
    pub fn point(&self, index: usize) -> &[f64] {
        &self.points[index]
    }

    /// The axes of the distribution and its standard deviations along them.
    pub fn axes(&self) -> Eigen {
        let values = self.shape.values.iter().map(|x| self.sigma * x);
        Eigen {
            values: values.collect(),
            vectors: self.shape.vectors.clone(),
        }
    }
}

/// C^(-1/2) y.
fn whitened(shape: &Eigen, step: &[f64]) -> Vec<f64> {
    let mut round = vec![0.0; step.len()];
    for (length, direction) in shape.values.iter().zip(&shape.vectors) {
        let along = dot(direction, step) / length;
        round
            .iter_mut()
            .zip(direction)
            .for_each(|(to, b)| *to += along * b);
    }
    round
}

/// Adds weight y y^T.
fn add(matrix: &mut [Vec<f64>], weight: f64, y: &[f64]) {
    for (row, a) in matrix.iter_mut().zip(y) {
        row.iter_mut()
            .zip(y)
            .for_each(|(to, b)| *to += weight * a * b);
    }
}

/// A coordinate reflected at 0 and 1, as often as needed.
pub fn reflected(x: f64) -> f64 {
    let folded = x - 2.0 * (x / 2.0).floor();
    if folded > 1.0 { 2.0 - folded } else { folded }
}

/// By the inverse of the distribution, so that the bits do not depend on the platform.
fn standard_normal(random: &mut ChaCha8Rng) -> f64 {
    let uniform = ((random.next_u64() >> 12) as f64 + 0.5) / (1_u64 << 52) as f64;
    normal::quantile(uniform)
}
