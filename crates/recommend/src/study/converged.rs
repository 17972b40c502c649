//! Whether a list of a chosen number, such as the stiffness of a contact, goes far enough: whether the metrics that others are compared
//! with still change from the value before the last to the last one.

use super::candidate::Choice;
use super::errors::{From, difference};
use super::judge::{Judge, all_of};
use super::reference_motion::{self, values};
use crate::calibrate::Stopped;
use slipgap_problem::problem::numbers::parameter::Value;
use std::collections::BTreeMap;

/// A chosen number with which a metric of the reference still changes by more than its tolerance.
#[derive(Debug, Clone, PartialEq)]
pub struct NotConverged {
    /// Row of the parameter.
    pub parameter: usize,
    /// The values of the last two candidates that differ only in it.
    pub values: [Value; 2],
    /// The place of the metric among those to keep: the one that changes most over its tolerance.
    pub metric: usize,
    /// The largest relative change over the physical cases.
    pub change: f64,
}

/// The numbers whose list ends too early; the candidates are in the order of the study. The finest one is the reference; of step and
/// mesh, the finest ones are the last.
pub(super) fn not_converged(
    choices: &[Choice],
    judge: &mut Judge,
) -> Result<Vec<NotConverged>, Stopped> {
    let Some(finest) = reference_motion::finest(choices, judge) else {
        return Ok(Vec::new());
    };
    let step = judge.study.problem.schema().step;
    let mut before: BTreeMap<usize, &Choice> = BTreeMap::new();
    for other in choices {
        let row = finest.differing(other).filter(|row| *row != step);
        if let Some(row) = row.filter(|_| other.size == finest.size && other.is_whole(judge)) {
            before.insert(row, other);
        }
    }
    let mut found = Vec::new();
    for (parameter, other) in before {
        let cases = all_of(&other.cases(judge, &[], &[]));
        let others = values(&cases, judge)?;
        let change = |metric: usize| {
            let changes = cases.iter().zip(&others).map(|(case, others)| {
                let of_case = judge.references.get(&judge.condition(case));
                let reference = of_case.and_then(|reference| reference[metric]);
                difference(others[metric], reference)
            });
            changes.fold(0.0, f64::max)
        };
        let tolerances = judge.recommend.within.iter().enumerate();
        let kept = tolerances.filter(|(metric, _)| judge.from[*metric] != From::Zero);
        let changes = kept.map(|(metric, within)| (metric, change(metric), within.1));
        let largest = changes.max_by(|a, b| (a.1 / a.2).total_cmp(&(b.1 / b.2)));
        let Some((metric, change, _)) = largest.filter(|entry| entry.1 > entry.2) else {
            continue;
        };
        let value = |choice: &Choice| choice.value(parameter);
        let pair = value(other).zip(value(finest));
        found.extend(pair.map(|(other, finest)| NotConverged {
            parameter,
            values: [other, finest],
            metric,
            change,
        }));
    }
    Ok(found)
}
