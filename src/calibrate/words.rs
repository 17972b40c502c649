//! A calibration on a terminal: tables of the alternatives and of their best values.

use super::sentences::sentences;
use super::{Calibration, Fit, State, Verdict};
use slipgap_problem::problem::numbers::parameter::shortest;
use slipgap_recommend::calibrate::End;
use slipgap_recommend::format::digits;
use slipgap_study::Free;

/// How sharply a parameter is determined.
pub fn state_name(state: State) -> &'static str {
    match state {
        State::Determined => "determined",
        State::OnlyBelow => "only a smallest value",
        State::OnlyAbove => "only a largest value",
        State::Not => "not determined",
    }
}

/// Whether the alternative at a position is told apart from the best one.
pub fn verdict(found: &Calibration, at: usize) -> &'static str {
    let comparison = found
        .comparisons
        .iter()
        .find(|comparison| comparison.fits[1] == at);
    match comparison.map(|comparison| comparison.verdict) {
        None if found.fits[at].misfit().is_finite() => "best",
        None => "no solution",
        Some(Verdict::Better) => "worse",
        Some(Verdict::NotToldApart | Verdict::WithinNoise) => "not told apart",
        Some(Verdict::Unknown) => "unknown",
    }
}

/// By how much the information criterion of the alternative at a position is above that of the best one.
pub fn information(found: &Calibration, at: usize) -> Option<f64> {
    let mut comparisons = found.comparisons.iter();
    match comparisons.find(|comparison| comparison.fits[1] == at) {
        Some(comparison) => comparison.information,
        None => found.fits[at].residuals.as_ref().map(|_| 0.0),
    }
}

/// A number with six digits.
fn six(x: f64) -> String {
    shortest(format!("{x:.5e}").parse().unwrap_or(x))
}

/// The tables and sentences for a terminal; `table` aligns columns.
pub fn text(found: &Calibration, table: &dyn Fn(&[Vec<String>]) -> String) -> String {
    let mut text = format!("minimised: {}\n\n", minimised(found));
    text += &table(&summary(found));
    for at in &found.order {
        let fit = &found.fits[*at];
        if !fit.misfit().is_finite() || fit.free.is_empty() {
            continue;
        }
        text += &format!("\n{}\n", heading(found, fit));
        text += &table(&values(found, fit));
    }
    let lines = sentences(found);
    if !lines.is_empty() {
        text += &format!("\n{}\n", lines.join("\n"));
    }
    text
}

/// The metric, and the tests.
fn minimised(found: &Calibration) -> String {
    let calibrate = found.study.calibrate.as_ref();
    let name = calibrate.map_or("", |calibrate| {
        &found.study.measures[calibrate.minimise].name
    });
    match found
        .fits
        .first()
        .map_or(0, |fit| fit.alternative.tests.len())
    {
        0 | 1 => name.to_owned(),
        count => format!("{name} of {count} tests together"),
    }
}

/// A row for each alternative, the best one first.
fn summary(found: &Calibration) -> Vec<Vec<String>> {
    let header = [
        "alternative",
        "misfit",
        "numerical part",
        "rho_1",
        "points",
        "BIC above the best",
        "starts at the best",
        "cases",
        "",
    ];
    let row = |at: &usize| {
        let fit = &found.fits[*at];
        let solved = fit.misfit().is_finite();
        let numerical = fit.numerical.as_ref();
        let residuals = fit.residuals.as_ref();
        let [best, starts] = fit.found.best.starts;
        vec![
            fit.label().to_owned(),
            if solved {
                digits(fit.misfit())
            } else {
                "-".into()
            },
            numerical.map_or("-".into(), |numerical| {
                format!("{} ({})", digits(numerical.total()), numerical.source())
            }),
            residuals.map_or("-".into(), |residuals| {
                format!("{:.2}", residuals.correlation)
            }),
            residuals.map_or("-".into(), |residuals| residuals.count.to_string()),
            information(found, *at).map_or("-".into(), digits),
            match starts {
                0 => "-".into(),
                _ => format!("{best} of {starts}"),
            },
            fit.solved.to_string(),
            verdict(found, *at).to_owned(),
        ]
    };
    let rows = found.order.iter().map(row);
    std::iter::once(header.map(String::from).to_vec())
        .chain(rows)
        .collect()
}

fn heading(found: &Calibration, fit: &Fit) -> String {
    let table = found.study.problem.parameters();
    let unused: Vec<&str> = fit
        .unused
        .iter()
        .map(|free_parameter| &*table[free_parameter.parameter].name)
        .collect();
    match unused.is_empty() {
        true => format!("{}:", fit.label()),
        false => format!("{}, which does not use {}:", fit.label(), unused.join(", ")),
    }
}

/// The best values of an alternative.
fn values(found: &Calibration, fit: &Fit) -> Vec<Vec<String>> {
    let table = found.study.problem.parameters();
    let intervals = fit
        .found
        .profiles
        .iter()
        .any(|profile| profile.interval.is_some());
    let unit = |free: &Free| {
        let shown = table[free.parameter].shown_unit.as_ref();
        shown.map_or(String::new(), |unit| unit.to_string())
    };
    let units = fit.free.iter().any(|free| !unit(free).is_empty());
    let mut header = vec!["parameter", "best"];
    header.extend(units.then_some("unit"));
    header.extend(intervals.then_some("95 % interval"));
    header.extend(["within 10 % of the best misfit", "searched", ""]);
    let range = |index: usize, ends: Option<[End; 2]>| {
        let Some(ends) = ends else {
            return "-".to_owned();
        };
        let [from, to] = ends.map(|end| fit.value(index, end).map(six));
        match (from, to) {
            (Some(from), Some(to)) => format!("{from} to {to}"),
            (Some(from), None) => format!("from {from}"),
            (None, Some(to)) => format!("up to {to}"),
            (None, None) => "all".to_owned(),
        }
    };
    let row = |(index, free): (usize, &Free)| {
        let parameter = &table[free.parameter];
        let profile = fit.found.profiles.get(index);
        let [low, high] = free.range.ends.map(shortest);
        let mut row = vec![parameter.name.to_string(), six(fit.values[index])];
        row.extend(units.then(|| unit(free)));
        row.extend(intervals.then(|| range(index, profile.and_then(|profile| profile.interval))));
        row.push(range(index, profile.map(|profile| profile.within_tenth)));
        row.push(format!("{low} to {high}"));
        row.push(fit.state(index).map_or("", state_name).to_owned());
        row
    };
    let rows = fit.free.iter().enumerate().map(row);
    let header = header.into_iter().map(String::from).collect();
    std::iter::once(header).chain(rows).collect()
}
