//! What `slipgap recommend` prints: cases with the errors that decided, then all metrics of each, then a study's parameters.

use super::columns;
use slipgap::error::Error;
use slipgap::problem::Case;
use slipgap::problem::parameter::{Value, shortest};
use slipgap::recommend::{FINER, Request, Space, Target, Tried, with_a_finer_step};
use std::f64::consts::PI;

/// A case to print.
pub struct Row<'a> {
    /// What it is to the reader.
    pub name: &'static str,
    pub tried: &'a Tried,
}

/// The cases, with the largest errors of each and its neighbours, and the default metrics of each case by itself.
pub fn tables(space: &dyn Space, request: &Request, rows: &[Row]) -> Result<String, Error> {
    let shown = space.shown();
    let mut header = vec![String::new()];
    header.extend(shown.iter().map(|name| (*name).to_owned()));
    header.push(space.cost_title().into());
    header.extend(request.targets.iter().map(|target| target.name.to_owned()));
    header.extend(request.energy_gain.map(|_| "energy gain".to_owned()));
    header.push("worst/target".into());
    let mut table = vec![header];
    let mut own: Vec<Vec<Option<f64>>> = Vec::new();
    for row in rows {
        let mut cells = vec![row.name.to_owned()];
        let case = &row.tried.cases[0];
        cells.extend(shown.iter().map(|name| match case.number(name) {
            // What follows from others is a rounder number to read.
            Some(x) if ["gamma", "k_I"].contains(name) => digits(x),
            _ => written(case, name),
        }));
        cells.push(row.tried.cost.to_string());
        cells.extend(row.tried.misses.iter().map(|miss| digits(*miss)));
        let mut gains: Vec<f64> = Vec::new();
        for (i, case) in row.tried.cases.iter().enumerate() {
            let solution = space
                .problem()
                .solve(case, &[])
                .map_err(|why| Error::Internal(why.to_string()))?;
            gains.extend(space.energy_gain(case, &solution.computed));
            if i == 0 {
                own.push(solution.metrics);
            }
        }
        cells.extend(gains.into_iter().reduce(f64::max).map(digits));
        cells.push(digits(row.tried.worst));
        table.push(cells);
    }
    let mut last = vec!["target".to_owned()];
    last.extend(shown.iter().map(|_| String::new()));
    last.push(String::new());
    let limits = request.targets.iter().map(|target| target.limit);
    let limits = limits.chain(request.energy_gain).chain([1.0]);
    last.extend(limits.map(|limit| format!("<= {}", shortest(limit))));
    table.push(last);
    let mut text = columns(&table);
    text += "Each error above is the largest one of the case and its neighbours. Only metrics with a target are limited. Metrics of the case alone:\n";
    let mut metrics = vec![vec![String::new()]];
    metrics[0].extend(rows.iter().map(|row| row.name.to_owned()));
    let finer = rows.first().map(|row| with_finer_step(space, row));
    if let Some(finer) = finer.transpose()? {
        metrics[0].insert(2, format!("the same, step/{FINER}"));
        own.insert(1, finer);
    }
    let names = space.problem().metrics().iter().enumerate();
    for (i, metric) in names.filter(|(_, metric)| metric.default) {
        let mut cells = vec![metric.name.to_string()];
        cells.extend(
            own.iter()
                .map(|own| own[i].map_or("undefined".into(), digits)),
        );
        metrics.push(cells);
    }
    text += &columns(&metrics);
    text += &at_a_finer_step(request, &own);
    Ok(text)
}

/// The metrics of a row's case with a finer step.
fn with_finer_step(space: &dyn Space, row: &Row) -> Result<Vec<Option<f64>>, Error> {
    let problem = space.problem();
    let finer = with_a_finer_step(problem, &row.tried.cases[0]);
    let solution = problem
        .solve(&finer, &[])
        .map_err(|why| Error::Internal(why.to_string()))?;
    Ok(solution.metrics)
}

/// A warning where the first case reaches a target that it misses with a finer step, which is the second of `own`.
fn at_a_finer_step(request: &Request, own: &[Vec<Option<f64>>]) -> String {
    let [case, finer, ..] = own else {
        return String::new();
    };
    let lost =
        |target: &&Target| target.miss(case) <= target.limit && target.miss(finer) > target.limit;
    let lost = request.targets.iter().filter(lost);
    let lost: Vec<String> = lost
        .map(|t| {
            format!(
                "{} {} > {}",
                t.name,
                digits(t.miss(finer)),
                shortest(t.limit)
            )
        })
        .collect();
    match lost.is_empty() {
        true => String::new(),
        false => format!(
            "This answer is valid only for its own time step. With 1/{FINER} of the step it misses the target: {}.\n",
            lost.join(", ")
        ),
    }
}

/// Four digits.
fn digits(x: f64) -> String {
    let rounded: f64 = format!("{x:.3e}").parse().unwrap_or(x);
    shortest(rounded)
}

/// Largest numerator of a fraction to print.
const NUMERATORS: i32 = 9;

/// The value of a parameter as a study would have it, as an expression where that is rounder; `-` where it does not apply.
fn written(case: &Case, name: &str) -> String {
    let whole = |x: f64| (x - x.round()).abs() < 1e-9 && x.round() > 0.0;
    match case.get(name) {
        Some(Value::Number(x)) if name == "dT" && whole(PI / x) => {
            format!("pi/{}", (PI / x).round())
        }
        Some(Value::Number(x)) if name == "dt" => {
            let fraction = (1..=NUMERATORS).find(|k| whole(f64::from(*k) / x));
            // Only what reads back the same double.
            let same = |k: &i32| f64::from(*k) / (f64::from(*k) / x).round() == x;
            match fraction.filter(same) {
                Some(k) => format!("{k}/{}", (f64::from(k) / x).round()),
                None => shortest(x),
            }
        }
        Some(Value::Number(x)) if name == "duration" && whole(x / PI) => {
            format!("{}*pi", (x / PI).round())
        }
        Some(value) => value.to_string(),
        None => "-".into(),
    }
}

/// The parameters to paste into a study.
pub fn pasted(space: &dyn Space, case: &Case) -> String {
    let (mut own, mut right) = (Vec::new(), Vec::new());
    for name in space.stated() {
        let Some(value) = case.get(name) else {
            continue;
        };
        let text = written(case, name);
        let text = match value {
            Value::Name(_) => format!("\"{text}\""),
            _ if text.contains(['/', '*']) => format!("\"{text}\""),
            _ => text,
        };
        match name.strip_prefix("right.") {
            Some(key) => right.push(format!("\"{key}\": {text}")),
            None => own.push(format!("\"{name}\": {text}")),
        }
    }
    if !right.is_empty() {
        own.push(format!("\"right\": {{ {} }}", right.join(", ")));
    }
    format!("\"parameters\": {{ {} }}", own.join(", "))
}
