//! Reductions in a figure: all of its metrics, over the same parameters, or none.

use crate::Reduction;
use crate::scope::Scope;
use slipgap_cases::alike::Groups;
use slipgap_problem::problem::Case;
use slipgap_problem::problem::numbers::parameter::Value;

/// The kinds of figure that show reductions.
pub const KINDS: [&str; 5] = ["metric", "convergence", "map", "scatter", "front"];

/// Why a figure that reduces its cases cannot show a parameter; `None` if it can.
pub fn hidden(
    reduction: &Reduction,
    row: usize,
    mut cases: impl Iterator<Item = Case>,
    scope: &Scope,
) -> Option<String> {
    let table = scope.problem.parameters();
    let name = &table[row].name;
    let names = reduction.over.iter().map(|row| &*table[*row].name);
    let over = names.collect::<Vec<_>>().join(", ");
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
    let mut groups = Groups::new(&reduction.kept);
    let mut first = Vec::new();
    let same = |case: Case| {
        let value = case.values[row];
        let (group, is_new) = groups.place(&case);
        if is_new {
            first.push(value);
        }
        Value::identical(first[group], value)
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
    let mut groups = reduction.map(|reduction| Groups::new(&reduction.kept));
    cases.filter(move |case| groups.as_mut().is_none_or(|groups| groups.place(case).1))
}
