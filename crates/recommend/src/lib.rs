//! Recommends parameters: searches for the cheapest case that reaches a target.
//!
//! Candidates are on a grid and are computed in the order of their costs. A candidate reaches the target only if its
//! neighbours reach it too, so that no coincidence is recommended. Each search space defines the neighbours. No case may
//! gain or lose more energy than a limit. A recommended case also reaches the target with finer steps, if there is one that does.
//!
//! A space has many variants: laws with methods. All are compared on a coarse grid; the cheapest, and those of the papers, are
//! searched on the fine grid.

mod answer;
pub mod calibrate;
pub mod format;
pub mod friction;
mod grid;
pub mod impact;
mod level;
mod refine;
mod robustness;
mod search;
pub mod setting;
mod space;
mod survey;
pub mod task;

pub use answer::{Answer, Candidate, Request, Stop, Target};
pub use refine::{
    LEAST_HALVINGS, MOST_HALVINGS, Outcome, Refined, SETTLED, refine, with_finer_step,
};
pub use robustness::{Robustness, robustness};
pub use search::search;
pub use setting::{Setting, Variant};
pub use space::{CostLevel, EnergyChange, Further, Grid, Range, SearchSpace, Variants};
pub use survey::{MOST, MOST_OWN_STEP, Recommendation, Survey, Surveyed, recommend};

/// A law and a method that are not searched, because the user gives them.
#[derive(Debug, Clone, Copy, Default)]
pub struct Fixed {
    /// Name of the law.
    pub law: Option<&'static str>,
    /// Name of the method.
    pub method: Option<&'static str>,
}

use slipgap_problem::problem::Problem;

/// The row of a metric; `usize::MAX` if the problem has no such metric, which no case has.
pub fn metric(problem: &dyn Problem, name: &str) -> usize {
    let row = problem.metrics().iter().position(|m| m.name == name);
    row.unwrap_or(usize::MAX)
}
