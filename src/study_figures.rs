//! The cases of a study that its figures show.

use crate::batch::{self, Outcome};
use crate::figures::DrawnCase;
use crate::problem::{Case, Snapshot};
use crate::study::{Figure, Study};

/// Whether a figure shows the case.
pub fn show(study: &Study, case: &Case) -> bool {
    let shows = |figure: &Figure| figure.filter.matches(case);
    study.figures.iter().any(shows)
}

/// Whether a figure shows the history of the case.
pub fn show_history(study: &Study, case: &Case) -> bool {
    let shows = |figure: &Figure| figure.kind.draws_histories() && figure.filter.matches(case);
    study.figures.iter().any(shows)
}

/// Solves cases from the store again if a figure shows their histories.
pub fn add_histories(study: &Study, outcomes: &mut [Outcome]) {
    for outcome in outcomes.iter_mut() {
        let missing = outcome.solution.is_none() && outcome.failure.is_none();
        if missing && show_history(study, &outcome.case) {
            outcome.solution = batch::solution(study, &outcome.case).ok().map(Box::new);
        }
    }
}

/// The result of `draw` for the cases that a figure shows; for one case of each group, if it shows reductions.
pub fn with_cases<T>(
    study: &Study,
    figure: &Figure,
    outcomes: &[Outcome],
    draw: impl FnOnce(&[DrawnCase]) -> T,
) -> T {
    let chosen = outcomes.iter().filter(|o| figure.filter.matches(&o.case));
    let mut chosen: Vec<&Outcome> = chosen.collect();
    let shown = figure.kind.measures(&*study.problem);
    let reduced = batch::reduced(study, &shown, &chosen);
    if let Some(reduced) = &reduced {
        chosen = reduced.iter().collect();
    }
    let snapshots: Vec<_> = chosen.iter().map(|o| snapshots(study, figure, o)).collect();
    let shown: Vec<DrawnCase> = chosen
        .iter()
        .zip(&snapshots)
        .map(|(outcome, snapshots)| DrawnCase {
            case: &outcome.case,
            metrics: &outcome.metrics,
            solution: outcome.solution.as_deref(),
            snapshots,
        })
        .collect();
    draw(&shown)
}

/// The profiles that a figure shows of a case; none of a case that could not be solved.
fn snapshots(study: &Study, figure: &Figure, outcome: &Outcome) -> Vec<Snapshot> {
    let (problem, case) = (&study.problem, &outcome.case);
    let times = figure.kind.snapshot_times(&**problem, case);
    if times.is_empty() || outcome.failure.is_some() {
        return Vec::new();
    }
    problem.snapshots(case, &times)
}
