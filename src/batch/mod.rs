//! Runs a study: every case through its problem, in parallel, in an order that no result depends on.

pub mod output;
pub mod results;

use crate::error::Error;
use crate::problem::{Case, Solution};
use crate::study::Study;
use indicatif::ProgressBar;
use rayon::prelude::*;

/// What became of one case.
#[derive(Debug)]
pub struct Outcome {
    /// The case.
    pub case: Case,
    /// In the order of `problem.metrics()`; `None` where one is undefined or the case could not be solved.
    pub metrics: Vec<Option<f64>>,
    /// The histories, where they were asked for.
    pub solution: Option<Solution>,
    /// Why the case could not be solved, if so.
    pub failure: Option<String>,
}

/// Runs every case; keeps the histories of those that `keep` picks, and shows each solution to `visit`.
///
/// # Errors
/// The first error of `visit` in case order.
pub fn run(
    study: &Study,
    bar: &ProgressBar,
    keep: impl Fn(&Case) -> bool + Sync,
    visit: impl Fn(u64, &Solution) -> Result<(), Error> + Sync,
) -> Result<Vec<Outcome>, Error> {
    let outcomes: Vec<Result<Outcome, Error>> = (0..study.len())
        .into_par_iter()
        .filter_map(|index| {
            let outcome = solve(study, index, study.case(index)?, &keep, &visit);
            bar.inc(1);
            Some(outcome)
        })
        .collect();
    outcomes.into_iter().collect()
}

fn solve(
    study: &Study,
    index: u64,
    case: Case,
    keep: impl Fn(&Case) -> bool,
    visit: impl Fn(u64, &Solution) -> Result<(), Error>,
) -> Result<Outcome, Error> {
    let solved = match study.once {
        true => study.problem.solve_once(&case, &study.metrics),
        false => study.problem.solve(&case, &study.metrics),
    };
    Ok(match solved {
        Ok(solution) => {
            visit(index, &solution)?;
            Outcome {
                metrics: solution.metrics.clone(),
                solution: keep(&case).then_some(solution),
                failure: None,
                case,
            }
        }
        Err(why) => Outcome {
            metrics: vec![None; study.problem.metrics().len()],
            solution: None,
            failure: Some(why),
            case,
        },
    })
}
