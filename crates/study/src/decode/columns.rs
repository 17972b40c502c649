//! Which metrics a study computes, and which of them are columns.

use crate::cases::scope::Scope;
use crate::computed::{self, decode::Listed};
use crate::measure;
use crate::{Check, Figure};

/// The metrics that are computed, in the order of the table: those that are default, that the study lists or reduces, that a
/// figure or check needs, and what other metrics are computed from. Then the columns of results.csv: not what the study names only in
/// arithmetic.
pub(super) fn columns(
    scope: &Scope,
    listed: &Listed,
    figures: &[Figure],
    checks: &[Check],
) -> (Vec<usize>, Vec<usize>) {
    let (problem, measures) = (&*scope.problem, &scope.measures);
    let shown = |figure: &Figure| figure.kind.decoded().measures(problem);
    let drawn = figures.iter().flat_map(shown);
    let checked = checks.iter().map(|check| check.metric);
    let rows = measures.iter().enumerate();
    let reduced = rows.filter_map(|(row, measure)| Some([row, measure.reduction.as_ref()?.of]));
    let given = listed.named.iter().copied().chain(checked);
    let named: Vec<usize> = given.chain(reduced.flatten()).chain(drawn).collect();
    let count = problem.parameters().len();
    let all_of = |row: &usize| computed::metrics_of(measures, *row, count);
    let needed: Vec<usize> = named
        .iter()
        .chain(&listed.columns)
        .flat_map(all_of)
        .collect();
    let of_named = named.iter().filter_map(|row| measures[*row].metric);
    let named_metrics: Vec<usize> = of_named.collect();
    let parts: Vec<usize> = listed.columns.iter().flat_map(all_of).collect();
    let described = problem.schema().described;
    let metric_rows = problem.metrics().iter().enumerate();
    let metrics: Vec<usize> = metric_rows
        .filter(|(row, metric)| metric.default || needed.contains(row))
        .map(|(row, _)| row)
        .collect();
    let is_part = |row: &usize| {
        let usual = problem.metrics()[*row].default && !described;
        parts.contains(row) && !named_metrics.contains(row) && !usual
    };
    let shown: Vec<usize> = metrics
        .iter()
        .copied()
        .filter(|row| !is_part(row))
        .collect();
    let mut columns = measure::columns(measures, &shown);
    columns.extend(&listed.columns);
    (metrics, columns)
}
