//! The number of cases, and the rules across the parameters of a case, tested before a run.

use crate::Block;
use crate::axes::draft::BlockDraft;
use crate::source::faults::Faults;
use slipgap_cases::representative::{MOST_TESTED, all_positions, ends, restricted};
use slipgap_problem::problem::{Case, Problem, Violation};
use std::collections::HashSet;

/// Most raw combinations of a study, if the command line sets no other limit.
pub const MOST_CASES: u64 = 1_000_000_000;

/// Most faults reported of the rules of a block. A long axis would repeat one a million times.
const MOST_REPORTED: usize = 100;

/// Refuses more combinations than `limit`, without making any; false if there are too many.
pub(super) fn within_limit(
    drafts: &[BlockDraft],
    limit: u64,
    at: usize,
    path: &str,
    faults: &mut Faults,
) -> bool {
    let group = |draft: &BlockDraft, members: &[usize]| {
        let first = members.first().map(|i| &draft.parameters[*i]);
        match (first, &draft.design) {
            (Some(first), Some(design)) if first.interval.is_some() => u128::from(design.points()),
            (Some(first), _) => first.values.len() as u128,
            (None, _) => 1,
        }
    };
    let block = |draft: &BlockDraft| {
        let groups = draft.groups();
        let mut lens = groups.iter().map(|members| group(draft, members));
        lens.try_fold(1u128, u128::checked_mul)
    };
    let total = drafts
        .iter()
        .map(block)
        .try_fold(0u128, |sum, cases| sum.checked_add(cases?));
    let count = match total {
        Some(total) if total <= u128::from(limit) => return true,
        Some(total) => total.to_string(),
        None => "more than 10^38".into(),
    };
    let message = format!("{count} cases; allowed: at most {limit}; --limit sets another limit");
    faults.add(at, path, message);
    false
}

/// Reports every rule of the problem that a case of the block breaks, at the value that breaks it.
pub(crate) fn validate(
    problem: &dyn Problem,
    draft: &BlockDraft,
    block: &Block,
    faults: &mut Faults,
) {
    if block.is_independent() {
        let at_ends = restricted(block, &ends(block));
        if violations(problem, draft, &at_ends).next().is_none() {
            return;
        }
    }
    let positions = positions(block);
    let part = restricted(block, &positions);
    let groups = draft.groups();
    let mut reported = HashSet::new();
    for (raw, violations) in violations(problem, draft, &part) {
        for violation in violations {
            let (at, path) = place(problem, draft, &groups, &positions, raw, &violation);
            if reported.insert((at, violation.message.clone())) {
                faults.add(at, &path, violation.message);
            }
        }
        if reported.len() >= MOST_REPORTED {
            return;
        }
    }
}

/// Whether a case of the block breaks no rule: of candidates, those that break one have no solution.
pub(super) fn has_good_case(problem: &dyn Problem, block: &Block) -> bool {
    let part = restricted(block, &positions(block));
    let mut case = Case::new(problem.schema());
    let mut raws = 0..part.raw_len().min(MOST_TESTED);
    raws.any(|raw| {
        part.put_and_test(problem, raw, &mut case) == Some(true)
            && part.complete(problem, &mut case).is_empty()
    })
}

/// The positions that are tested: all, of a large block the ends.
fn positions(block: &Block) -> Vec<Vec<usize>> {
    match block.raw_len() <= MOST_TESTED {
        true => all_positions(block),
        false => ends(block),
    }
}

/// Offset and path of the value at which a violation of combination `raw` is reported. `positions` are those of the
/// tested part of the block.
fn place(
    problem: &dyn Problem,
    draft: &BlockDraft,
    groups: &[Vec<usize>],
    positions: &[Vec<usize>],
    raw: u64,
    violation: &Violation,
) -> (usize, String) {
    if let Some(at) = violation.at {
        return (at, violation.parameter.to_string());
    }
    let row = row_of(problem, violation);
    let Some(i) = draft
        .parameters
        .iter()
        .position(|g| Some(g.parameter) == row)
    else {
        return (draft.at, format!("{}.{}", draft.path, violation.parameter));
    };
    let given = &draft.parameters[i];
    let Some(group) = groups.iter().position(|members| members.contains(&i)) else {
        return (given.at, given.path.clone());
    };
    let len = |group: &Vec<usize>| group.len() as u64;
    let stride: u64 = positions[group + 1..].iter().map(len).product();
    let position = positions[group][(raw / stride % len(&positions[group])) as usize];
    let path = match given.list {
        true => format!("{}[{position}]", given.path),
        false => given.path.clone(),
    };
    let at = given.places.get(position).copied().unwrap_or(given.at);
    (at, path)
}

fn row_of(problem: &dyn Problem, violation: &Violation) -> Option<usize> {
    let mut table = problem.parameters().iter();
    table.position(|p| p.name == violation.parameter)
}

/// The cases of a block that break rules, by their combinations. Violations that only follow from a faulty parameter are
/// left out.
fn violations(
    problem: &dyn Problem,
    draft: &BlockDraft,
    block: &Block,
) -> impl Iterator<Item = (u64, Vec<Violation>)> {
    let mut case = Case::new(problem.schema());
    let raws = 0..block.raw_len().min(MOST_TESTED);
    let cases = raws.filter(|raw| block.is_case(problem, *raw));
    let violations = cases.map(move |raw| {
        block.put(problem, raw, &mut case);
        for row in &draft.faulty {
            case.values[*row] = None;
        }
        let mut violations = block.complete(problem, &mut case);
        violations.retain(|violation| {
            let row = row_of(problem, violation);
            let reported = row.is_some_and(|row| draft.faulty.contains(&row));
            // The faulty parameter may be the alternative that is missing, one in an expression of the structure, or decide
            // whether one in the expression of a parameter has a value.
            let missing = lacks_alternative(&case, violation)
                || violation.at.is_some()
                || row.is_some_and(|row| lacks_a_value(draft, row, &case));
            !reported && (draft.faulty.is_empty() || !missing)
        });
        (raw, violations)
    });
    violations.filter(|(_, violations)| !violations.is_empty())
}

/// Whether a parameter is an expression with a parameter that has no value.
fn lacks_a_value(draft: &BlockDraft, row: usize, case: &Case) -> bool {
    let formula = draft.get(row).and_then(|given| given.formula.as_ref());
    let mut uses = formula.iter().flat_map(|(formula, _)| formula.uses());
    uses.any(|row| case.values[*row].is_none())
}

/// Whether a violation is at a parameter of which the alternative has no value either.
fn lacks_alternative(case: &Case, violation: &Violation) -> bool {
    let mut pairs = case.schema.alternatives.iter();
    pairs
        .find(|pair| pair.contains(&violation.parameter))
        .is_some_and(|pair| pair.iter().all(|name| case.get(name).is_none()))
}
