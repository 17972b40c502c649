//! What metrics are compared with: the exact motion where it is known, else the finest motion of the study.

use super::candidate::Choice;
use super::errors::is_error;
use super::judge::{Judge, all_of};
use crate::calibrate::Stopped;
use crate::with_finer_step;
use rayon::prelude::*;
use slipgap_problem::problem::Case;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_problem::problem::table::cases::Cases;

/// Where the value comes from that a metric is compared with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum From {
    /// The metric is an error: 0.
    Zero,
    /// The exact motion of the finest candidate.
    Exact,
    /// The motion of the finest candidate with half its step.
    Finest,
}

/// What the metrics of a study are compared with.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    /// The finest candidate: its chosen parameters with their values.
    pub finest: Vec<(usize, Value)>,
    /// By metric: where its values come from; the finest motion in all physical cases if one has no exact value.
    pub from: Vec<From>,
}

/// Finds the references of all physical cases, from the finest candidate that has all of them: the one with most modes or nodes, then
/// with the smallest step, then the last one.
pub(super) fn refer(choices: &[Choice], judge: &mut Judge) -> Result<Option<Reference>, Stopped> {
    let whole = choices.iter().filter(|choice| choice.is_whole(judge));
    let Some(finest) = whole.max_by(|a, b| a.compare_fineness(b)) else {
        return Ok(None);
    };
    let (study, recommend) = (judge.study, judge.recommend);
    let problem = &*study.problem;
    let cases = all_of(&finest.cases(judge, &[], &[]));
    let rows: Vec<usize> = recommend.within.iter().map(|own| own.0).collect();
    let zero: Vec<bool> = rows
        .iter()
        .map(|row| is_error(&study.measures[*row].name))
        .collect();
    let metrics: Vec<usize> = (0..problem.metrics().len()).collect();
    let exact = |case: &Case| match zero.contains(&false) {
        true => problem.exact_metrics(case, &metrics),
        false => vec![None; metrics.len()],
    };
    let exact: Vec<Vec<Option<f64>>> = cases.par_iter().map(exact).collect();
    let values = |case: usize, metrics: &[Option<f64>]| -> Vec<Option<f64>> {
        let value = |row: &usize| study.measure_value(*row, &cases[case], &|at| metrics[at]);
        rows.iter().map(value).collect()
    };
    let mut references: Vec<Vec<Option<f64>>> = (0..cases.len())
        .map(|case| values(case, &exact[case]))
        .collect();
    let unknown = |at: usize| !zero[at] && references.iter().any(|own| own[at].is_none());
    let from: Vec<From> = (0..rows.len())
        .map(|at| match (zero[at], unknown(at)) {
            (true, _) => From::Zero,
            (false, false) => From::Exact,
            (false, true) => From::Finest,
        })
        .collect();
    if from.contains(&From::Finest) {
        let mut halves = Cases::new(problem.schema());
        for case in &cases {
            halves.push(&with_finer_step(problem, case, 2));
        }
        for (case, solved) in judge.solve(&halves)?.iter().enumerate() {
            let none = vec![None; metrics.len()];
            let own = values(case, solved.as_ref().map_or(&none, |own| &own.0));
            for at in (0..rows.len()).filter(|at| from[*at] == From::Finest) {
                references[case][at] = own[at];
            }
        }
    }
    judge.references = vec![Vec::new(); judge.conditions.len()];
    for (case, own) in cases.iter().zip(references) {
        if let Some(at) = judge.conditions.get(&judge.condition(case)) {
            judge.references[*at] = own;
        }
    }
    Ok(Some(Reference {
        finest: finest.values.clone(),
        from,
    }))
}
