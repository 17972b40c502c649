//! What the figures of ensembles share: the ensembles among the cases, their strokes, and the cases without a value.

use crate::figures::DrawnCase;
use crate::figures::label;
use crate::figures::layout;
use crate::figures::layout::legend::Key;
use crate::figures::layout::sheet::Sheet;
use crate::figures::style::Stroke;
use crate::figures::text::markup;
use crate::study::{Study, alike};
use std::collections::HashMap;

/// Most curves of a figure: as many as a reader can distinguish without markers.
pub const MOST_CURVES: usize = 6;

/// The cases of one curve.
#[derive(Debug, Clone)]
pub struct Ensemble<'a, 'c> {
    /// Its label in the legend; empty if there is no other curve.
    pub label: String,
    /// Its cases.
    pub cases: Vec<&'a DrawnCase<'c>>,
}

/// The ensembles of a figure: the cases of each value of `by`, or else of each set of values of the parameters that vary
/// and do not change with the ensemble or with `x`.
pub fn ensembles<'a, 'c>(
    study: &Study,
    cases: &'a [DrawnCase<'c>],
    by: Option<usize>,
    x: Option<usize>,
) -> Vec<Ensemble<'a, 'c>> {
    let also: Vec<usize> = x.into_iter().collect();
    let outside = study.outside_ensemble(&also);
    let rows = by.map_or_else(|| outside.clone(), |row| vec![row]);
    let mut found: Vec<Ensemble> = Vec::new();
    let mut known = HashMap::new();
    for shown in cases {
        let identity = alike::identity(shown.case, &rows);
        let place = *known.entry(identity).or_insert_with(|| {
            found.push(Ensemble {
                label: String::new(),
                cases: Vec::new(),
            });
            found.len() - 1
        });
        found[place].cases.push(shown);
    }
    if found.len() > 1 {
        let table = study.problem.parameters();
        let except: Vec<usize> = (0..table.len())
            .filter(|row| !outside.contains(row))
            .collect();
        let firsts: Vec<DrawnCase> = found.iter().map(|of| *of.cases[0]).collect();
        let labels = label::labels(table, &firsts, by, &except);
        for (ensemble, label) in found.iter_mut().zip(labels) {
            ensemble.label = label;
        }
    }
    found
}

/// The value of a metric of a case.
pub fn value(shown: &DrawnCase, metric: usize) -> Option<f64> {
    shown.metrics.get(metric).copied().flatten()
}

/// The stroke of curve `i`.
pub fn stroke(i: usize) -> Stroke {
    i.checked_sub(1).map_or(Stroke::Solid, Stroke::of_case)
}

/// Keys of the curves with a label.
pub fn keys(keys: impl Iterator<Item = Key>) -> Vec<Key> {
    keys.filter(|key| !key.label.is_empty()).collect()
}

/// Adds under a finished sheet how many cases have no value of a metric.
pub fn without_value(sheet: &mut Sheet, study: &Study, cases: &[DrawnCase], metrics: &[usize]) {
    for metric in metrics {
        let empty = cases.iter().filter(|shown| value(shown, *metric).is_none());
        let (empty, all) = (empty.count(), cases.len());
        if empty > 0 {
            let name = markup::escape(&study.measures[*metric].name);
            let words = format!("Without {empty} of {all} cases, in which {name} is empty.");
            layout::small_print(sheet, &words);
        }
    }
}
