//! Which parameters to take: the cheapest case that reaches a target, found by computing.
//!
//! Candidates lie on a grid and are tried by rising cost. One reaches the target only if it does so for neighbours too
//! (each space says for which), so that no lucky cancellation is recommended.

pub mod friction;
pub mod impact;

use crate::problem::{Case, Problem};
use rayon::prelude::*;

/// A demand on a case: a number from its metrics, at most a limit.
#[derive(Debug, Clone)]
pub struct Target {
    /// What is demanded, as in `rms_error` or `abs(peak_force - 1)`.
    pub name: &'static str,
    /// Row of `problem.metrics()`.
    pub metric: usize,
    /// What is taken from the metric before its magnitude counts.
    pub ideal: f64,
    /// Largest magnitude allowed, > 0.
    pub limit: f64,
}

impl Target {
    /// How far a case misses the ideal; `None` where the metric is undefined.
    pub fn miss(&self, metrics: &[Option<f64>]) -> Option<f64> {
        Some((metrics[self.metric]? - self.ideal).abs())
    }
}

/// One candidate: a case, and the neighbours that must reach the target with it.
#[derive(Debug, Clone)]
pub struct Candidate {
    /// The case as recommended.
    pub case: Case,
    /// It and its neighbours.
    pub tried: Vec<Case>,
}

/// Candidates of the same cost.
#[derive(Debug)]
pub struct Rung {
    /// Steps, or steps times modes.
    pub cost: f64,
    /// The candidates.
    pub candidates: Vec<Candidate>,
}

/// Where to search.
pub trait Space: Sync {
    /// The problem.
    fn problem(&self) -> &'static dyn Problem;
    /// Names of the parameters that are recommended.
    fn free(&self) -> &'static [&'static str];
    /// What is searched, and what counts as neighbours, in words.
    fn said(&self) -> Vec<String>;
    /// What the cost counts.
    fn cost_title(&self) -> &'static str;
    /// All candidates, by rising cost.
    fn rungs(&self) -> Vec<Rung>;
}

/// The best candidate of a rung.
#[derive(Debug, Clone)]
pub struct Tried {
    /// Its case.
    pub case: Case,
    /// What it costs.
    pub cost: f64,
    /// The largest miss over its limit, of all targets and neighbours: at most 1 reaches the target.
    pub worst: f64,
}

/// What a search comes to.
#[derive(Debug)]
pub struct Answer {
    /// The best candidates of rungs that are better than every cheaper one, by rising cost.
    pub front: Vec<Tried>,
    /// Position in the front of the cheapest that reaches the target; `None` if none does.
    pub chosen: Option<usize>,
}

/// How much dearer than the recommended case alternatives are looked for.
const BEYOND: f64 = 4.0;

/// Searches a space by rising cost, and a little beyond the first candidate that reaches all targets.
pub fn search(space: &dyn Space, targets: &[Target]) -> Answer {
    let mut front: Vec<Tried> = Vec::new();
    let mut chosen: Option<usize> = None;
    for rung in space.rungs() {
        if chosen.is_some_and(|at| rung.cost > BEYOND * front[at].cost) {
            break;
        }
        let judged: Vec<f64> = rung
            .candidates
            .par_iter()
            .map(|candidate| worst(space.problem(), candidate, targets))
            .collect();
        let best = judged.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1));
        let Some((at, &worst)) = best.filter(|(_, worst)| worst.is_finite()) else {
            continue;
        };
        if front.last().is_none_or(|last| worst < last.worst) {
            front.push(Tried {
                case: rung.candidates[at].case.clone(),
                cost: rung.cost,
                worst,
            });
            if worst <= 1.0 && chosen.is_none() {
                chosen = Some(front.len() - 1);
            }
        }
    }
    Answer { front, chosen }
}

/// The largest miss over its limit; infinite where a case has no solution or a metric no value.
fn worst(problem: &dyn Problem, candidate: &Candidate, targets: &[Target]) -> f64 {
    let mut worst = 0.0_f64;
    for case in &candidate.tried {
        let Ok(solution) = problem.solve(case, &[]) else {
            return f64::INFINITY;
        };
        for target in targets {
            let miss = target.miss(&solution.metrics).unwrap_or(f64::INFINITY);
            worst = worst.max(miss / target.limit);
        }
    }
    worst
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
