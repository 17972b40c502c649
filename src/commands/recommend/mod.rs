//! `slipgap recommend STUDY`: the cheapest candidate of a study that keeps metrics within tolerances, with all others.

mod json;

use super::NOT_MET;
use super::arguments::sources;
use super::arguments::{JobsArgs, ProgramsArgs, SettingsArgs, results_folder};
use super::terminal::{note, print, table};
use crate::batch::output::Folder;
use crate::error::Error;
use crate::figures::style::DPI;
use crate::figures::{self, Front};
use crate::problem::numbers::parameter::{Value, real, shortest};
use crate::recommend::format::digits;
use crate::recommend::study::{Advice, Choice, advise, shown};
use crate::recommend::{Stop, shipped};
use crate::run::Source;
use crate::study::{Input, MOST_CASES};
use clap::Args;
use std::path::PathBuf;
use std::time::Instant;

/// What the cost is.
const COST: &str = "cost, in steps × modes or nodes";

/// The arguments of `slipgap recommend`.
#[derive(Args)]
pub struct RecommendArgs {
    /// Study file with the key `recommend`; `-` is standard input; friction-oscillator and bar-impact are studies of the program, which
    /// are written to the folder of the answer, to be changed
    study: PathBuf,
    #[command(flatten)]
    settings: SettingsArgs,
    /// Print the answer as one object of JSON
    #[arg(long)]
    json: bool,
    /// Folder for the table and picture of cost and error; each study has its own folder in it
    #[arg(long, value_name = "DIR", default_value = "figures", value_parser = results_folder())]
    out: PathBuf,
    #[command(flatten)]
    jobs: JobsArgs,
    #[command(flatten)]
    programs: ProgramsArgs,
}

impl RecommendArgs {
    /// Compares the candidates; returns the exit code.
    pub fn execute(self) -> Result<u8, Error> {
        if let Some(text) = self.study.to_str().and_then(shipped) {
            let name = self.study.display().to_string();
            let file = PathBuf::from(format!("{name}.json"));
            let input = Input::new(&file.display().to_string(), text).with(&self.settings.set);
            let source = Source::of_input(file, name, input, MOST_CASES)?;
            return self.jobs.run(|| self.run(&source, Some(text)));
        }
        if self.study.is_dir() {
            let what = format!("{} is a folder; name one study", self.study.display());
            return Err(Error::Usage(what));
        }
        let study = std::slice::from_ref(&self.study);
        let read = sources::read(study, &self.settings.set, MOST_CASES)?;
        let sources = self.programs.allow(read)?;
        let run = |source: &Source| self.jobs.run(|| self.run(source, None));
        sources.first().map_or(Ok(0), run)
    }

    fn run(&self, source: &Source, shipped: Option<&str>) -> Result<u8, Error> {
        let start = Instant::now();
        let advice = advise(&source.input(), &Stop::default())?;
        let seconds = start.elapsed().as_secs_f64();
        note(&format!("{} cases in {seconds:.1} s", advice.solved));
        let mut folder = Folder::open(&self.out.join(folder_name(&source.name)))?;
        let mut printed = rows(&advice, &PRINTED);
        printed.push(tolerances(&advice));
        let mut text = table(&printed);
        for line in advice.sentences() {
            text += &format!("{line}\n");
        }
        let csv = csv(&rows(&advice, &CSV));
        text += &folder
            .write("candidates.csv", csv.as_bytes())?
            .display()
            .to_string();
        text += "\n";
        if let Some(study) = shipped {
            let path = folder.write("study.json", study.as_bytes())?;
            text += &format!("{}\n", path.display());
        }
        let front = front(&advice);
        if !front.points.is_empty() {
            text += &write_front(&mut folder, &front)?;
        }
        print(&match self.json {
            true => format!("{}\n", json::answer(&advice)),
            false => text,
        })?;
        if advice.chosen.is_some() {
            return Ok(0);
        }
        let lists = advice.not_converged.iter();
        let names: Vec<&str> = lists.map(|list| advice.name(list.parameter)).collect();
        let why = match names[..] {
            [] => "no candidate keeps all metrics within their tolerances in all physical cases"
                .to_owned(),
            _ => format!(
                "not converged in {}: no candidate is recommended",
                names.join(", ")
            ),
        };
        note(&source.line(&why));
        Ok(NOT_MET)
    }
}

/// Writes the picture of a front; returns the paths, one in each line.
fn write_front(folder: &mut Folder, front: &Front) -> Result<String, Error> {
    let sheet = front.sheet();
    let files = [
        folder.write("front.png", &figures::png(&sheet, DPI)?)?,
        folder.write("front.svg", figures::svg(&sheet, DPI)?.as_bytes())?,
        folder.write("front.pdf", &figures::pdf(&sheet, DPI)?)?,
    ];
    let paths = files.iter().map(|path| format!("{}\n", path.display()));
    Ok(paths.collect())
}

/// The folder of the candidates of a study: `recommend-slide`, in the folder of its results `bridges/recommend-slide`.
fn folder_name(results: &str) -> String {
    match results.rsplit_once('/') {
        Some((folder, name)) => format!("{folder}/recommend-{name}"),
        None => format!("recommend-{results}"),
    }
}

/// How a table shows numbers and values.
struct Style {
    /// An error; none if it is not known.
    number: fn(f64) -> String,
    value: fn(Value) -> String,
    missing: &'static str,
    /// Whether it has the column of warnings if there are none.
    always_warnings: bool,
}

/// The printed table.
const PRINTED: Style = Style {
    number: digits,
    value: shown,
    missing: "-",
    always_warnings: false,
};

/// candidates.csv.
const CSV: Style = Style {
    number: real,
    value: Value::cell,
    missing: "",
    always_warnings: true,
};

fn has_warnings(advice: &Advice) -> bool {
    advice
        .choices
        .iter()
        .any(|choice| !choice.warnings.is_empty())
}

/// The table of all candidates, with a line of names.
fn rows(advice: &Advice, style: &Style) -> Vec<Vec<String>> {
    let (parameters, within) = (advice.parameters(), advice.within());
    let of_parameters = parameters.iter().map(|parameter| parameter.1);
    let with_costs = of_parameters.chain(["cost", "energy_gain", "energy_loss"]);
    let names = with_costs.chain(within.iter().map(|metric| metric.0));
    let has_warnings = has_warnings(advice);
    let warnings = (style.always_warnings || has_warnings).then_some("warnings");
    let columns = names.chain(["worst"]).chain(warnings).chain(["verdict"]);
    let header = columns.map(str::to_owned);
    let number = |x: f64| match x.is_finite() {
        true => (style.number)(x),
        false => style.missing.to_owned(),
    };
    let row = |(at, choice): (usize, &Choice)| -> Vec<String> {
        let value = |row: usize| {
            let chosen = choice.value(row);
            chosen.map_or(style.missing.into(), style.value)
        };
        let values = parameters.iter().map(|parameter| value(parameter.0));
        let error = |i: usize| choice.errors.get(i).copied().unwrap_or(f64::INFINITY);
        let energies = [choice.energy.gain, choice.energy.loss].into_iter();
        let numbers = energies
            .chain((0..within.len()).map(error))
            .chain([choice.worst]);
        let cells = values
            .chain([choice.cost.to_string()])
            .chain(numbers.map(number));
        let warnings = warnings.map(|_| choice.warnings.names());
        let cells = cells.chain(warnings);
        cells.chain([advice.verdict(at)]).collect()
    };
    let rows = advice.choices.iter().enumerate().map(row);
    [header.collect()].into_iter().chain(rows).collect()
}

/// The tolerances as the last line of the printed table.
fn tolerances(advice: &Advice) -> Vec<String> {
    let of_energy = [advice.energy.gain, advice.energy.loss].into_iter();
    let limits = of_energy
        .chain(advice.within().into_iter().map(|metric| metric.1))
        .chain([1.0]);
    let limit = |x: f64| match x.is_finite() {
        true => format!("<= {}", shortest(x)),
        false => String::new(),
    };
    let mut cells = vec![String::new(); advice.parameters().len()];
    cells.push("tolerance".into());
    cells.extend(limits.map(limit));
    cells.extend(has_warnings(advice).then(String::new));
    cells.push(String::new());
    cells
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
