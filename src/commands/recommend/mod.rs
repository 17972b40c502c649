//! `slipgap recommend`: the cheapest parameters that reach a target, with the alternatives.

mod args;
mod friction;
mod impact;
mod json;
mod study;
mod survey;
mod tables;
mod task;

pub use args::RecommendArgs;

use super::NOT_MET;
use super::terminal::{note, print};
use crate::batch::output::Folder;
use crate::error::Error;
use crate::figures::style::DPI;
use crate::figures::{self, Front};
use crate::recommend::{self, Answer, LEAST_HALVINGS, MOST_HALVINGS, SETTLED};
use std::time::Instant;
use tables::Row;
use task::SearchTask;

/// Searches, writes the table and the picture of the candidates into their folder, and prints the answer; returns the exit
/// code.
fn recommend(task: &SearchTask) -> Result<u8, Error> {
    let (variants, request) = (&*task.search.space, &task.search.request);
    let space = variants.space();
    let mut folder = Folder::open(&task.common.out.join(&task.search.folder))?;
    for line in space.notes() {
        note(&line);
    }
    let mut limits = format!(
        "an answer also reaches the target with 1/2, 1/4, 1/8 .. of its step, if one does: at least to 1/{}, at most to 1/{}, until no \
         metric with a target changes by more than {} % of its target; no case gains more energy than {}",
        1 << LEAST_HALVINGS,
        1 << MOST_HALVINGS,
        100.0 * SETTLED,
        request.energy_gain
    );
    if request.energy_loss.is_finite() {
        limits += &format!(" or loses more than {}", request.energy_loss);
    }
    note(&limits);
    let start = Instant::now();
    let recommended = recommend::recommend(variants, request);
    let seconds = start.elapsed().as_secs_f64();
    let answer = &recommended.answer;
    for line in survey::notes(variants, &recommended) {
        note(&line);
    }
    let solved = answer.solved
        + recommended
            .survey
            .as_ref()
            .map_or(0, |survey| survey.solved);
    note(&format!("{solved} cases in {seconds:.1} s"));
    let Some(nearest) = answer.front.len().checked_sub(1) else {
        note(
            "slipgap: no case can be recommended: every case searched, or one of its neighbours, gains or loses too much energy or has an undefined target metric",
        );
        return Ok(NOT_MET);
    };
    let chosen = answer.chosen();
    let rows = rows(answer, chosen.unwrap_or(nearest));
    let mut text = tables::answer(space, request, &rows)?;
    let robustness = recommend::robustness(space, request, rows[0].candidate);
    text += &robustness.map_or(String::new(), |found| tables::robustness(request, &found));
    text += &format!(
        "in a study: {}\n",
        tables::study_parameters(space, &rows[0].candidate.cases[0])
    );
    if let Some(survey) = &recommended.survey {
        text += &survey::tables(variants, survey);
    }
    let title = format!("Cost and error of {}", space.problem().name());
    let front = Front {
        title,
        cost: space.cost_title().into(),
        points: answer
            .front
            .iter()
            .map(|c| [c.cost as f64, c.worst])
            .collect(),
        chosen,
    };
    let csv = tables::front(space, request, answer);
    let path = folder.write("front.csv", csv.as_bytes())?;
    text += &format!("{}\n", path.display());
    text += &write_front(&mut folder, &front)?;
    print(&text)?;
    if chosen.is_none() {
        note("slipgap: no case searched reaches the target; the nearest case is shown");
        return Ok(NOT_MET);
    }
    Ok(0)
}

/// Writes the picture of a front; returns the paths, one in each line.
fn write_front(folder: &mut Folder, front: &Front) -> Result<String, Error> {
    let sheet = front.sheet();
    let paths = [
        folder.write("front.png", &figures::png(&sheet, DPI)?)?,
        folder.write("front.svg", figures::svg(&sheet, DPI)?.as_bytes())?,
        folder.write("front.pdf", &figures::pdf(&sheet, DPI)?)?,
    ];
    let paths = paths.iter().map(|path| format!("{}\n", path.display()));
    Ok(paths.collect())
}

/// The answer, cheaper candidates, and at most two that cost more.
fn rows(answer: &Answer, at: usize) -> Vec<Row<'_>> {
    let row = |at: usize, name| Row {
        name,
        candidate: &answer.front[at],
    };
    let reached = answer.front[at].worst <= 1.0;
    let [chosen, cheaper] = match reached {
        true => ["recommended", "cheaper, misses the target"],
        false => [
            "nearest, misses the target",
            "cheaper, misses the target by more",
        ],
    };
    let mut rows = vec![row(at, chosen)];
    rows.extend(answer.own_step.as_ref().map(|candidate| Row {
        name: "cheaper, only with this step",
        candidate,
    }));
    rows.extend(answer.cheaper(at).map(|at| row(at, cheaper)));
    let first = answer.better(at);
    let second = first.and_then(|first| answer.better(first));
    let better = [first, second].into_iter().flatten();
    rows.extend(better.map(|at| row(at, "costs more, smaller error")));
    rows
}
