//! `slipgap recommend`: the cheapest parameters that reach a target, the run that proves it, and what else there is.

use super::{NOT_MET, columns, note, say};
use slipgap::batch::output::Folder;
use slipgap::error::Error;
use slipgap::figures::{self, Front};
use slipgap::problem::parameter::{Value, shortest};
use slipgap::recommend::{Answer, Space, Target, Tried, search};
use std::f64::consts::PI;
use std::path::Path;

/// Dearer alternatives that are told.
const BETTER: usize = 2;

/// Searches, writes the front into a folder of `out`, and prints the answer; gives the exit code.
pub fn recommend(space: &dyn Space, targets: &[Target], out: &Path) -> Result<u8, Error> {
    let problem = space.problem();
    let mut folder = Folder::open(&out.join(format!("recommend-{}", problem.name())))?;
    for line in space.said() {
        note(&line);
    }
    let answer = search(space, targets);
    let Some(nearest) = answer.front.len().checked_sub(1) else {
        return Err(Error::Internal(
            "no case of the search has a solution".into(),
        ));
    };
    let at = answer.chosen.unwrap_or(nearest);
    let mut rows = vec![header(space, targets)];
    let name = match answer.chosen {
        Some(_) => "recommended",
        None => "nearest",
    };
    rows.push(row(name, space, targets, &answer.front[at])?);
    if at > 0 {
        rows.push(row(
            "cheaper, worse",
            space,
            targets,
            &answer.front[at - 1],
        )?);
    }
    for better in answer.front.iter().skip(at + 1).take(BETTER) {
        rows.push(row("dearer, better", space, targets, better)?);
    }
    let limits = targets.iter().map(|t| format!("<= {}", shortest(t.limit)));
    let mut last = vec!["target".to_owned()];
    last.extend(space.free().iter().map(|_| String::new()));
    last.push(String::new());
    last.extend(limits);
    last.push("<= 1".into());
    rows.push(last);
    let title = format!("Cost and error of {}", problem.name());
    let front = Front {
        title,
        cost: space.cost_title().into(),
        points: answer.front.iter().map(|t| [t.cost, t.worst]).collect(),
        chosen: answer.chosen,
    };
    let sheet = front.sheet();
    let mut paths = vec![folder.write("front.csv", table(space, &answer).as_bytes())?];
    paths.push(folder.write("front.png", &figures::png(&sheet)?)?);
    paths.push(folder.write("front.svg", figures::svg(&sheet)?.as_bytes())?);
    let mut text = columns(&rows);
    text += &format!("in a study: {}\n", pasted(&answer.front[at]));
    for path in paths {
        text += &format!("{}\n", path.display());
    }
    say(&text)?;
    if answer.chosen.is_none() {
        note("slipgap: nothing searched reaches the target; the nearest is told");
        return Ok(NOT_MET);
    }
    Ok(0)
}

fn header(space: &dyn Space, targets: &[Target]) -> Vec<String> {
    let mut header = vec![String::new()];
    header.extend(space.free().iter().map(|name| (*name).to_owned()));
    header.push(space.cost_title().to_owned());
    header.extend(targets.iter().map(|target| target.name.to_owned()));
    header.push("worst of neighbours/target".into());
    header
}

/// One case with the metrics of a run of its own.
fn row(
    name: &str,
    space: &dyn Space,
    targets: &[Target],
    tried: &Tried,
) -> Result<Vec<String>, Error> {
    let solution = space
        .problem()
        .solve(&tried.case, &[])
        .map_err(Error::Internal)?;
    let mut row = vec![name.to_owned()];
    row.extend(space.free().iter().map(|name| written(tried, name)));
    row.push(tried.cost.to_string());
    for target in targets {
        let miss = target.miss(&solution.metrics);
        row.push(miss.map_or("undefined".into(), digits));
    }
    row.push(digits(tried.worst));
    Ok(row)
}

/// Four digits.
fn digits(x: f64) -> String {
    let rounded: f64 = format!("{x:.3e}").parse().unwrap_or(x);
    shortest(rounded)
}

/// The value of a parameter as a study would have it, as an expression where that is rounder.
fn written(tried: &Tried, name: &str) -> String {
    let whole = |x: f64| (x - x.round()).abs() < 1e-9 && x.round() > 0.0;
    match tried.case.get(name) {
        Some(Value::Number(x)) if name == "dT" && whole(PI / x) => {
            format!("pi/{}", (PI / x).round())
        }
        Some(Value::Number(x)) if name == "dt" && whole(1.0 / x) => {
            format!("1/{}", (1.0 / x).round())
        }
        Some(Value::Number(x)) if name == "duration" && whole(x / PI) => {
            format!("{}*pi", (x / PI).round())
        }
        Some(Value::Number(x)) => shortest(x),
        Some(value) => value.to_string(),
        None => String::new(),
    }
}

/// The parameters to paste into a study.
fn pasted(tried: &Tried) -> String {
    let quoted = |name: &str| {
        let value = written(tried, name);
        match tried.case.get(name) {
            Some(Value::Name(_)) => format!("\"{value}\""),
            _ if value.contains(['/', '*']) => format!("\"{value}\""),
            _ => value,
        }
    };
    let given = [
        "law", "alpha", "beta", "gamma", "n", "dT", "dt", "duration", "x0",
    ];
    let given = given
        .into_iter()
        .filter(|name| tried.case.get(name).is_some());
    let parts: Vec<String> = given
        .map(|name| format!("\"{name}\": {}", quoted(name)))
        .collect();
    format!("\"parameters\": {{ {} }}", parts.join(", "))
}

/// The whole front as a table.
fn table(space: &dyn Space, answer: &Answer) -> String {
    let mut text = space.free().join(",");
    text += ",cost,worst\n";
    for tried in &answer.front {
        let values = space.free().iter().map(|name| match tried.case.get(name) {
            Some(value) => value.to_string(),
            None => String::new(),
        });
        let values: Vec<String> = values.collect();
        text += &format!(
            "{},{},{}\n",
            values.join(","),
            shortest(tried.cost),
            shortest(tried.worst)
        );
    }
    text
}
