//! Runs a study: every case through its problem, in parallel, in an order that no result depends on.

pub mod chunk;
pub mod output;
pub mod results;
pub mod sobol;
pub mod store;
pub mod whole;

use crate::error::Error;
use crate::problem::{Case, Solution};
use crate::study::Study;
use chunk::{Cut, Done};
use indicatif::ProgressBar;
use rayon::prelude::*;
use store::Store;

/// What became of one case.
#[derive(Debug, Clone)]
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

/// What is done with cases while they are run.
pub struct Wishes<'a> {
    /// Where finished chunks are kept and looked for, if anywhere.
    pub store: Option<&'a Store>,
    /// Whether every case is computed, whatever the store has.
    pub anew: bool,
    /// Which cases keep their histories, where they are computed.
    pub keep: &'a (dyn Fn(&Case) -> bool + Sync),
    /// Is shown every solution that is computed.
    pub visit: &'a (dyn Fn(u64, &Solution) -> Result<(), Error> + Sync),
}

impl Wishes<'_> {
    /// Metrics, and nothing kept.
    pub const METRICS: Wishes<'static> = Wishes {
        store: None,
        anew: false,
        keep: &|_| false,
        visit: &|_, _| Ok(()),
    };
}

/// Runs every case, chunk by chunk; hands the chunks to `take` in order, as soon as they and those before them are done.
/// `take` may end the run by an error.
///
/// # Errors
/// The first of `visit`, of the store or of `take`.
pub fn run(
    study: &Study,
    bar: &ProgressBar,
    wishes: &Wishes,
    mut take: impl FnMut(Done) -> Result<(), Error>,
) -> Result<(), Error> {
    let cut = Cut::new(study);
    // As many chunks at a time as keep all threads busy; memory does not grow with the number of cases.
    let window = 2 * rayon::current_num_threads() as u64;
    for start in (0..cut.count()).step_by(window as usize) {
        let end = (start + window).min(cut.count());
        let chunks: Vec<Result<Done, Error>> = (start..end)
            .into_par_iter()
            .map(|chunk| one(study, chunk, cut.cases(study, chunk), bar, wishes))
            .collect();
        for done in chunks {
            take(done?)?;
        }
    }
    Ok(())
}

/// The outcomes of all cases at once, for studies that are known to be small.
pub fn all(study: &Study, bar: &ProgressBar) -> Result<Vec<Outcome>, Error> {
    let mut outcomes = Vec::new();
    run(study, bar, &Wishes::METRICS, |done| {
        outcomes.extend(done.outcomes);
        Ok(())
    })?;
    Ok(outcomes)
}

/// A chunk from the store, or computed and kept.
fn one(
    study: &Study,
    chunk: u64,
    cases: Vec<(u64, Case)>,
    bar: &ProgressBar,
    wishes: &Wishes,
) -> Result<Done, Error> {
    let Some(&(first, _)) = cases.first() else {
        // A condition dropped them all.
        return Ok(Done::kept(0, Vec::new()));
    };
    let found = match wishes.store {
        Some(store) if !wishes.anew => store.find(study, chunk, &cases),
        _ => Err(None),
    };
    let why = match found {
        Ok(outcomes) => {
            bar.inc(outcomes.len() as u64);
            return Ok(Done::kept(first, outcomes));
        }
        Err(why) => why,
    };
    let outcomes: Vec<Result<Outcome, Error>> = cases
        .into_par_iter()
        .map(|(number, case)| {
            let outcome = solve(study, number, case, wishes);
            bar.inc(1);
            outcome
        })
        .collect();
    let outcomes = outcomes.into_iter().collect::<Result<Vec<_>, _>>()?;
    if let Some(store) = wishes.store {
        store.put(study, chunk, first, &outcomes)?;
    }
    Ok(Done {
        outcomes,
        first,
        kept: Err(why),
    })
}

fn solve(study: &Study, number: u64, case: Case, wishes: &Wishes) -> Result<Outcome, Error> {
    Ok(match solution(study, &case) {
        Ok(solution) => {
            (wishes.visit)(number, &solution)?;
            Outcome {
                metrics: solution.metrics.clone(),
                solution: (wishes.keep)(&case).then_some(solution),
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

/// The solution of one case by the study's way of solving.
pub fn solution(study: &Study, case: &Case) -> Result<Solution, String> {
    match study.once {
        true => study.problem.solve_once(case, &study.metrics),
        false => study.problem.solve(case, &study.metrics),
    }
}
