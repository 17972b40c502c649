//! Which parameters to take: the cheapest case that reaches a target, found by computing.
//!
//! Candidates lie on a grid and are tried by rising cost. One reaches the target only if it does so for neighbours too
//! (each space says for which), so that no lucky cancellation is recommended. None may gain more energy than a limit.

pub mod energy;
pub mod friction;
pub mod impact;
mod search;

pub use search::search;

use crate::history::History;
use crate::problem::parameter::Value;
use crate::problem::{Case, Problem};

/// A demand on a case: the miss of one of its metrics, at most a limit.
#[derive(Debug, Clone)]
pub struct Target {
    /// What is demanded, as in `rms_error`.
    pub name: &'static str,
    /// Row of `problem.metrics()`.
    pub metric: usize,
    /// What the metric should be: its relative error counts; 0 where the metric is an error itself.
    pub ideal: f64,
    /// Largest miss allowed, > 0.
    pub limit: f64,
}

impl Target {
    /// How far a case misses the ideal; infinite where the metric is undefined.
    pub fn miss(&self, metrics: &[Option<f64>]) -> f64 {
        let scale = if self.ideal == 0.0 { 1.0 } else { self.ideal };
        let metric = metrics.get(self.metric).copied().flatten();
        metric.map_or(f64::INFINITY, |x| ((x - self.ideal) / scale).abs())
    }
}

/// What is asked of a case and its neighbours.
#[derive(Debug, Clone)]
pub struct Request {
    /// What they must reach.
    pub targets: Vec<Target>,
    /// Most energy that they may gain, over that at the start; `None` for a problem whose law only takes energy.
    pub energy_gain: Option<f64>,
}

/// Candidates of the same cost, and the cases that decide about them.
#[derive(Debug, Default)]
pub struct Rung {
    /// Candidates and neighbours.
    pub cases: Vec<Case>,
    /// For each candidate its place in `cases`, then those of its neighbours.
    pub candidates: Vec<Vec<usize>>,
}

/// Where to search.
pub trait Space: Sync {
    /// The problem.
    fn problem(&self) -> &'static dyn Problem;
    /// Names of the parameters that an answer shows.
    fn shown(&self) -> Vec<&'static str>;
    /// Names of the parameters that a study of the answer needs.
    fn stated(&self) -> Vec<&str>;
    /// What is searched, what counts as neighbours, and what is not searched, in words.
    fn notes(&self) -> Vec<String>;
    /// What the cost counts.
    fn cost_title(&self) -> &'static str;
    /// The cost of every rung.
    fn costs(&self) -> Vec<u64>;
    /// A rung by its place in `costs`.
    fn rung(&self, at: usize) -> Rung;
    /// Row of the metric that is the largest change of energy, with its sign, and of that at the end.
    fn energy_drifts(&self) -> Option<[usize; 2]>;
    /// The largest gain of energy on the way, over the energy at the start; `None` where energy is not watched.
    fn energy_gain(&self, case: &Case, computed: &History) -> Option<f64>;
}

/// The best candidate of a cost.
#[derive(Debug, Clone)]
pub struct Tried {
    /// Its case, then its neighbours.
    pub cases: Vec<Case>,
    /// What it costs.
    pub cost: u64,
    /// The largest miss of each target, over case and neighbours.
    pub misses: Vec<f64>,
    /// The largest miss over its limit: at most 1 reaches the target.
    pub worst: f64,
}

/// What a search comes to.
#[derive(Debug, Default)]
pub struct Answer {
    /// The best candidate of every cost that buys a smaller `worst` than all lower costs, by rising cost.
    pub front: Vec<Tried>,
    /// Number of cases solved.
    pub solved: u64,
}

/// How many times finer a step is that shows whether an answer holds only at its own step. Half the step is not enough: it
/// may still pass over the contact mode, as the answer's own does.
pub const FINER: f64 = 16.0;

/// A case with a finer step.
pub fn with_a_finer_step(problem: &dyn Problem, case: &Case) -> Case {
    let mut finer = case.clone();
    let row = case
        .schema
        .parameters
        .iter()
        .position(|p| p.name == problem.schema().step_name());
    if let Some(row) = row
        && let Some(step) = case.at(row)
    {
        finer.values[row] = Some(Value::Number(step / FINER));
    }
    finer
}

/// Part of cost or of `worst` by which alternatives differ at least.
const APART: f64 = 0.8;

impl Answer {
    /// Position of the cheapest that reaches the target; `None` if none does.
    pub fn chosen(&self) -> Option<usize> {
        self.front.iter().position(|tried| tried.worst <= 1.0)
    }

    /// Position of a clearly cheaper one before `at`: by a fifth, else the first.
    pub fn cheaper(&self, at: usize) -> Option<usize> {
        let most = APART * self.front[at].cost as f64;
        let clearly = self.front[..at].iter().rposition(|t| t.cost as f64 <= most);
        clearly.or_else(|| (at > 0).then_some(0))
    }

    /// Position of the first after `at` that is clearly better: by a fifth.
    pub fn better(&self, at: usize) -> Option<usize> {
        let most = APART * self.front[at].worst;
        let found = self.front[at..].iter().position(|t| t.worst <= most);
        found.map(|further| at + further)
    }
}

/// The row of a metric; beyond the table, where every case misses, if there is none.
pub fn metric(problem: &dyn Problem, name: &str) -> usize {
    let found = problem.metrics().iter().position(|m| m.name == name);
    found.unwrap_or(usize::MAX)
}

/// Numbers in equal ratios from `from` to `to`, `count` a decade, to three digits as one would write them.
fn written(from: f64, to: f64, count: f64) -> Vec<f64> {
    let steps = (libm::log10(to / from) * count).round() as i32;
    let number = |i| from * libm::pow(10.0, f64::from(i) / count);
    let mut all: Vec<f64> = (0..=steps)
        .filter_map(|i| format!("{:.2e}", number(i)).parse().ok())
        .collect();
    all.dedup();
    all
}

/// Whole numbers from `from` to `to`, each at least `ratio` times the one before.
fn wholes(from: u32, to: u32, ratio: f64) -> Vec<u32> {
    let next = |n: &u32| Some((f64::from(*n) * ratio).ceil().max(f64::from(*n) + 1.0) as u32);
    std::iter::successors(Some(from), next)
        .take_while(|n| *n <= to)
        .collect()
}
