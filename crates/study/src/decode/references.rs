//! Which parameters the expressions of a block refer to.

use crate::axes::draft::{BlockDraft, ParameterDraft};
use crate::source::faults::{Faults, quoted};
use slipgap_problem::problem::Problem;
use slipgap_problem::problem::expression::Formula;
use slipgap_problem::problem::numbers::parameter::{Default, Parameter};
use slipgap_problem::problem::table::schema::Text;

/// Reports the parameters of a formula that have no value in the block; false if there are any. `at` and `path` are the
/// place of the formula.
pub(super) fn check_given(
    draft: &BlockDraft,
    (formula, text): (&Formula, &str),
    (at, path): (usize, &str),
    table: &[Parameter],
    faults: &mut Faults,
) -> bool {
    let mut resolved = true;
    for &row in formula.uses() {
        if draft.get(row).is_some() || matches!(table[row].default, Default::Is(_)) {
            continue;
        }
        resolved = false;
        if !draft.faulty.contains(&row) {
            let name = &table[row].name;
            let message = format!("{}: {name} is not given in this block", quoted(text));
            faults.add(at, path, message);
        }
    }
    resolved
}

/// Whether the expression of a parameter depends on its alternative, from which the problem computes the parameter.
pub(super) fn restates(draft: &BlockDraft, given: &ParameterDraft, problem: &dyn Problem) -> bool {
    let table = problem.parameters();
    let name = &table[given.parameter].name;
    let with_name = |pair: &&[Text; 2]| pair.contains(name);
    let Some(pair) = problem.schema().alternatives.iter().find(with_name) else {
        return false;
    };
    let (mut seen, mut next) = (Vec::new(), vec![given.parameter]);
    while let Some(row) = next.pop() {
        let formula = draft.get(row).and_then(|given| given.formula.as_ref());
        for row in formula.iter().flat_map(|(formula, _)| formula.uses()) {
            if table[*row].name != *name && pair.contains(&table[*row].name) {
                return true;
            }
            if !seen.contains(row) {
                seen.push(*row);
                next.push(*row);
            }
        }
    }
    false
}

/// Reports a circular reference among the `unresolved` parameters, each of which refers to another of them.
pub(super) fn report_circle(
    draft: &BlockDraft,
    unresolved: &[&ParameterDraft],
    table: &[Parameter],
    faults: &mut Faults,
) {
    let next = |row: usize| {
        let given = unresolved.iter().find(|given| given.parameter == row)?;
        let (formula, _) = given.formula.as_ref()?;
        let mut uses = formula.uses().iter().copied();
        uses.find(|row| unresolved.iter().any(|other| other.parameter == *row))
    };
    // Every chain of references leads into a circle; the first row met twice is on it.
    let mut chain: Vec<usize> = unresolved.iter().take(1).map(|g| g.parameter).collect();
    while let Some(row) = chain.last().and_then(|row| next(*row)) {
        if let Some(start) = chain.iter().position(|earlier| *earlier == row) {
            chain.drain(..start);
            chain.push(row);
            break;
        }
        chain.push(row);
    }
    let names: Vec<&str> = chain.iter().map(|row| &*table[*row].name).collect();
    if let Some(given) = chain.first().and_then(|row| draft.get(*row)) {
        let message = format!("circular reference: {}", names.join(" -> "));
        faults.add(given.at, &given.path, message);
    }
}
