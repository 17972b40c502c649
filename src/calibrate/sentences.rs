//! What the numbers of a calibration do not say: what is not determined, and which alternatives are told apart.

use super::compare::DECISIVE;
use super::scatter;
use super::{Calibration, Fit, Numerical, State, Verdict};
use slipgap_problem::problem::numbers::parameter::shortest;
use slipgap_recommend::format::digits;

/// Why an alternative has no misfit, by the first of its tests at the last point that was tried.
fn without_solution(fit: &Fit) -> String {
    let refusal = fit.tests.iter().find_map(|test| test.why.as_deref());
    let why = refusal.unwrap_or("the misfit has no value");
    format!(
        "{}: no case has a solution with a misfit; one of them: {why}",
        fit.label()
    )
}

/// What the numbers do not say.
pub fn sentences(found: &Calibration) -> Vec<String> {
    let mut sentences = Vec::new();
    for at in &found.order {
        let fit = &found.fits[*at];
        match fit.misfit().is_finite() {
            false => sentences.push(without_solution(fit)),
            true => sentences.extend(of_fit(found, fit)),
        }
    }
    for comparison in &found.comparisons {
        let [better, worse] = comparison.fits.map(|at| &found.fits[at]);
        let part = |fit: &Fit| fit.numerical.as_ref().map_or(0.0, Numerical::total);
        let names = [better, worse].map(Fit::label);
        let misfits = [better, worse].map(|fit| digits(fit.misfit()));
        let parts = [better, worse].map(|fit| digits(part(fit)));
        let criterion = comparison.information.map(digits);
        sentences.push(match comparison.verdict {
            Verdict::WithinNoise => format!(
                "{} and {} are not told apart: their misfits {} and {} differ by no more than noise can cause (difference of BIC {}, \
                 below {DECISIVE})",
                names[0],
                names[1],
                misfits[0],
                misfits[1],
                criterion.unwrap_or_default()
            ),
            Verdict::Better => format!(
                "{} is nearer to the measurement than {}: {} + {} < {} - {}, misfits with their numerical parts",
                names[0], names[1], misfits[0], parts[0], misfits[1], parts[1]
            ),
            Verdict::NotToldApart => format!(
                "{} and {} are not told apart: their misfits {} and {} differ by less than their numerical parts {} and {}{}",
                names[0],
                names[1],
                misfits[0],
                misfits[1],
                parts[0],
                parts[1],
                match comparison.information {
                    Some(difference) if difference < DECISIVE => ", and by no more than noise can cause",
                    _ => "; a smaller dt makes these smaller",
                }
            ),
            Verdict::Unknown => format!(
                "{} and {} are not compared: the numerical part of a misfit is unknown",
                names[0], names[1]
            ),
        });
    }
    sentences
}

/// What an alternative does not determine.
fn of_fit(found: &Calibration, fit: &Fit) -> Vec<String> {
    let table = found.study.problem.parameters();
    let prefix = match found.fits.len() {
        1 => String::new(),
        _ => format!("{}: ", fit.label()),
    };
    let mut sentences = Vec::new();
    let name = |index: usize| &*table[fit.free[index].parameter].name;
    if fit.free.is_empty() {
        sentences.push(format!(
            "{prefix}nothing was searched, because no free parameter is used; the misfit is that of the study's values"
        ));
    }
    let intervals = fit
        .found
        .profiles
        .iter()
        .any(|profile| profile.interval.is_some());
    let good = match intervals {
        true => "in its 95 % interval",
        false => "within 10 % of the best misfit",
    };
    for index in 0..fit.free.len() {
        let [low, high] = fit.free[index].range.ends.map(shortest);
        match fit.state(index) {
            Some(State::Not) => sentences.push(format!(
                "{prefix}{} is not determined: all values from {low} to {high} are {good}",
                name(index)
            )),
            Some(State::OnlyBelow) => sentences.push(format!(
                "{prefix}{} has only a smallest value: those up to {high}, the end of its range, are {good}",
                name(index)
            )),
            Some(State::OnlyAbove) => sentences.push(format!(
                "{prefix}{} has only a largest value: those down to {low}, the end of its range, are {good}",
                name(index)
            )),
            Some(State::Determined) | None => {}
        }
        if let Some(end) = fit.at_end(index) {
            let (which, value) = [("lower", &low), ("upper", &high)][end];
            sentences.push(format!(
                "{prefix}the best {} is at the {which} end of its range, {value}; a wider range may have a better one",
                name(index)
            ));
        }
    }
    if fit.found.combined.len() > 1 {
        let combined = fit.found.combined.iter().map(|index| name(*index));
        let names: Vec<&str> = combined.collect();
        sentences.push(format!(
            "{prefix}only a combination of {} is determined, not each by itself",
            names.join(", ")
        ));
    }
    sentences.extend(scatter::sentences(found, fit, &prefix));
    if let Some(residuals) = &fit.residuals
        && !residuals.are_white()
    {
        let rho = format!("{:.2}", residuals.correlation);
        let count = residuals.count;
        sentences.push(match residuals.for_intervals() {
            Some(effective) => format!(
                "{prefix}residuals are not white (rho_1 = {rho} of {count} points): the model misses something, intervals are approximate, \
                 as of {effective:.0} independent points"
            ),
            None => format!(
                "{prefix}residuals are not white (rho_1 = {rho} of {count} points): the model misses something, and there are no intervals"
            ),
        });
    }
    if let (true, Some(numerical), Some(residuals)) = (intervals, &fit.numerical, &fit.residuals)
        && numerical.total() > 2.0 * fit.misfit() / residuals.effective().sqrt()
    {
        sentences.push(format!(
            "{prefix}the numerical part may move the best values by more than their intervals, which are of noise only; use a smaller dt"
        ));
    }
    if fit.residuals.is_none() && !fit.free.is_empty() {
        sentences.push(format!(
            "{prefix}there are no 95 % intervals, because the minimised metric is no rms_error(CHANNEL, measured) alone"
        ));
    }
    if intervals && fit.found.widened > 1.0 {
        sentences.push(format!(
            "{prefix}the misfit jumps where contacts begin or vanish, which makes the intervals {} times as wide",
            digits(fit.found.widened)
        ));
    }
    if intervals && !fit.found.quadratic {
        sentences.push(format!(
            "{prefix}the squared misfit is not quadratic over the intervals: use these and the profiles, not the correlation"
        ));
    }
    if fit.found.best.spent {
        let cases = found
            .study
            .calibrate
            .as_ref()
            .map_or(0, |calibrate| calibrate.cases);
        sentences.push(format!(
            "{prefix}the search spent all its {cases} cases before it ended; \"cases\" of \"calibrate\" allows more"
        ));
    }
    sentences
}
