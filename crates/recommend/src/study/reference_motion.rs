//! What metrics are compared with: the exact motion where it is known, else the finest motion of the study.

use super::candidate::Choice;
use super::errors::{From, is_error};
use super::judge::{Judge, all_of};
use crate::calibrate::Stopped;
use crate::with_finer_step;
use rayon::prelude::*;
use slipgap_problem::problem::Case;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_problem::problem::table::cases::Cases;

/// What the metrics of a study are compared with.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    /// The finest candidate: its chosen parameters with their values.
    pub finest: Vec<(usize, Value)>,
    /// By metric: where its values come from; the finest motion in all physical cases if one has no exact value.
    pub from: Vec<From>,
}

/// The finest candidate that has all physical cases: the one with most modes or nodes, then with the smallest step, then the last one.
pub(super) fn finest<'a>(choices: &'a [Choice], judge: &Judge) -> Option<&'a Choice> {
    let whole = choices.iter().filter(|choice| choice.is_whole(judge));
    whole.max_by(|a, b| a.compare_fineness(b))
}

/// Finds the references of all physical cases, from the finest candidate.
pub(super) fn refer(choices: &[Choice], judge: &mut Judge) -> Result<Option<Reference>, Stopped> {
    let Some(finest) = finest(choices, judge) else {
        return Ok(None);
    };
    judge.finest = all_of(&finest.cases(judge, &[], &[]));
    judge.from = sources(&judge.finest, judge);
    let cases = judge.finest.clone();
    add(&cases, judge)?;
    Ok(Some(Reference {
        finest: finest.values.clone(),
        from: judge.from.clone(),
    }))
}

/// Adds the references of these cases of the finest candidate.
pub(super) fn add(cases: &[Case], judge: &mut Judge) -> Result<(), Stopped> {
    let values = values(cases, judge)?;
    for (case, values) in cases.iter().zip(values) {
        let condition = judge.condition(case);
        judge.references.insert(condition, values);
    }
    Ok(())
}

/// Where the values of each metric come from.
fn sources(cases: &[Case], judge: &Judge) -> Vec<From> {
    let exact = exact(cases, judge);
    let within = judge.recommend.within.iter().enumerate();
    let source =
        |(at, (row, _)): (usize, &(usize, f64))| match is_error(&judge.study.measures[*row].name) {
            true => From::Zero,
            false if exact.iter().all(|values| values[at].is_some()) => From::Exact,
            false => From::Finest,
        };
    within.map(source).collect()
}

/// The metrics of the exact motions; none that are not known, and none of errors.
fn exact(cases: &[Case], judge: &Judge) -> Vec<Vec<Option<f64>>> {
    let problem = &*judge.study.problem;
    let metrics: Vec<usize> = (0..problem.metrics().len()).collect();
    let errors = judge
        .rows()
        .all(|row| is_error(&judge.study.measures[row].name));
    let exact_of = |case: &Case| match errors {
        true => vec![None; metrics.len()],
        false => problem
            .as_structure()
            .map_or(vec![None; metrics.len()], |structure| {
                structure.exact_metrics(case, &metrics)
            }),
    };
    let exact: Vec<Vec<Option<f64>>> = cases.par_iter().map(exact_of).collect();
    let pairs = cases.iter().zip(&exact);
    pairs
        .map(|(case, metrics)| judge.measured(case, metrics))
        .collect()
}

/// The values of each metric in these cases, from the sources of the judge.
pub(super) fn values(cases: &[Case], judge: &mut Judge) -> Result<Vec<Vec<Option<f64>>>, Stopped> {
    let mut values = exact(cases, judge);
    if judge.from.contains(&From::Finest) {
        let problem = &*judge.study.problem;
        let mut halves = Cases::new(problem.schema());
        for case in cases {
            halves.push(&with_finer_step(problem, case, 2));
        }
        let none = vec![None; problem.metrics().len()];
        for (at, solved) in judge.solve(&halves)?.iter().enumerate() {
            let metrics = solved.as_ref().map_or(&none, |solved| &solved.metrics);
            let finest = judge.measured(&cases[at], metrics);
            let places = (0..finest.len()).filter(|metric| judge.from[*metric] == From::Finest);
            places.for_each(|metric| values[at][metric] = finest[metric]);
        }
    }
    Ok(values)
}
