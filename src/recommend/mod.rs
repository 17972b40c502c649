//! Recommends parameters: searches for the cheapest case that reaches a target.
//!
//! Candidates are on a grid and are computed in the order of their costs. A candidate reaches the target only if its
//! neighbours reach it too, so that no coincidence is recommended. Each search space defines the neighbours. No case may
//! gain more energy than a limit.

mod answer;
pub mod format;
pub mod friction;
mod grid;
pub mod impact;
mod search;
mod space;

pub use answer::{Answer, Candidate, Request, Target};
pub use search::search;
pub use space::{CostLevel, SearchSpace};

use crate::problem::parameter::Value;
use crate::problem::{Case, Problem};

/// The factor between an answer's step and the finer step that tests whether the answer depends on its step. Half the step
/// is not enough: it may still be too long for the contact mode.
pub const FINER: f64 = 16.0;

/// The case with its step divided by [`FINER`].
pub fn with_finer_step(problem: &dyn Problem, case: &Case) -> Case {
    let step = problem.schema().step;
    let mut finer = case.clone();
    finer.values[step] = case.at(step).map(|step| Value::Number(step / FINER));
    finer
}

/// The row of a metric; `usize::MAX` if the problem has no such metric, which no case has.
pub fn metric(problem: &dyn Problem, name: &str) -> usize {
    let row = problem.metrics().iter().position(|m| m.name == name);
    row.unwrap_or(usize::MAX)
}
