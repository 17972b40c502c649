//! What the figures of ensembles share: the ensembles among the cases, their strokes, and the cases without a value.

use crate::DrawnCase;
use crate::label;
use slipgap_drawing::layout;
use slipgap_drawing::layout::legend::Key;
use slipgap_drawing::layout::sheet::Sheet;
use slipgap_drawing::style::{self, Look, Marker, Stroke};
use slipgap_drawing::text::markup;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_study::{Study, alike};

/// Most curves of a figure: as many as a reader can distinguish without markers.
pub const MOST_CURVES: usize = 6;

/// Most curves of a figure with bands: more bands on one another are not told apart.
pub const MOST_BANDS: usize = 3;

/// The cases of one curve.
#[derive(Debug, Clone)]
pub struct Ensemble<'a, 'c> {
    /// Its label in the legend; empty if there is no other curve.
    pub label: String,
    /// Its cases.
    pub cases: Vec<&'a DrawnCase<'c>>,
}

/// The ensembles of a figure, at most [`MOST_CURVES`], and the number of all: the cases of each value of `by`, or else of each set of
/// values of the parameters that vary and do not change with the ensemble or with `x`.
pub fn ensembles<'a, 'c>(
    study: &Study,
    cases: &'a [DrawnCase<'c>],
    by: Option<usize>,
    x: Option<usize>,
) -> (Vec<Ensemble<'a, 'c>>, usize) {
    let also: Vec<usize> = x.into_iter().collect();
    let outside = study.outside_ensemble(&also);
    let rows = by.map_or_else(|| outside.clone(), |row| vec![row]);
    let groups = alike::grouped(cases, |shown| shown.identity(&rows));
    let ensemble = |cases| Ensemble {
        label: String::new(),
        cases,
    };
    let mut found: Vec<Ensemble> = groups.into_iter().map(ensemble).collect();
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
    let count = found.len();
    found.truncate(MOST_CURVES);
    (found, count)
}

impl<'a, 'c> Ensemble<'a, 'c> {
    /// Its cases at each value of a parameter, by rising value.
    pub fn at_each(&self, x: usize) -> Vec<(f64, Vec<&'a DrawnCase<'c>>)> {
        let value = |shown: &DrawnCase| shown.value(x).filter(|value| value.as_f64().is_some());
        let cases = self.cases.iter().copied();
        let placed = cases.filter(|shown| value(shown).is_some());
        let groups = alike::grouped(placed, |shown| value(shown).map(Value::identity));
        let at = |cases: Vec<&'a DrawnCase<'c>>| Some((value(cases[0])?.as_f64()?, cases));
        let mut found: Vec<_> = groups.into_iter().filter_map(at).collect();
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        found
    }
}

/// The stroke of curve `i`; the first of black curves is unbroken.
pub fn stroke(look: Look, i: usize) -> Stroke {
    match i.checked_sub(1).filter(|_| !look.colour) {
        Some(before) => Stroke::of_case(before),
        None => look.stroke(i, 1),
    }
}

/// Keys of the curves with a label.
pub fn keys(look: Look, found: &[Ensemble], marker: impl Fn(usize) -> Option<Marker>) -> Vec<Key> {
    let key = |(k, ensemble): (usize, &Ensemble)| Key {
        label: ensemble.label.clone(),
        stroke: stroke(look, k),
        width: style::CASE_LINE,
        marker: marker(k),
    };
    let keys = found.iter().enumerate().map(key);
    keys.filter(|key| !key.label.is_empty()).collect()
}

/// Adds under a finished sheet how many cases have no value of a metric.
pub fn without_value(sheet: &mut Sheet, study: &Study, cases: &[DrawnCase], metrics: &[usize]) {
    for metric in metrics {
        let empty = cases.iter().filter(|shown| shown.metric(*metric).is_none());
        let (empty, count) = (empty.count(), cases.len());
        if empty > 0 {
            let name = markup::escape(&study.measures[*metric].name);
            let words = format!("Without {empty} of {count} cases, in which {name} is empty.");
            layout::small_print(sheet, &words);
        }
    }
}
