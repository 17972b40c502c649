//! What the figures of ensembles share: the ensembles among the cases, their strokes, and the cases without a value.

use crate::DrawnCase;
use crate::label;
use slipgap_drawing::layout;
use slipgap_drawing::layout::axis::Axis;
use slipgap_drawing::layout::legend::Key;
use slipgap_drawing::layout::sheet::{Panel, Series, Sheet};
use slipgap_drawing::style::{self, Look, Marker, Stroke};
use slipgap_drawing::text::markup;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_study::{Study, alike};

/// Most curves of a figure: as many as a reader can distinguish without markers.
pub const MOST_CURVES: usize = 6;

/// Most curves of a figure with bands: three on one another have one mixed colour.
pub const MOST_BANDS: usize = 2;

/// Most points of a curve with the bar of its interval.
const MOST_BARS: usize = 12;

/// Distance of the bars of two curves at one place.
const BESIDE: f64 = 2.5;

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

/// Adds the intervals of curve `k` of `count` as bars, upright or level, next to those of the others at the same place.
pub fn bars(panel: &mut Panel, ends: &[[[f64; 2]; 2]], stroke: Stroke, [k, count]: [usize; 2]) {
    let off = BESIDE * (k as f64 - (count - 1) as f64 / 2.0);
    let moved = |axis: &Axis, x: f64, length: f64| axis.value(axis.fraction(x) + off / length);
    let bar = |[a, b]: &[[f64; 2]; 2]| {
        let place = |[x, y]: [f64; 2]| match a[0] == b[0] {
            true => [moved(&panel.x, x, panel.frame.width), y],
            false => [x, moved(&panel.y, y, panel.frame.height)],
        };
        [*a, *b].map(place)
    };
    let every = ends.len().div_ceil(MOST_BARS).max(1);
    let shown = ends.iter().step_by(every);
    let known = shown.filter(|ends| ends.as_flattened().iter().all(|x| x.is_finite()));
    let rules = Vec::from_iter(known.map(bar));
    // A short bar has no dashes.
    let stroke = match stroke.pattern() {
        [] => stroke,
        _ => Stroke::Solid,
    };
    panel.series.extend(rules.into_iter().map(|ends| Series {
        stroke,
        width: style::EXACT_LINE,
        ..Series::rule(ends)
    }));
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
