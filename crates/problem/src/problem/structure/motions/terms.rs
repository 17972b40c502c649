//! A derived quantity as a sum of what a run has.

use crate::system::structure::{Along, Motion, Quantity, Signal};
use std::sync::Arc;

/// A sum of factors times quantities of an instant.
#[derive(Debug, Clone, Default)]
pub struct Terms {
    /// Factors of u of nodes, of the rest with supports that move.
    pub u: Along,
    /// Factors of v of nodes.
    pub v: Along,
    /// Factors of the forces of contacts.
    pub s: Along,
    /// Functions of time with their factors.
    pub(super) signals: Vec<(f64, Arc<Signal>)>,
}

impl Terms {
    /// The value with these motions of nodes and forces of contacts, and this value of the functions of time.
    #[inline(always)]
    pub fn value(
        &self,
        u: impl Fn(usize) -> f64,
        v: impl Fn(usize) -> f64,
        s: impl Fn(usize) -> f64,
        of_time: f64,
    ) -> f64 {
        let sum = |terms: &Along, of: &dyn Fn(usize) -> f64| {
            terms
                .iter()
                .fold(0.0, |sum, (i, factor)| sum + factor * of(*i))
        };
        of_time + sum(&self.u, &u) + sum(&self.v, &v) + sum(&self.s, &s)
    }

    /// The functions of time at a time.
    pub fn at(&self, t: f64) -> f64 {
        let terms = self.signals.iter();
        terms.fold(0.0, |sum, (factor, signal)| sum + factor * signal.at(t))
    }

    /// The functions of time at 0, dt, .. steps dt.
    pub fn at_steps(&self, dt: f64, steps: usize) -> Vec<f64> {
        let mut sums = vec![0.0; steps + 1];
        for (factor, signal) in &self.signals {
            for (sum, x) in sums.iter_mut().zip(signal.at_steps(dt, steps)) {
                *sum += factor * x;
            }
        }
        sums
    }

    pub(super) fn add_motion(&mut self, factor: f64, motion: &Arc<Motion>, quantity: Quantity) {
        if factor != 0.0 {
            let signal = match quantity {
                Quantity::Acceleration => motion.shown_acceleration(),
                Quantity::Displacement | Quantity::Velocity => {
                    Signal::Motion(motion.clone(), quantity)
                }
            };
            self.signals.push((factor, Arc::new(signal)));
        }
    }
}
