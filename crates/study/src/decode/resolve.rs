//! From the draft of a block to the block: expressions in the order of their references, and the condition.

use super::references::{check_given, report_circle, restates};
use crate::Block;
use crate::axes::draft::{BlockDraft, ParameterDraft};
use crate::source::faults::{Faults, quoted};
use slipgap_cases::formulas::derived::{Condition, Derived, refused};
use slipgap_cases::formulas::formula_table::FormulaTable;
use slipgap_problem::problem::expression::{ExpressionFault, Formula};
use slipgap_problem::problem::numbers::allowed::value_of;
use slipgap_problem::problem::{Case, NotComputed, Problem, Schema};
use std::sync::Arc;

/// The block of a draft; `None` if an expression has a fault or refers to a faulty parameter.
pub(crate) fn resolve(
    draft: &BlockDraft,
    problem: &dyn Problem,
    faults: &mut Faults,
) -> Option<Block> {
    let table = problem.parameters();
    let mut block = Block::of(draft.axes());
    block.design = draft.design.clone();
    let before = faults.count();
    let mut unresolved: Vec<&ParameterDraft> = Vec::new();
    let mut all_given = true;
    for given in &draft.parameters {
        if let Some((formula, text)) = &given.formula {
            let origin = (given.at, given.path.as_str());
            all_given &= check_given(draft, (formula, text), origin, table, faults);
            unresolved.push(given);
        }
    }
    if !all_given {
        return None;
    }
    while !unresolved.is_empty() {
        let is_ready = |given: &&ParameterDraft| {
            let mut uses = given.formula.iter().flat_map(|(formula, _)| formula.uses());
            uses.all(|row| unresolved.iter().all(|other| other.parameter != *row))
        };
        let Some(ready) = unresolved.iter().position(is_ready) else {
            report_circle(draft, &unresolved, table, faults);
            return None;
        };
        let given = unresolved.remove(ready);
        if let Some(formula) = &given.formula {
            let restates = restates(draft, given, problem);
            derive(
                &mut block,
                given,
                formula,
                restates,
                problem.schema(),
                &draft.faulty,
                faults,
            );
        }
    }
    if let Some((formula, at, text)) = &draft.when {
        let path = match draft.path.strip_suffix("parameters") {
            Some(path) => format!("{path}when"),
            None => "when".into(),
        };
        if !check_given(draft, (formula, text), (*at, &path), table, faults) {
            return None;
        }
        match add_condition(&mut block, formula, text, problem) {
            Err(Unmet::NoValue(case, _))
                if !draft.faulty.is_empty() && lacks_a_value(formula, &case) =>
            {
                return None;
            }
            Err(unmet) => faults.add(*at, &path, unmet.message(formula, text)),
            Ok(()) => {}
        }
    }
    block.collapse(problem);
    (faults.count() == before).then_some(block)
}

/// Whether a parameter of a formula has no value in a case.
fn lacks_a_value(formula: &Formula, case: &Case) -> bool {
    formula.uses().iter().any(|row| case.values[*row].is_none())
}

/// Why a condition cannot be used.
enum Unmet {
    /// It has no value for this case.
    NoValue(Box<Case>, ExpressionFault),
    /// No combination meets it.
    Never,
}

impl Unmet {
    fn message(self, formula: &Formula, text: &str) -> String {
        match self {
            Unmet::NoValue(case, fault) => {
                NotComputed::new(formula, text, &case, fault).to_string()
            }
            Unmet::Never => format!("{}: no combination meets it", quoted(text)),
        }
    }
}

/// Adds the condition of a block.
///
/// # Errors
/// The condition has no value for a case, or no case meets it. A block of very many combinations is not tested.
fn add_condition(
    block: &mut Block,
    formula: &Formula,
    text: &str,
    problem: &dyn Problem,
) -> Result<(), Unmet> {
    let mut formula_table = FormulaTable::new(formula.clone(), block);
    if let Err((case, fault)) = formula_table.fill(block, problem.schema()) {
        return Err(Unmet::NoValue(case, fault));
    }
    block.when = Some(Condition {
        text: text.to_owned(),
        formula: formula_table,
    });
    if block.is_uncounted() {
        return Ok(());
    }
    if let Some(raw) = block.undecided(problem) {
        let case = block.raw_case(problem, raw);
        return match formula.value(&|row| case.values[row]) {
            Ok(_) => Ok(()),
            Err(fault) => Err(Unmet::NoValue(Box::new(case), fault)),
        };
    }
    match block.len(problem) {
        0 => Err(Unmet::Never),
        _ => Ok(()),
    }
}

/// Adds a derived parameter. Its first invalid value is a fault.
fn derive(
    block: &mut Block,
    given: &ParameterDraft,
    (formula, text): &(Formula, String),
    restates: bool,
    schema: &Arc<Schema>,
    faulty: &[usize],
    faults: &mut Faults,
) {
    let mut formula_table = FormulaTable::new(formula.clone(), block);
    let parameter = &schema.parameters[given.parameter];
    let invalid = match formula_table.fill(block, schema) {
        Err((case, _)) => Some(*case),
        Ok(()) => {
            let mut values = formula_table.table.iter().flatten();
            let invalid = values.position(|x| value_of(*x, parameter).is_err());
            invalid.map(|entry| formula_table.case(block, entry as u64, schema))
        }
    };
    // A faulty parameter may decide which other ones have a value, and is reported itself.
    let follows = |case: &Case| !faulty.is_empty() && lacks_a_value(formula, case);
    let invalid = invalid.filter(|case| !follows(case));
    if let Some(message) = invalid.and_then(|case| refused(formula, text, &case, parameter)) {
        faults.add(given.at, &given.path, message);
    }
    block.derived.push(Derived {
        parameter: given.parameter,
        text: text.to_owned(),
        restates,
        formula: formula_table,
    });
}
