//! What a search is for, and its result.

use slipgap_problem::problem::Case;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// A limit of the error of a metric.
#[derive(Debug, Clone)]
pub struct Target {
    /// Name of the error, as in `rms_error`.
    pub name: &'static str,
    /// Row of `problem.metrics()`.
    pub metric: usize,
    /// The ideal value, with which the error is relative; 0 if the metric is an error itself.
    pub ideal: f64,
    /// Largest error allowed, > 0.
    pub limit: f64,
}

impl Target {
    /// The error of a case; infinite if the metric is undefined.
    pub fn error(&self, metrics: &[Option<f64>]) -> f64 {
        self.signed_error(metrics).abs()
    }

    /// The same with its sign.
    pub fn signed_error(&self, metrics: &[Option<f64>]) -> f64 {
        let scale = if self.ideal == 0.0 { 1.0 } else { self.ideal };
        let metric = metrics.get(self.metric).copied().flatten();
        metric.map_or(f64::INFINITY, |x| (x - self.ideal) / scale)
    }
}

/// The requirements for a case and its neighbours.
#[derive(Debug, Clone)]
pub struct Request {
    /// Limits of errors.
    pub targets: Vec<Target>,
    /// Largest gain of energy at any step, relative to the energy at the start.
    pub energy_gain: f64,
    /// Largest loss of energy up to the last step, relative to the same; infinite for a problem that loses energy.
    pub energy_loss: f64,
    /// Ends the search early.
    pub stop: Stop,
}

/// Ends a search from another thread; clones end the same one. The answer is then that of the levels searched so far.
#[derive(Debug, Clone, Default)]
pub struct Stop(Arc<AtomicBool>);

impl Stop {
    /// Ends the search before its next level.
    pub fn stop(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Whether the search ends.
    pub fn is_stopped(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// The best candidate of a cost.
#[derive(Debug, Clone)]
pub struct Candidate {
    /// Its case, then its neighbours and the other conditions for which it holds. The first is the one with the largest error of its own
    /// conditions.
    pub cases: Vec<Case>,
    /// Its cost.
    pub cost: u64,
    /// The largest error for each target, over case and neighbours.
    pub errors: Vec<f64>,
    /// The largest quotient of error and limit. The candidate reaches the target if it is at most 1.
    pub worst: f64,
    /// Whether it also reaches the target with finer steps, see [`refine`](super::refine()).
    pub converged: bool,
}

/// The result of a search.
#[derive(Debug, Default)]
pub struct Answer {
    /// The best candidate of every cost at which `worst` is smaller than at all lower costs, in the order of costs. Those that reach the
    /// target also do with finer steps, unless no candidate does.
    pub front: Vec<Candidate>,
    /// The cheapest candidate that reaches the target only with its own step, if it costs less than the recommended one.
    pub own_step: Option<Candidate>,
    /// Number of cases solved.
    pub solved: u64,
}

/// Largest quotient of costs or of `worst` of clearly different candidates.
const CLEARLY: f64 = 0.8;

impl Answer {
    /// Index of the cheapest candidate that reaches the target, if any.
    pub fn chosen(&self) -> Option<usize> {
        self.front
            .iter()
            .position(|candidate| candidate.worst <= 1.0)
    }

    /// Index of the last candidate that costs clearly less than the one at `at`, else the first.
    pub fn cheaper(&self, at: usize) -> Option<usize> {
        let most = CLEARLY * self.front[at].cost as f64;
        let clearly = self.front[..at].iter().rposition(|c| c.cost as f64 <= most);
        clearly.or_else(|| (at > 0).then_some(0))
    }

    /// Index of the first candidate after `at` that is clearly better.
    pub fn better(&self, at: usize) -> Option<usize> {
        let most = CLEARLY * self.front[at].worst;
        let further = self.front[at..].iter().position(|c| c.worst <= most);
        further.map(|further| at + further)
    }
}
