//! `slipgap explain`: one case of a study, its metrics and its cost.

use super::UNSOLVED;
use super::arguments::sources::{self, Source};
use super::arguments::{SettingsArgs, whole};
use super::list::cases;
use super::request::{case_of, programs, request};
use super::terminal::{duration, print, table};
use crate::batch::solve::cost::{MEASURING, measure, of_one, sampling, total};
use crate::batch::{RunOptions, chunks::chunk, solve::divergence};
use crate::calibrate::explained;
use crate::error::Error;
use crate::problem::numbers::parameter::{Default, Parameter};
use crate::problem::{Case, Violation};
use crate::solve::Warning;
use crate::study::Study;
use crate::study_figures;
use clap::Args;
use std::path::PathBuf;
use std::time::Instant;

/// The arguments of `slipgap explain`.
#[derive(Args)]
pub struct ExplainArgs {
    /// Study file; `-` is standard input
    study: PathBuf,
    /// Number of the case, from 0
    #[arg(default_value_t = 0, value_parser = whole::<u64>(0, u64::MAX))]
    case: u64,
    /// Print the request of the case that a program of `programs` gets, a line of JSON, and nothing else; nothing is started
    #[arg(long)]
    request: bool,
    #[command(flatten)]
    settings: SettingsArgs,
}

impl ExplainArgs {
    /// Shows the case; returns the exit code.
    pub fn execute(self) -> Result<u8, Error> {
        if self.study.is_dir() {
            let what = format!("{} is a folder; name one study", self.study.display());
            return Err(Error::Usage(what));
        }
        let sources = sources::read(&[self.study], &self.settings.set, u64::MAX)?;
        let source = sources.first();
        source.map_or(Ok(0), |source| match self.request {
            true => request(source, self.case),
            false => explain(source, self.case),
        })
    }
}

/// Prints case `number` of a study; returns the exit code.
fn explain(source: &Source, number: u64) -> Result<u8, Error> {
    let study = &source.study;
    let case = case_of(source, number)?;
    let mut text = format!(
        "{}: case {number} of {} ({})\n\n",
        source.name,
        cases(study),
        study.problem.schema().meaning
    );
    let mut rows = vec![
        ["parameter", "value", "unit", "from", "meaning"]
            .map(String::from)
            .to_vec(),
    ];
    let units = study.units.as_ref();
    for (row, parameter) in case.schema.parameters.iter().enumerate() {
        let Some(value) = case.values[row] else {
            continue;
        };
        rows.push(vec![
            parameter.name.to_string(),
            value.to_string(),
            units.map_or(parameter.unit.to_string(), |units| {
                units.of_words(&parameter.unit)
            }),
            origin(study, number, row, parameter),
            parameter.meaning.to_string(),
        ]);
    }
    text += &table(&rows);
    if let Some(scales) = units.and_then(|units| units.scales(&*study.problem, &case)) {
        text += &format!("\n{scales}");
    }
    if let Some(description) = study
        .problem
        .as_structure()
        .and_then(|structure| structure.description(&case))
    {
        text += &format!("\n{description}");
    }
    for note in study.notes() {
        text += &format!("note: {note}\n");
    }
    text += &programs(study);
    let broken = Violation::all(&study.violations(number));
    if let Some(why) = &broken {
        text += &format!("\nthis case cannot be solved: {why}\n");
    }
    // What is known without a solution is shown at once: that of thousands of contacts takes a minute.
    print(&text)?;
    text.clear();
    let (warnings, seconds) = match broken {
        Some(_) => (String::new(), None),
        None => warnings(study, &case),
    };
    text += &format!("\n{}{warnings}", cost(study, &case, seconds)?);
    if broken.is_none() {
        text += &diverging(study, number, seconds);
    }
    text += &explained(study);
    let metrics: Vec<&str> = study
        .columns
        .iter()
        .map(|m| study.measures[*m].name.as_str())
        .collect();
    text += &format!("metrics: {}\n", metrics.join(", "));
    text += &list(
        "reductions",
        study
            .reductions()
            .map(|(_, measure, _)| measure.name.as_str()),
    );
    let figures = study
        .figures
        .iter()
        .filter(|figure| figure.filter.matches(&case));
    text += &list("figures", figures.map(|figure| figure.name.as_str()));
    let checks = study
        .checks
        .iter()
        .filter(|check| check.filter.matches(&case));
    text += &list(
        "checks",
        checks.map(|check| study.measures[check.metric].name.as_str()),
    );
    let code = print(&text)?;
    Ok(broken.map_or(code, |_| UNSOLVED))
}

/// Most work of a case that is solved for its warnings: about a second.
const SOLVED: u64 = 500_000_000;

/// The warnings of the case, as a run reports them, and the seconds that they took if it was tried to solve it.
fn warnings(study: &Study, case: &Case) -> (String, Option<f64>) {
    // These make what is computed once for many cases, such as a synthetic record: it is no part of the time of a case.
    let doubts = study.problem.doubts(case);
    let line = |kind: Warning| {
        // Of one of several cases it is none: the others may have another result.
        let is_of_others = kind.is_of_all_cases() && study.len() > 1;
        let word = match kind.is_note() || is_of_others {
            true => "note",
            false => "warning",
        };
        let mut text = format!("{word}: {}: cases {}", kind.name(), kind.message());
        if let Some((_, detail)) = doubts.iter().find(|doubt| doubt.0 == kind) {
            text += &format!("; {detail}");
        }
        if is_of_others {
            text += "; `run` warns of it if it is so in all cases";
        }
        text + "\n"
    };
    if study.work(case) > SOLVED {
        let known: String = doubts.iter().map(|doubt| line(doubt.0)).collect();
        let not_looked_for = "warnings: those of the motion are not looked for, the case takes long; `run` reports them\n";
        return (known + not_looked_for, None);
    }
    let start = Instant::now();
    let solved = study.solve(case);
    let seconds = start.elapsed().as_secs_f64();
    let text = match solved {
        Err(why) => format!("warnings: none, the case could not be solved: {why}\n"),
        Ok(solution) => solution.warnings.iter().map(line).collect(),
    };
    (text, Some(seconds))
}

/// The number of cases that are solved in a short time if one takes so many seconds.
fn affordable(seconds: f64) -> u64 {
    (MEASURING.as_secs_f64() / seconds) as u64
}

/// In how many cases like this one a small change grows, as far as cases are solved in a short time.
fn diverging(study: &Study, number: u64, seconds: Option<f64>) -> String {
    if !study.problem.schema().described {
        return String::new();
    }
    // Each is solved twice.
    let most = affordable(2.0 * seconds.unwrap_or(f64::INFINITY));
    match divergence::sampled_like(study, number, most) {
        Some(divergence) => format!("divergence: {divergence}\n"),
        None => {
            "divergence: not looked for, the case takes long; `report` says in how many cases\n"
                .into()
        }
    }
}

/// The origin of the value of a parameter.
fn origin(study: &Study, number: u64, row: usize, parameter: &Parameter) -> String {
    let Some(block) = study.enumeration().block_of(number) else {
        return String::new();
    };
    if let Some(derived) = block.derived.iter().find(|d| d.parameter == row) {
        return format!("\"{}\"", derived.text);
    }
    let group = block
        .groups
        .iter()
        .find(|group| group.axes.iter().any(|axis| axis.parameter == row));
    let design = |row: &usize| {
        block
            .design
            .as_ref()
            .is_some_and(|d| d.parameters.contains(row))
    };
    match (group, &parameter.default) {
        (Some(_), _) if design(&row) => "design".into(),
        (Some(group), _) if group.len() > 1 => format!("axis of {}", group.len()),
        (Some(_), _) => "study".into(),
        (None, Default::Is(_)) => "default".into(),
        (None, Default::Required | Default::Follows(_)) => "follows".into(),
    }
}

/// Steps and work of the case and of the study, and the estimated time of the study, measured on some of its cases.
///
/// A case that took long, in `seconds`, is that measurement.
fn cost(study: &Study, case: &Case, seconds: Option<f64>) -> Result<String, Error> {
    let (steps, work) = (case.steps(), study.work(case));
    let total = total(study);
    let keep = |case: &Case| study_figures::show_history(study, case);
    let options = RunOptions {
        keep_history: study_figures::show_histories(study).then_some(&keep),
        ..RunOptions::METRICS
    };
    let long = seconds.filter(|seconds| *seconds >= MEASURING.as_secs_f64());
    let measured = match long {
        Some(seconds) => of_one(study, total, &options, (case, seconds)),
        None => {
            let at_once = affordable(seconds.unwrap_or(f64::INFINITY));
            measure(study, total, &options, (case, MEASURING, at_once))?
        }
    };
    let threads = match measured.threads {
        1 => "1 thread".into(),
        threads => format!("{threads} threads"),
    };
    let time = match measured.seconds_for(total + sampling(study)) {
        Some(seconds) => format!("{} on {threads}", duration(seconds)),
        None => "not measured".into(),
    };
    let shares = !study.samples(case).key.is_empty()
        || study.problem.work(case, &study.metrics).references > 0;
    let alike = if shares { " like this one" } else { "" };
    let measured_in = duration(measured.seconds);
    let from = match long {
        Some(seconds) => format!("this case, which took {}", duration(seconds)),
        None if measured.cases == 1 => format!("1 case{alike} in {measured_in}"),
        None => format!("{} cases{alike} in {measured_in}", measured.cases),
    };
    Ok(format!(
        "steps: {steps}; steps x modes: {work} of {total:.3e} in all cases; {} of the store\n\
         time to compute all cases: {time}, estimated from {from}\n",
        parts(study, total),
    ))
}

/// The number of parts of the store: one for each chunk, or more if the work divides chunks.
fn parts(study: &Study, total: f64) -> String {
    match (chunk::count(study), total <= chunk::WORK as f64) {
        (1, true) => "1 part".into(),
        (chunks, true) => format!("{chunks} parts"),
        (chunks, false) => {
            let least = (total / chunk::WORK as f64).ceil().max(chunks as f64);
            format!("at least {least} parts")
        }
    }
}

/// A line with names; empty if there are none.
fn list<'a>(what: &str, names: impl Iterator<Item = &'a str>) -> String {
    let names: Vec<&str> = names.collect();
    match names.is_empty() {
        true => String::new(),
        false => format!("{what}: {}\n", names.join(", ")),
    }
}
