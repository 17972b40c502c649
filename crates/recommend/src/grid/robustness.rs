//! An answer under other conditions than those that it was searched for: how many of them miss the target.

use super::{Candidate, Request, SearchSpace};
use slipgap_problem::problem::table::cases::Cases;

/// An answer over a range of a parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct Robustness {
    /// The parameter.
    pub parameter: &'static str,
    /// What its values are called, in the plural.
    pub title: &'static str,
    /// Smallest and largest value.
    pub ends: [f64; 2],
    /// Number of values.
    pub count: usize,
    /// Number of values that miss the target.
    pub missed: usize,
    /// The value with the largest error relative to its limit.
    pub at: f64,
    /// The target with that error, by its place in the request.
    pub target: usize,
    /// The error.
    pub error: f64,
}

/// Solves the case of a candidate at all values of its range; `None` if the space has no range.
pub fn robustness(
    space: &dyn SearchSpace,
    request: &Request,
    candidate: &Candidate,
) -> Option<Robustness> {
    let range = space.range(candidate.cases.first()?)?;
    let mut cases = Cases::new(space.problem().schema());
    for case in &range.cases {
        cases.push(case);
    }
    let rows: Vec<u32> = (0..range.cases.len() as u32).collect();
    let table = space.problem().sweep(&cases, &rows);
    let value = |case: usize| range.cases.get(case)?.number(range.parameter);
    let mut found = Robustness {
        parameter: range.parameter,
        title: range.title,
        ends: [value(0)?, value(range.cases.len().checked_sub(1)?)?],
        count: range.cases.len(),
        missed: 0,
        at: value(0)?,
        target: 0,
        error: 0.0,
    };
    let mut largest = 0.0;
    for case in 0..range.cases.len() {
        let metrics: Vec<Option<f64>> = table.row(case).collect();
        let errors = request.targets.iter().map(|t| t.error(&metrics));
        let quotients: Vec<f64> = errors
            .zip(&request.targets)
            .map(|(e, t)| e / t.limit)
            .collect();
        found.missed += usize::from(!quotients.iter().all(|quotient| *quotient <= 1.0));
        for (target, quotient) in quotients.into_iter().enumerate() {
            if quotient > largest {
                largest = quotient;
                found.at = value(case)?;
                found.target = target;
                found.error = quotient * request.targets[target].limit;
            }
        }
    }
    Some(found)
}
