//! Which free parameters an alternative uses, and with which of them cases are not solved side by side.

use slipgap_problem::problem::Case;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_study::{Alternative, Free, Study};

/// The free parameters that an alternative uses, and those that it does not: cases that differ only in one of these have the same
/// equations of motion, and these measures do not contain it.
pub fn used(
    study: &Study,
    alternative: &Alternative,
    parameters: &[Free],
    measures: &[usize],
) -> [Vec<Free>; 2] {
    let in_metric = |free: &Free| {
        let mut measures = measures.iter();
        measures.any(|row| study.measure_contains(*row, free.parameter))
    };
    let same = |one: &Case, other: &Case| {
        study
            .problem
            .as_structure()
            .is_some_and(|structure| structure.has_same_motion(one, other))
    };
    let uses: Vec<bool> = (0..parameters.len())
        .map(|index| {
            in_metric(&parameters[index]) || changes(study, alternative, parameters, index, &same)
        })
        .collect();
    [true, false].map(|wanted| {
        let places = parameters
            .iter()
            .zip(&uses)
            .filter(|(_, uses)| **uses == wanted);
        places.map(|(free, _)| *free).collect()
    })
}

/// Those with which masses, stiffnesses or dashpots change, so that cases are not solved side by side.
pub fn apart(study: &Study, alternative: &Alternative, free: &[Free]) -> Vec<Free> {
    let same = |one: &Case, other: &Case| {
        study
            .problem
            .as_structure()
            .is_some_and(|structure| structure.are_side_by_side(one, other))
    };
    let places = (0..free.len()).filter(|index| changes(study, alternative, free, *index, &same));
    places.map(|index| free[index]).collect()
}

/// Whether cases with other values of a free parameter are not the same: both ends of its range and its middle, with the others in the
/// middle of theirs, and with the others as in the study. A case that breaks a rule is not the same as another one; where all three
/// break one because of the others, they say nothing.
fn changes(
    study: &Study,
    alternative: &Alternative,
    free: &[Free],
    index: usize,
    same: &dyn Fn(&Case, &Case) -> bool,
) -> bool {
    let mut known = false;
    for others in [vec![0.5; free.len()], own_point(study, alternative, free)] {
        let at = |u: f64| {
            let mut point = others.clone();
            point[index] = u;
            point
        };
        let points = [0.0, 0.5, 1.0].map(at);
        let cases = study.point_cases(alternative, free).cases(&points);
        let mut shown = cases.shown();
        let each: Vec<Case> = (0..cases.len()).map(|row| shown.at(row).clone()).collect();
        let solvable: Vec<bool> = (0..cases.len())
            .map(|row| cases.may_be_solved(row))
            .collect();
        let tests = each.chunks(points.len()).zip(solvable.chunks(points.len()));
        for (group, solvable) in tests {
            let is_same = |k: usize| solvable[k] == solvable[0] && same(&group[0], &group[k]);
            if solvable.contains(&true) {
                known = true;
                if !(1..group.len()).all(is_same) {
                    return true;
                }
            }
        }
    }
    !known
}

/// The point of the values that the study gives its free parameters, within their ranges.
fn own_point(study: &Study, alternative: &Alternative, free: &[Free]) -> Vec<f64> {
    let cases = study.point_cases(alternative, &[]).cases(&[Vec::new()]);
    let mut shown = cases.shown();
    let unit = |parameter: &Free| match shown.at(0).values[parameter.parameter] {
        Some(Value::Number(x)) => parameter
            .range
            .unit(x.clamp(parameter.range.ends[0], parameter.range.ends[1])),
        _ => 0.5,
    };
    free.iter().map(unit).collect()
}
