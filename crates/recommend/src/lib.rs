//! Recommends parameters: searches for the cheapest case that reaches a target.
//!
//! Candidates are on a grid and are computed in the order of their costs. A candidate reaches the target only if its
//! neighbours reach it too, so that no coincidence is recommended. Each search space defines the neighbours. No case may
//! gain or lose more energy than a limit. A recommended case also reaches the target with finer steps, if there is one that does.
//!
//! A space has many variants: laws with methods. All are compared on a coarse grid; the cheapest, and those of the papers, are
//! searched on the fine grid (`grid`, with the spaces `friction` and `impact`). Of any study, `study` compares the candidates that it
//! lists, with free parameters by the search of `calibrate`.

pub mod calibrate;
pub mod format;
pub mod friction;
mod grid;
pub mod impact;
pub mod setting;
pub mod study;
pub mod task;

pub use grid::{
    Answer, Candidate, CostLevel, EnergyChange, Further, Grid, LEAST_HALVINGS, MOST, MOST_HALVINGS,
    MOST_OWN_STEP, Outcome, Range, Recommendation, Refined, Request, Robustness, SETTLED,
    SearchSpace, Stop, Survey, Surveyed, Target, Variants, recommend, refine, robustness, search,
    with_finer_step,
};
pub use setting::{Setting, Variant};

/// A law and a method that are not searched, because the user gives them.
#[derive(Debug, Clone, Copy, Default)]
pub struct Fixed {
    /// Name of the law.
    pub law: Option<&'static str>,
    /// Name of the method.
    pub method: Option<&'static str>,
}

use slipgap_problem::problem::friction::FrictionOscillator;
use slipgap_problem::problem::{Case, Problem};

/// Cost of a case: steps times modes or nodes, times the sub-steps of its method.
pub fn cost(problem: &dyn Problem, case: &Case) -> u64 {
    let method = setting::method_named(case.choice("method"));
    let parts = method.filter(|_| problem.name() == FrictionOscillator.name());
    // The work of the other problems has them.
    problem.work(case) * parts.map_or(1, |method| method.count_of_sub_steps())
}

/// The row of a metric; `usize::MAX` if the problem has no such metric, which no case has.
pub fn metric(problem: &dyn Problem, name: &str) -> usize {
    let row = problem.metrics().iter().position(|m| m.name == name);
    row.unwrap_or(usize::MAX)
}
