//! Cases reduced to one for each group.

use super::Outcome;
use slipgap_solver::problem::Case;
use slipgap_solver::problem::numbers::parameter::Value;
use slipgap_study::{Groups, Reduction, Study};

/// Receives a case and its metrics by their rows of the study's measures.
pub type TakeCase<'a> = dyn FnMut(&Case, &dyn Fn(usize) -> Option<f64>) + 'a;

/// One outcome for each group of the cases that `each` gives one by one, with the reductions among `shown`, which are rows of the
/// study's measures; `None` if none of these is a reduction. A parameter that is reduced over, or that differs in a group, has no
/// value.
pub fn reduced(
    study: &Study,
    shown: &[usize],
    each: impl FnOnce(&mut TakeCase),
) -> Option<Vec<Outcome>> {
    let reductions = shown
        .iter()
        .filter_map(|row| Some((*row, study.reduction(*row)?)));
    let reductions: Vec<(usize, &Reduction)> = reductions.collect();
    let (_, first) = reductions.first()?;
    let mut groups = Groups::new(reductions.iter().map(|(_, reduction)| *reduction).collect());
    let mut found: Vec<Outcome> = Vec::new();
    let mut number = 0;
    each(&mut |case, value| {
        let (place, is_new) = groups.add(number, case, value);
        number += 1;
        if is_new {
            let mut case = case.clone();
            first.lost.iter().for_each(|row| case.values[*row] = None);
            found.push(Outcome {
                case,
                metrics: vec![None; study.measures.len()],
                solution: None,
                failure: None,
            });
        }
        let values = found[place].case.values.iter_mut();
        for (own, other) in values.zip(&case.values) {
            if !Value::identical(*own, *other) {
                *own = None;
            }
        }
    });
    for (which, (row, _)) in reductions.iter().enumerate() {
        for (outcome, reduced) in found.iter_mut().zip(groups.values(which)) {
            outcome.metrics[*row] = reduced.value;
        }
    }
    Some(found)
}
