//! Cases reduced to one for each group.

use super::{Groups, Reduction};
use crate::Study;
use slipgap_problem::problem::Case;
use slipgap_problem::problem::numbers::parameter::Value;

/// A case, or what the cases of a group share, with its metrics.
#[derive(Debug, Clone)]
pub struct CaseMetrics {
    /// The case.
    pub case: Case,
    /// In the order of the study's measures; `None` if undefined.
    pub metrics: Vec<Option<f64>>,
}

/// Receives a case and its metrics by their rows of the study's measures.
type TakeCase<'a> = dyn FnMut(&Case, &dyn Fn(usize) -> Option<f64>) + 'a;

/// One case for each group of the cases that `each` gives one by one, with the reductions among `shown`, which are rows of the
/// study's measures; `None` if none of these is a reduction. A parameter that is reduced over, or that differs in a group, has no
/// value.
pub fn reduced_cases(
    study: &Study,
    shown: &[usize],
    each: impl FnOnce(&mut TakeCase),
) -> Option<Vec<CaseMetrics>> {
    let reductions: Vec<(usize, &Reduction)> = shown
        .iter()
        .filter_map(|row| Some((*row, study.reduction(*row)?)))
        .collect();
    let (_, first) = reductions.first()?;
    let mut groups = Groups::new(reductions.iter().map(|(_, reduction)| *reduction).collect());
    let mut found: Vec<CaseMetrics> = Vec::new();
    let mut number = 0;
    each(&mut |case, value| {
        let (index, is_new) = groups.add(number, case, value);
        number += 1;
        if is_new {
            let mut case = case.clone();
            first.lost.iter().for_each(|row| case.values[*row] = None);
            found.push(CaseMetrics {
                case,
                metrics: vec![None; study.measures.len()],
            });
        }
        let values = found[index].case.values.iter_mut();
        for (shared, other) in values.zip(&case.values) {
            if !Value::identical(*shared, *other) {
                *shared = None;
            }
        }
    });
    for (which, (row, _)) in reductions.iter().enumerate() {
        for (reduced_case, reduced) in found.iter_mut().zip(groups.values(which)) {
            reduced_case.metrics[*row] = reduced.value;
        }
    }
    Some(found)
}
