//! `slipgap run`: results, figures and, if asked for, histories of every study.

use super::sources::Source;
use super::{UNSOLVED, finish, note, progress, say};
use slipgap::batch::output::{Folder, RESULTS};
use slipgap::batch::{self, Outcome, results};
use slipgap::error::Error;
use slipgap::figures::{self, Shown};
use slipgap::problem::{Case, Snapshot};
use slipgap::study::{Figure, Study};
use std::path::Path;

/// Runs the studies into `out`; gives the exit code.
pub fn run(sources: &[Source], out: &Path, histories: bool) -> Result<u8, Error> {
    // Folders first: what cannot be written is said before anything is computed.
    let folders = sources
        .iter()
        .map(|source| Folder::open(&out.join(&source.name)))
        .collect::<Result<Vec<_>, _>>()?;
    let mut code = 0;
    for (source, folder) in sources.iter().zip(folders) {
        let outcomes = one(source, folder, histories)?;
        if unsolved(source, &outcomes) {
            code = UNSOLVED;
        }
    }
    Ok(code)
}

fn one(source: &Source, mut folder: Folder, histories: bool) -> Result<Vec<Outcome>, Error> {
    let study = &source.study;
    let file_name = |case: u64| format!("histories/{case}.csv");
    let bar = progress(&source.name, study.len());
    let outcomes = batch::run(
        study,
        &bar,
        |case| needs_history(study, case),
        |case, solution| {
            if histories {
                let name = file_name(case);
                folder.put(&name, |out| results::history(study.problem, solution, out))?;
            }
            Ok(())
        },
    )?;
    finish(&bar, &source.name, study.len());
    if histories {
        let solved = (0..).zip(&outcomes).filter(|(_, o)| o.failure.is_none());
        folder.note(solved.map(|(case, _)| file_name(case)));
    }
    let mut lines = vec![folder.write(RESULTS, &results::table(study, &outcomes)?)?];
    for figure in &study.figures {
        let chosen = outcomes.iter().filter(|o| figure.filter.matches(&o.case));
        let chosen: Vec<&Outcome> = chosen.collect();
        let snapshots: Vec<_> = chosen.iter().map(|o| snapshots(study, figure, o)).collect();
        let shown: Vec<Shown> = chosen
            .iter()
            .zip(&snapshots)
            .map(|(outcome, snapshots)| Shown {
                case: &outcome.case,
                metrics: &outcome.metrics,
                solution: outcome.solution.as_ref(),
                snapshots,
            })
            .collect();
        let sheet = figures::sheet(study, figure, &shown);
        let name = &figure.name;
        lines.push(folder.write(&format!("{name}.png"), &figures::png(&sheet)?)?);
        lines.push(folder.write(&format!("{name}.svg"), figures::svg(&sheet)?.as_bytes())?);
    }
    folder.close(study, &source.file)?;
    let text: String = lines
        .iter()
        .map(|path| format!("{}\n", path.display()))
        .collect();
    say(&text)?;
    Ok(outcomes)
}

/// What a figure draws along the structure; nothing of a case that could not be solved.
fn snapshots(study: &Study, figure: &Figure, outcome: &Outcome) -> Vec<Snapshot> {
    let (problem, case) = (study.problem, &outcome.case);
    let duration = case.number("duration").unwrap_or(0.0);
    let times = figure.kind.snapshot_times(duration, problem.steps(case));
    if times.is_empty() || outcome.failure.is_some() {
        return Vec::new();
    }
    problem.snapshots(case, &times)
}

fn needs_history(study: &Study, case: &Case) -> bool {
    let wanted = |figure: &Figure| figure.kind.draws_histories() && figure.filter.matches(case);
    study.figures.iter().any(wanted)
}

/// Names the cases that could not be solved; whether there are any.
pub fn unsolved(source: &Source, outcomes: &[Outcome]) -> bool {
    let mut any = false;
    for (case, outcome) in (0..).zip(outcomes) {
        if let Some(why) = &outcome.failure {
            any = true;
            let case: u64 = case;
            note(&format!(
                "{}: case {case} could not be solved: {why}",
                source.file.display()
            ));
        }
    }
    any
}
