//! The figures of a study from the cases that they show.

use slipgap::batch::output::Folder;
use slipgap::batch::{self, Outcome};
use slipgap::error::Error;
use slipgap::figures::{self, DrawnCase};
use slipgap::problem::{Case, Snapshot};
use slipgap::study::{Figure, Study};
use std::path::PathBuf;

/// Whether a figure shows the case.
pub fn anywhere(study: &Study, case: &Case) -> bool {
    study
        .figures
        .iter()
        .any(|figure| figure.filter.matches(case))
}

/// Whether a figure shows what the case does over time.
pub fn over_time(study: &Study, case: &Case) -> bool {
    let wanted = |figure: &Figure| figure.kind.draws_histories() && figure.filter.matches(case);
    study.figures.iter().any(wanted)
}

/// Solves cases from the store again where their histories are drawn.
pub fn solve(study: &Study, shown: &mut [Outcome]) {
    for outcome in shown.iter_mut() {
        let again = outcome.solution.is_none() && outcome.failure.is_none();
        if again && over_time(study, &outcome.case) {
            outcome.solution = batch::solution(study, &outcome.case).ok().map(Box::new);
        }
    }
}

/// Draws every figure of a study, its pixels `dpi` an inch.
pub fn figures(
    study: &Study,
    shown: &mut [Outcome],
    dpi: u32,
    folder: &mut Folder,
    lines: &mut Vec<PathBuf>,
) -> Result<(), Error> {
    solve(study, shown);
    for figure in &study.figures {
        let sheet = with_shown(study, figure, shown, |cases| {
            Ok(figures::sheet(study, figure, cases))
        })?;
        let name = &figure.name;
        lines.push(folder.write(&format!("{name}.png"), &figures::png(&sheet, dpi)?)?);
        let svg = figures::svg(&sheet, dpi)?;
        lines.push(folder.write(&format!("{name}.svg"), svg.as_bytes())?);
        lines.push(folder.write(&format!("{name}.pdf"), &figures::pdf(&sheet, dpi)?)?);
    }
    Ok(())
}

/// Hands those of the cases that a figure chooses to `draw`, with what it shows of them.
pub fn with_shown<T>(
    study: &Study,
    figure: &Figure,
    outcomes: &[Outcome],
    draw: impl FnOnce(&[DrawnCase]) -> Result<T, Error>,
) -> Result<T, Error> {
    let chosen = outcomes.iter().filter(|o| figure.filter.matches(&o.case));
    let chosen: Vec<&Outcome> = chosen.collect();
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

/// What a figure draws along the structure; nothing of a case that could not be solved.
fn snapshots(study: &Study, figure: &Figure, outcome: &Outcome) -> Vec<Snapshot> {
    let (problem, case) = (&study.problem, &outcome.case);
    let times = figure.kind.snapshot_times(&**problem, case);
    if times.is_empty() || outcome.failure.is_some() {
        return Vec::new();
    }
    problem.snapshots(case, &times)
}
