//! Reductions in a figure: all of its metrics, over the same parameters, or none.

use super::checker::Checker;
use super::decoded_value::Values;
use super::keys::{Key, Takes};
use crate::ColumnRef;
use crate::Reduction;
use crate::faults::quoted;
use crate::scope::Scope;
use slipgap_solver::problem::Case;
use slipgap_solver::problem::numbers::parameter::Value;
use std::collections::{HashMap, HashSet};

/// The kinds of figure that show reductions.
pub const KINDS: [&str; 5] = ["metric", "convergence", "map", "scatter", "front"];

/// Reports reductions that a figure of `kind` with these keys cannot show, and other metrics next to them. It returns one of
/// the reductions, if there are any.
pub(super) fn check<'a>(
    kind: &str,
    keys: &'static [Key],
    checker: &mut Checker<'a>,
) -> Option<&'a Reduction> {
    let scope = checker.scope;
    let taken = metrics(keys, checker.values);
    let first = taken.iter().find_map(|(key, i, row)| {
        let measure = &scope.measures[*row];
        Some((*key, *i, &measure.name, measure.reduction.as_ref()?))
    });
    let (key, i, name, reduction) = first?;
    if !KINDS.contains(&kind) {
        let kinds = KINDS.join(", ");
        let message = format!(
            "{} is a reduction; kinds that show them: {kinds}",
            quoted(name)
        );
        checker.fault_of_item(key, i, message);
        return Some(reduction);
    }
    for (key, i, row) in taken {
        let other = &scope.measures[row];
        let own = &other.name;
        let message = match &other.reduction {
            // Faults of their own.
            Some(other) if other.over.is_empty() || reduction.over.is_empty() => continue,
            Some(other) if other.groups_like(reduction) => continue,
            Some(_) => format!(
                "{} and {} are over different parameters; a figure needs reductions over the same ones",
                quoted(own),
                quoted(name)
            ),
            None => format!(
                "{own} is not reduced, but {} is; a figure shows reductions only, or none",
                quoted(name)
            ),
        };
        checker.fault_of_item(key, i, message);
    }
    if checker.values.has("mean_over") {
        let message = "a figure of reductions has no further means; reduce both metrics over this parameter, too";
        checker.fault("mean_over", message);
    }
    Some(reduction)
}

/// The metrics under the keys of a figure: key, place in its list, and row of the measures.
fn metrics(keys: &'static [Key], values: &Values) -> Vec<(&'static str, usize, usize)> {
    let mut found = Vec::new();
    for key in keys {
        match key.takes {
            Takes::Metric | Takes::Metrics => {
                let rows = values.rows(key.name).unwrap_or_default();
                found.extend(rows.iter().enumerate().map(|(i, row)| (key.name, i, *row)));
            }
            Takes::Column => {
                if let Some(ColumnRef::Metric(row)) = values.column(key.name) {
                    found.push((key.name, 0, row));
                }
            }
            _ => {}
        }
    }
    found
}

/// Why a figure that reduces its cases cannot show a parameter; `None` if it can.
pub fn hidden(
    reduction: &Reduction,
    row: usize,
    mut cases: impl Iterator<Item = Case>,
    scope: &Scope,
) -> Option<String> {
    let table = scope.problem.parameters();
    let name = &table[row].name;
    let over = reduction.over.iter().map(|row| &*table[*row].name);
    let over = over.collect::<Vec<_>>().join(", ");
    if reduction.over.contains(&row) {
        return Some(format!("the metrics are reduced over {name}"));
    }
    let changes = || {
        Some(format!(
            "{name} changes with {over}, which the metrics are reduced over"
        ))
    };
    if reduction.lost.contains(&row) {
        return changes();
    }
    if scope.blocks.iter().any(|block| block.gives(row)) {
        return None;
    }
    // What the problem computes may be the same in the cases of each group.
    let mut found = HashMap::new();
    let same = |case: Case| {
        let own = case.values[row];
        let first = *found.entry(reduction.group(&case)).or_insert(own);
        Value::identical(first, own)
    };
    match cases.all(same) {
        true => None,
        false => changes(),
    }
}

/// One case of each group; all cases without a reduction.
pub fn one_of_each<'a>(
    reduction: Option<&'a Reduction>,
    cases: impl Iterator<Item = Case> + 'a,
) -> impl Iterator<Item = Case> + 'a {
    let mut seen = HashSet::new();
    cases.filter(move |case| reduction.is_none_or(|reduction| seen.insert(reduction.group(case))))
}
