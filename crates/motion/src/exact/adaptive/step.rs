//! A step of order 8, and its error.

use super::Flow;
use super::tableau::{A, B, C, E3, E5, STAGES};

/// The numbers of a step.
#[derive(Debug)]
pub struct Step {
    /// Rates of the stages.
    rates: [Vec<f64>; STAGES],
    stage: Vec<f64>,
    /// The state at the end.
    pub end: Vec<f64>,
}

impl Step {
    /// Zeros for so many components.
    pub fn new(len: usize) -> Step {
        Step {
            rates: std::array::from_fn(|_| vec![0.0; len]),
            stage: vec![0.0; len],
            end: vec![0.0; len],
        }
    }

    /// Computes the rates at the start of the next steps.
    pub fn begin(&mut self, flow: &mut impl Flow, t: f64, y: &[f64]) {
        flow.rates(t, y, &mut self.rates[0]);
    }

    /// Computes the end of a step of `h` from `y`, whose rates are known.
    pub fn take(&mut self, flow: &mut impl Flow, t: f64, h: f64, y: &[f64]) {
        for i in 1..STAGES {
            let (known, rest) = self.rates.split_at_mut(i);
            combine(&mut self.stage, y, h, A[i], known);
            flow.rates(t + C[i] * h, &self.stage, &mut rest[0]);
        }
        combine(&mut self.end, y, h, &B, &self.rates);
    }

    /// The error of the step over the scales of its components, the tolerance included: at most 1 of a good step.
    pub fn error(&self, h: f64, scales: &[f64]) -> f64 {
        let [mut fifth, mut third]: [f64; 2] = [0.0; 2];
        for (i, scale) in scales.iter().enumerate() {
            let sum = |weights: &[f64; STAGES]| {
                let terms = weights.iter().zip(&self.rates);
                terms.map(|(w, rates)| w * rates[i]).sum::<f64>().abs()
            };
            let [own_fifth, own_third] = [sum(&E5), sum(&E3)];
            // A component that has not moved yet has no scale.
            if *scale > 0.0 {
                fifth = fifth.max(own_fifth / scale);
                third = third.max(own_third / scale);
            } else if own_fifth > 0.0 {
                return f64::INFINITY;
            }
        }
        let norm = (fifth * fifth + 0.01 * third * third).sqrt();
        // Not a number of a state that is none: the step is too long.
        match norm > 0.0 {
            true => h * fifth * (fifth / norm),
            false if norm == 0.0 => 0.0,
            false => f64::INFINITY,
        }
    }
}

/// y + h times the weighted sum of rates.
fn combine(to: &mut [f64], y: &[f64], h: f64, weights: &[f64], rates: &[Vec<f64>]) {
    to.fill(0.0);
    for (w, rates) in weights.iter().zip(rates) {
        if *w != 0.0 {
            to.iter_mut().zip(rates).for_each(|(to, k)| *to += w * k);
        }
    }
    to.iter_mut().zip(y).for_each(|(to, y)| *to = y + h * *to);
}
