//! `slipgap recommend STUDY`: the cheapest candidate of a study that keeps metrics within tolerances, with all others.

use super::task::CommonArgs;
use super::write_front;
use crate::batch::output::Folder;
use crate::commands::NOT_MET;
use crate::commands::arguments::SettingsArgs;
use crate::commands::arguments::sources;
use crate::commands::terminal::{note, print, table};
use crate::error::Error;
use crate::figures::Front;
use crate::problem::numbers::parameter::{Value, real, shortest};
use crate::recommend::Stop;
use crate::recommend::format::digits;
use crate::recommend::study::{Advice, Choice, From, Mesh, State, advise};
use crate::run::Source;
use crate::study::MOST_CASES;
use clap::Args;
use std::path::PathBuf;
use std::time::Instant;

/// What the cost is.
const COST: &str = "cost, in steps × modes or nodes";

#[derive(Args)]
pub struct StudyArgs {
    /// Study file with the key `recommend`; `-` is standard input
    #[arg(required = true)]
    study: Option<PathBuf>,
    #[command(flatten)]
    settings: SettingsArgs,
    #[command(flatten)]
    common: CommonArgs,
}

impl StudyArgs {
    /// Compares the candidates; returns the exit code.
    pub fn execute(self) -> Result<u8, Error> {
        let study: Vec<PathBuf> = self.study.iter().cloned().collect();
        if let Some(folder) = study.iter().find(|path| path.is_dir()) {
            let what = format!("{} is a folder; name one study", folder.display());
            return Err(Error::Usage(what));
        }
        let sources = sources::read(&study, &self.settings.set, MOST_CASES)?;
        let run = |source: &Source| self.common.jobs.run(|| self.run(source));
        sources.first().map_or(Ok(0), run)
    }

    fn run(&self, source: &Source) -> Result<u8, Error> {
        let start = Instant::now();
        let advice = advise(&source.input(), &Stop::default())?;
        let seconds = start.elapsed().as_secs_f64();
        note(&format!("{} cases in {seconds:.1} s", advice.solved));
        let mut folder = Folder::open(&self.common.out.join(folder_name(&source.name)))?;
        let mut printed = rows(&advice, &PRINTED);
        printed.push(tolerances(&advice));
        let mut text = table(&printed) + &sentences(&advice);
        let csv = csv(&rows(&advice, &CSV));
        text += &folder
            .write("candidates.csv", csv.as_bytes())?
            .display()
            .to_string();
        text += "\n";
        let front = front(&advice);
        if !front.points.is_empty() {
            text += &write_front(&mut folder, &front)?;
        }
        print(&text)?;
        if advice.chosen.is_some() {
            return Ok(0);
        }
        note(
            &source.line(
                "no candidate keeps all metrics within their tolerances in all physical cases",
            ),
        );
        Ok(NOT_MET)
    }
}

/// The folder of the candidates of a study: `recommend-slide`, in the folder of its results `bridges/recommend-slide`.
fn folder_name(results: &str) -> String {
    match results.rsplit_once('/') {
        Some((folder, name)) => format!("{folder}/recommend-{name}"),
        None => format!("recommend-{results}"),
    }
}

/// The names of the parameters of candidates, and their values in one of them.
fn parameters(advice: &Advice) -> Vec<(usize, String)> {
    let table = advice.study.problem.parameters();
    let recommend = advice.study.recommend.iter();
    let rows = recommend.flat_map(|own| {
        let free = own.free.iter().map(|free| free.parameter);
        own.over.iter().copied().chain(free)
    });
    rows.map(|row| (row, table[row].name.to_string())).collect()
}

fn value(choice: &Choice, row: usize) -> Option<Value> {
    let own = choice.values.iter().find(|(own, _)| *own == row);
    own.map(|(_, value)| *value)
}

/// The metrics to keep, each with its tolerance.
fn within(advice: &Advice) -> Vec<(&str, f64)> {
    let recommend = advice.study.recommend.iter().flat_map(|own| &own.within);
    let name = |row: usize| advice.study.measures[row].name.as_str();
    recommend
        .map(|(row, tolerance)| (name(*row), *tolerance))
        .collect()
}

/// What becomes of a candidate, in words.
fn verdict(advice: &Advice, at: usize) -> String {
    let choice = &advice.choices[at];
    match &choice.state {
        _ if advice.chosen == Some(at) => "recommended".into(),
        State::Keeps if choice.finer.is_some() => "only with this step or mesh".into(),
        State::Keeps => "keeps all, costs more".into(),
        State::Misses => {
            let metrics = within(advice).into_iter().zip(&choice.errors);
            let missed = metrics.filter(|((_, tolerance), error)| *error > tolerance);
            let missed: Vec<&str> = missed.map(|((name, _), _)| name).collect();
            format!("misses {}", missed.join(", "))
        }
        State::Energy => "gains or loses energy".into(),
        State::Unsolved(why) => format!("not solved: {why}"),
        State::Incomplete => "does not have all physical cases".into(),
    }
}

/// How a table shows numbers and values.
struct Style {
    /// An error; none if it is not known.
    number: fn(f64) -> String,
    value: fn(Value) -> String,
    missing: &'static str,
}

/// The printed table.
const PRINTED: Style = Style {
    number: digits,
    value: shown,
    missing: "-",
};

/// candidates.csv.
const CSV: Style = Style {
    number: real,
    value: Value::cell,
    missing: "",
};

/// A number in the printed table.
fn cell(x: f64) -> String {
    if x.is_finite() { digits(x) } else { "-".into() }
}

/// The table of all candidates, with a line of names.
fn rows(advice: &Advice, style: &Style) -> Vec<Vec<String>> {
    let (parameters, within) = (parameters(advice), within(advice));
    let names = parameters.iter().map(|own| own.1.as_str());
    let names = names.chain(["cost", "energy_gain", "energy_loss"]);
    let names = names.chain(within.iter().map(|own| own.0));
    let header = names.chain(["worst", "verdict"]).map(str::to_owned);
    let number = |x: f64| match x.is_finite() {
        true => (style.number)(x),
        false => style.missing.to_owned(),
    };
    let row = |(at, choice): (usize, &Choice)| -> Vec<String> {
        let value = |row: usize| value(choice, row).map_or(style.missing.into(), style.value);
        let values = parameters.iter().map(|own| value(own.0));
        let error = |i: usize| choice.errors.get(i).copied().unwrap_or(f64::INFINITY);
        let energies = [choice.energy.gain, choice.energy.loss].into_iter();
        let numbers = energies
            .chain((0..within.len()).map(error))
            .chain([choice.worst]);
        let cells = values
            .chain([choice.cost.to_string()])
            .chain(numbers.map(number));
        cells.chain([verdict(advice, at)]).collect()
    };
    let rows = advice.choices.iter().enumerate().map(row);
    [header.collect()].into_iter().chain(rows).collect()
}

/// The tolerances as the last line of the printed table.
fn tolerances(advice: &Advice) -> Vec<String> {
    let limits = [advice.energy.gain, advice.energy.loss].into_iter();
    let limits = limits
        .chain(within(advice).into_iter().map(|own| own.1))
        .chain([1.0]);
    let limit = |x: f64| match x.is_finite() {
        true => format!("<= {}", shortest(x)),
        false => String::new(),
    };
    let mut cells = vec![String::new(); parameters(advice).len()];
    cells.push("tolerance".into());
    cells.extend(limits.map(limit));
    cells.push(String::new());
    cells
}

/// A value with at most ten digits, which a search may give more of.
fn shown(value: Value) -> String {
    match value {
        Value::Number(x) => shortest(format!("{x:.9e}").parse().unwrap_or(x)),
        other => other.to_string(),
    }
}

fn named(advice: &Advice, values: &[(usize, Value)]) -> String {
    let table = advice.study.problem.parameters();
    let one = |(row, value): &(usize, Value)| format!("{} = {}", table[*row].name, shown(*value));
    values.iter().map(one).collect::<Vec<_>>().join(", ")
}

/// What the metrics are compared with, and whether the recommended candidate holds with a finer step and mesh.
fn sentences(advice: &Advice) -> String {
    let mut text = match advice.conditions {
        1 => "There is one physical case.\n".to_owned(),
        count => format!("Each error is the largest one of {count} physical cases.\n"),
    };
    if let Some(reference) = &advice.reference {
        let finest = named(advice, &reference.finest);
        for ((metric, _), from) in within(advice).into_iter().zip(&reference.from) {
            text += &match from {
                From::Zero => format!("{metric} is an error itself.\n"),
                From::Exact => format!("{metric}: relative to the exact motion of {finest}.\n"),
                From::Finest => format!(
                    "{metric}: relative to the finest motion, {finest} with half the step.\n"
                ),
            };
        }
    }
    let nearest = advice
        .choices
        .iter()
        .min_by(|a, b| a.worst.total_cmp(&b.worst));
    let shown = advice.chosen.map(|at| &advice.choices[at]).or(nearest);
    let Some(choice) = shown.filter(|choice| choice.worst.is_finite()) else {
        return text;
    };
    let name = named(advice, &choice.values);
    let Some(finer) = choice.finer else {
        let worst = digits(choice.worst);
        return text
            + &format!("Nearest: {name}. Its largest error is {worst} times its tolerance.\n");
    };
    let mesh = match finer.mesh {
        Mesh::NotChosen => String::new(),
        Mesh::Next(mesh) => format!(", with the next finer mesh {}", cell(mesh)),
        Mesh::Finest => {
            ". No candidate has a finer mesh, which would show the error of this one".into()
        }
    };
    if !finer.holds() {
        text += "Warning: this answer is valid only for its own step and mesh. ";
    }
    let step = cell(finer.step);
    text + &format!(
        "Recommended: {name}. With half its step the largest error is {step} of its tolerance{mesh}.\n"
    )
}

/// A table as CSV.
fn csv(rows: &[Vec<String>]) -> String {
    let quoted = |text: &String| match text.contains([',', '"', '\n']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.clone(),
    };
    let line = |row: &Vec<String>| row.iter().map(quoted).collect::<Vec<_>>().join(",") + "\n";
    rows.iter().map(line).collect()
}

/// The candidates whose error is smaller than that of all cheaper ones.
fn front(advice: &Advice) -> Front {
    let mut front = Front {
        title: "Cost and error of the candidates".into(),
        cost: COST.into(),
        points: Vec::new(),
        chosen: None,
    };
    let mut least = f64::INFINITY;
    for (at, choice) in advice.choices.iter().enumerate() {
        let chosen = advice.chosen == Some(at);
        // Both scales are logarithmic.
        if choice.worst > 0.0 && (choice.worst < least || chosen && choice.worst.is_finite()) {
            least = least.min(choice.worst);
            front.chosen = chosen.then_some(front.points.len()).or(front.chosen);
            front.points.push([choice.cost as f64, choice.worst]);
        }
    }
    front
}
