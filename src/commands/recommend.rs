//! `slipgap recommend`: the cheapest parameters that reach a target, the run that proves it, and what else there is.

use super::advice::{self, Row};
use super::asked::Meant;
use super::{NOT_MET, note, say};
use slipgap::batch::output::Folder;
use slipgap::error::Error;
use slipgap::figures::style::DPI;
use slipgap::figures::{self, Front};
use slipgap::problem::parameter::shortest;
use slipgap::recommend::{Answer, Request, Space, search};
use std::time::Instant;

/// Searches, writes the front into a folder of its own, and prints the answer; gives the exit code.
pub fn recommend(meant: &Meant) -> Result<u8, Error> {
    let (space, request) = (&*meant.space, &meant.request);
    let mut folder = Folder::open(&meant.common.out.join(&meant.folder))?;
    for line in space.notes() {
        note(&line);
    }
    let start = Instant::now();
    let answer = search(space, request);
    let seconds = start.elapsed().as_secs_f64();
    note(&format!("{} cases in {seconds:.1} s", answer.solved));
    let Some(nearest) = answer.front.len().checked_sub(1) else {
        note(
            "slipgap: no case can be recommended: every case searched, or one of its neighbours, gains too much energy or has an undefined target metric",
        );
        return Ok(NOT_MET);
    };
    let chosen = answer.chosen();
    let rows = rows(&answer, chosen.unwrap_or(nearest));
    let mut text = advice::tables(space, request, &rows)?;
    text += &format!(
        "in a study: {}\n",
        advice::pasted(space, &rows[0].tried.cases[0])
    );
    let title = format!("Cost and error of {}", space.problem().name());
    let front = Front {
        title,
        cost: space.cost_title().into(),
        points: answer
            .front
            .iter()
            .map(|t| [t.cost as f64, t.worst])
            .collect(),
        chosen,
    };
    let sheet = front.sheet();
    for path in [
        folder.write("front.csv", table(space, request, &answer).as_bytes())?,
        folder.write("front.png", &figures::png(&sheet, DPI)?)?,
        folder.write("front.svg", figures::svg(&sheet, DPI)?.as_bytes())?,
        folder.write("front.pdf", &figures::pdf(&sheet, DPI)?)?,
    ] {
        text += &format!("{}\n", path.display());
    }
    say(&text)?;
    if chosen.is_none() {
        note("slipgap: no case searched reaches the target; the nearest case is shown");
        return Ok(NOT_MET);
    }
    Ok(0)
}

/// The answer, a cheaper one, and at most two dearer ones.
fn rows(answer: &Answer, at: usize) -> Vec<Row<'_>> {
    let row = |at: usize, name| Row {
        name,
        tried: &answer.front[at],
    };
    let reached = answer.front[at].worst <= 1.0;
    let [own, cheaper] = match reached {
        true => ["recommended", "cheaper, misses the target"],
        false => [
            "nearest, misses the target",
            "cheaper, misses the target by more",
        ],
    };
    let mut rows = vec![row(at, own)];
    rows.extend(answer.cheaper(at).map(|at| row(at, cheaper)));
    let first = answer.better(at);
    let second = first.and_then(|first| answer.better(first));
    let dearer = [first, second].into_iter().flatten();
    rows.extend(dearer.map(|at| row(at, "costs more, smaller error")));
    rows
}

/// The whole front as a table.
fn table(space: &dyn Space, request: &Request, answer: &Answer) -> String {
    let names = request
        .targets
        .iter()
        .map(|target| target.name.replace(' ', "_"));
    let mut header: Vec<String> = space.shown().into_iter().map(str::to_owned).collect();
    header.push("cost".into());
    header.extend(names);
    header.push("worst".into());
    let mut text = header.join(",") + "\n";
    for tried in &answer.front {
        let value = |name: &&str| {
            tried.cases[0]
                .get(name)
                .map_or(String::new(), |v| v.to_string())
        };
        let mut cells: Vec<String> = space.shown().iter().map(value).collect();
        cells.push(tried.cost.to_string());
        cells.extend(
            tried
                .misses
                .iter()
                .chain([&tried.worst])
                .map(|x| shortest(*x)),
        );
        text += &(cells.join(",") + "\n");
    }
    text
}
