//! A calibration in words: best values, what the measurement does not determine, and which alternatives are told apart.

use super::compare::information;
use super::{Calibration, Fit, State, Verdict};
use slipgap_recommend::calibrate::End;
use slipgap_recommend::format::digits;
use slipgap_solver::problem::parameter::shortest;
use slipgap_study::Free;

/// Difference of the information criterion from which on it says something.
const DECISIVE: f64 = 10.0;

/// Share of a direction from which on a parameter belongs to it.
const SHARE: f64 = 0.1;

/// The name of the one alternative of a study without others.
const ALONE: &str = "study";

/// The name of an alternative.
pub(super) fn label(fit: &Fit) -> &str {
    match fit.alternative.name.as_str() {
        "" => ALONE,
        name => name,
    }
}

/// How sharply a parameter is determined.
pub(super) fn state(state: State) -> &'static str {
    match state {
        State::Determined => "determined",
        State::OnlyBelow => "only a smallest value",
        State::OnlyAbove => "only a largest value",
        State::Not => "not determined",
    }
}

/// Whether the alternative at a position is told apart from the best one.
pub(super) fn verdict(found: &Calibration, at: usize) -> &'static str {
    let own = found.comparisons.iter().find(|own| own.fits[1] == at);
    match own.map(|own| own.verdict) {
        None if found.fits[at].misfit().is_finite() => "best",
        None => "no solution",
        Some(Verdict::Better) => "worse",
        Some(Verdict::NotToldApart) => "not told apart",
        Some(Verdict::Unknown) => "unknown",
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
    let name = calibrate.map_or("", |own| &found.study.measures[own.minimise].name);
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
    let information = information(&found.fits);
    let least = information
        .iter()
        .flatten()
        .fold(f64::INFINITY, |a, b| a.min(*b));
    let header = [
        "alternative",
        "misfit",
        "numerical part",
        "rho_1",
        "points",
        "BIC above the least",
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
            label(fit).to_owned(),
            if solved {
                digits(fit.misfit())
            } else {
                "-".into()
            },
            numerical.map_or("-".into(), |own| {
                format!("{} ({})", digits(own.total()), own.source())
            }),
            residuals.map_or("-".into(), |own| format!("{:.2}", own.correlation)),
            residuals.map_or("-".into(), |own| own.count.to_string()),
            information[*at].map_or("-".into(), |own| digits(own - least)),
            format!("{best} of {starts}"),
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
        .map(|own| &*table[own.parameter].name)
        .collect();
    match unused.is_empty() {
        true => format!("{}:", label(fit)),
        false => format!("{}, which does not use {}:", label(fit), unused.join(", ")),
    }
}

/// The best values of an alternative.
fn values(found: &Calibration, fit: &Fit) -> Vec<Vec<String>> {
    let table = found.study.problem.parameters();
    let intervals = fit.found.profiles.iter().any(|own| own.interval.is_some());
    let unit = |free: &Free| {
        let shown = table[free.parameter].shown_unit.as_ref();
        shown.map_or(String::new(), |unit| unit.to_string())
    };
    let units = fit.free.iter().any(|free| !unit(free).is_empty());
    let mut header = vec!["parameter", "best"];
    header.extend(units.then_some("unit"));
    header.extend(intervals.then_some("95 % interval"));
    header.extend(["within 10 % of the best misfit", "searched", ""]);
    let range = |place: usize, ends: Option<[End; 2]>| {
        let Some(ends) = ends else {
            return "-".to_owned();
        };
        let [from, to] = ends.map(|end| fit.value(place, end).map(six));
        match (from, to) {
            (Some(from), Some(to)) => format!("{from} to {to}"),
            (Some(from), None) => format!("from {from}"),
            (None, Some(to)) => format!("up to {to}"),
            (None, None) => "all".to_owned(),
        }
    };
    let row = |(place, free): (usize, &Free)| {
        let parameter = &table[free.parameter];
        let profile = fit.found.profiles.get(place);
        let [low, high] = free.range.ends.map(shortest);
        let mut row = vec![parameter.name.to_string(), six(fit.values[place])];
        row.extend(units.then(|| unit(free)));
        row.extend(intervals.then(|| range(place, profile.and_then(|own| own.interval))));
        row.push(range(place, profile.map(|own| own.within_tenth)));
        row.push(format!("{low} to {high}"));
        row.push(fit.state(place).map_or("", state).to_owned());
        row
    };
    let rows = fit.free.iter().enumerate().map(row);
    let header = header.into_iter().map(String::from).collect();
    std::iter::once(header).chain(rows).collect()
}

/// What the numbers do not say.
pub fn sentences(found: &Calibration) -> Vec<String> {
    let mut all = Vec::new();
    for at in &found.order {
        let fit = &found.fits[*at];
        match fit.misfit().is_finite() {
            false => all.push(format!(
                "{}: no case has a solution with a misfit",
                label(fit)
            )),
            true => all.extend(of_fit(found, fit)),
        }
    }
    for own in &found.comparisons {
        let [better, worse] = own.fits.map(|at| &found.fits[at]);
        let part = |fit: &Fit| fit.numerical.as_ref().map_or(0.0, super::Numerical::total);
        let names = [better, worse].map(label);
        let misfits = [better, worse].map(|fit| digits(fit.misfit()));
        let parts = [better, worse].map(|fit| digits(part(fit)));
        all.push(match own.verdict {
            Verdict::Better => format!(
                "{} is nearer to the measurement than {}: {} + {} < {} - {}, misfits with their numerical parts",
                names[0], names[1], misfits[0], parts[0], misfits[1], parts[1]
            ),
            Verdict::NotToldApart => format!(
                "{} and {} are not told apart: their misfits {} and {} differ by less than their numerical parts {} and {}; a smaller dt \
                 makes these smaller",
                names[0], names[1], misfits[0], misfits[1], parts[0], parts[1]
            ),
            Verdict::Unknown => format!(
                "{} and {} are not compared: the numerical part of a misfit is unknown",
                names[0], names[1]
            ),
        });
    }
    all.extend(of_information(found));
    all
}

/// What an alternative does not determine.
fn of_fit(found: &Calibration, fit: &Fit) -> Vec<String> {
    let table = found.study.problem.parameters();
    let own = match found.fits.len() {
        1 => String::new(),
        _ => format!("{}: ", label(fit)),
    };
    let mut all = Vec::new();
    let name = |place: usize| &*table[fit.free[place].parameter].name;
    let intervals = fit.found.profiles.iter().any(|own| own.interval.is_some());
    let good = match intervals {
        true => "in its 95 % interval",
        false => "within 10 % of the best misfit",
    };
    for place in 0..fit.free.len() {
        let [low, high] = fit.free[place].range.ends.map(shortest);
        match fit.state(place) {
            Some(State::Not) => all.push(format!(
                "{own}{} is not determined: all values from {low} to {high} are {good}",
                name(place)
            )),
            Some(State::OnlyBelow) => all.push(format!(
                "{own}{} has only a smallest value: those up to {high}, the end of its range, are {good}",
                name(place)
            )),
            Some(State::OnlyAbove) => all.push(format!(
                "{own}{} has only a largest value: those down to {low}, the end of its range, are {good}",
                name(place)
            )),
            Some(State::Determined) | None => {}
        }
        if let Some(end) = fit.at_end(place) {
            let (which, value) = [("lower", &low), ("upper", &high)][end];
            all.push(format!(
                "{own}the best {} is at the {which} end of its range, {value}; a wider range may have a better one",
                name(place)
            ));
        }
    }
    if let Some(direction) = &fit.found.undetermined {
        let large = (0..direction.len()).filter(|k| direction[*k].abs() >= SHARE);
        let names: Vec<&str> = large.map(name).collect();
        if names.len() > 1 {
            all.push(format!(
                "{own}only a combination of {} is determined, not each by itself",
                names.join(", ")
            ));
        }
    }
    if let Some(residuals) = &fit.residuals
        && !residuals.are_white()
    {
        let rho = format!("{:.2}", residuals.correlation);
        let count = residuals.count;
        all.push(match residuals.for_intervals() {
            Some(effective) => format!(
                "{own}residuals are not white (rho_1 = {rho} of {count} points): the model misses something, intervals are approximate, \
                 as of {effective:.0} independent points"
            ),
            None => format!(
                "{own}residuals are not white (rho_1 = {rho} of {count} points): the model misses something, and there are no intervals"
            ),
        });
    }
    if let (true, Some(numerical), Some(residuals)) = (intervals, &fit.numerical, &fit.residuals)
        && numerical.total() > 2.0 * fit.misfit() / residuals.effective().sqrt()
    {
        all.push(format!(
            "{own}the numerical part may move the best values by more than their intervals, which are of noise only; use a smaller dt"
        ));
    }
    if fit.residuals.is_none() && !fit.free.is_empty() {
        all.push(format!(
            "{own}there are no 95 % intervals, because the minimised metric is no rms_error(CHANNEL, measured) alone"
        ));
    }
    if intervals && !fit.found.quadratic {
        all.push(format!(
            "{own}the squared misfit is not quadratic over the intervals: use these and the profiles, not the correlation"
        ));
    }
    if fit.found.best.spent {
        let cases = found.study.calibrate.as_ref().map_or(0, |own| own.cases);
        all.push(format!(
            "{own}the search spent all its {cases} cases before it ended; \"cases\" of \"calibrate\" allows more"
        ));
    }
    all
}

/// What the information criterion says of the two best alternatives that have one.
fn of_information(found: &Calibration) -> Option<String> {
    let information = information(&found.fits);
    let mut all: Vec<(f64, &Fit)> = information
        .iter()
        .zip(&found.fits)
        .filter_map(|(own, fit)| Some(((*own)?, fit)))
        .collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let [(least, first), (next, second), ..] = all[..] else {
        return None;
    };
    Some(format!(
        "BIC, which counts the free parameters, too, is smaller for {} than for {} by {} ({DECISIVE} or more counts as decisive; it does \
         not know the numerical parts)",
        label(first),
        label(second),
        digits(next - least)
    ))
}
