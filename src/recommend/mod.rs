//! Recommends parameters: searches for the cheapest case that reaches a target.
//!
//! Candidates are on a grid and are computed in the order of their costs. A candidate reaches the target only if its
//! neighbours reach it too, so that no coincidence is recommended. Each search space defines the neighbours. No case may
//! gain or lose more energy than a limit. A recommended case also reaches the target with a finer step, if there is one.
//!
//! A space has many variants: laws with methods. All are compared on a coarse grid; the cheapest, and those of the papers, are
//! searched on the fine grid.

mod answer;
pub mod format;
pub mod friction;
mod grid;
pub mod impact;
mod level;
mod search;
pub mod setting;
mod space;
mod survey;
pub mod task;

pub use answer::{Answer, Candidate, Request, Stop, Target};
pub use search::search;
pub use setting::{Setting, Variant};
pub use space::{CostLevel, EnergyChange, Grid, SearchSpace, Variants};
pub use survey::{MOST, Recommendation, Survey, Surveyed, recommend};

/// A law and a method that are not searched, because the user gives them.
#[derive(Debug, Clone, Copy, Default)]
pub struct Fixed {
    /// Name of the law.
    pub law: Option<&'static str>,
    /// Name of the method.
    pub method: Option<&'static str>,
}

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
