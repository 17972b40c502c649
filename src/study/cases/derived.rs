//! Parameters given by expressions of others, and conditions: computed once for each distinct set of what they depend on.

use super::block::Block;
use crate::problem::parameter::{Kind, Parameter, Value, shortest};
use crate::problem::{Case, Problem, Schema, Violation};
use crate::study::expression::{ExpressionFault, Formula};
use crate::study::source::faults::quoted;
use std::sync::Arc;

/// Most values that are kept; beyond, an expression depends on so much that hardly any two cases share a value.
const MOST_KEPT: u64 = 1 << 20;

/// Round-off of a few operations, with room.
const AGREES: f64 = 1e-9;

/// Nearer than this, relatively, to a whole number counts as that: 10/0.1 is 100.
const WHOLE: f64 = 1e-9;

/// A parameter that an expression gives.
#[derive(Debug, Clone)]
pub struct Derived {
    /// Row of `problem.parameters()`.
    pub parameter: usize,
    /// The expression as it was written.
    pub text: String,
    /// Whether it names the parameter that it would follow from by itself, as in `"k_I": "gamma * n * E * A / L"`: then it
    /// says what the problem knows, and must agree.
    pub restates: bool,
    pub(in crate::study) rule: Rule,
}

/// What combinations must meet.
#[derive(Debug, Clone)]
pub struct Condition {
    pub(in crate::study) rule: Rule,
}

/// An expression with the groups that it depends on, and its values for all their combinations.
#[derive(Debug, Clone)]
pub(in crate::study) struct Rule {
    pub formula: Formula,
    /// Groups, rising.
    pub on: Vec<usize>,
    /// By the places of these groups, the last one fastest.
    pub table: Option<Vec<f64>>,
}

impl Rule {
    pub fn new(formula: Formula, block: &Block) -> Rule {
        let mut on = Vec::new();
        let mut rows = formula.uses().to_vec();
        while let Some(row) = rows.pop() {
            let holds = |axes: &[crate::study::Axis]| axes.iter().any(|axis| axis.parameter == row);
            if let Some(group) = block.groups.iter().position(|g| holds(&g.axes)) {
                on.push(group);
            }
            if let Some(derived) = block.derived.iter().find(|d| d.parameter == row) {
                on.extend(&derived.rule.on);
            }
        }
        on.sort_unstable();
        on.dedup();
        Rule {
            formula,
            on,
            table: None,
        }
    }

    /// Number of different sets of what it depends on.
    pub fn sets(&self, block: &Block) -> u64 {
        let lens = self.on.iter().map(|group| block.groups[*group].len());
        lens.fold(1, u64::saturating_mul)
    }

    /// Computes the table, if it is not too large.
    ///
    /// # Errors
    /// A case of the first set that has no value, and why.
    pub fn tabulate(
        &mut self,
        block: &Block,
        schema: &Arc<Schema>,
    ) -> Result<(), (Case, ExpressionFault)> {
        if self.sets(block) > MOST_KEPT {
            return Ok(());
        }
        let mut values = Vec::new();
        for set in 0..self.sets(block) {
            let case = self.case(block, set, schema);
            match self.formula.value(&|row| case.values[row]) {
                Ok(value) => values.push(value),
                Err(fault) => return Err((case, fault)),
            }
        }
        self.table = Some(values);
        Ok(())
    }

    /// A case with what the formula depends on, in its set of that number.
    pub fn case(&self, block: &Block, set: u64, schema: &Arc<Schema>) -> Case {
        let mut digits = vec![0; block.groups.len()];
        let mut rest = set;
        for &group in self.on.iter().rev() {
            digits[group] = rest % block.groups[group].len();
            rest /= block.groups[group].len();
        }
        let mut case = Case::new(schema);
        block.fill(&mut case, &digits, block.derived.len());
        case
    }

    fn kept(&self, block: &Block, digits: &[u64]) -> Option<f64> {
        let place = |place: u64, group: &usize| place * block.groups[*group].len() + digits[*group];
        let set = self.on.iter().fold(0, place);
        self.table.as_ref()?.get(set as usize).copied()
    }

    fn value(&self, block: &Block, case: &Case, digits: &[u64]) -> Option<f64> {
        self.kept(block, digits)
            .or_else(|| self.formula.value(&|row| case.values[row]).ok())
    }
}

impl Derived {
    /// The value for a case that has all it depends on.
    pub(in crate::study) fn value(
        &self,
        block: &Block,
        case: &Case,
        digits: &[u64],
    ) -> Option<Value> {
        let x = self.rule.value(block, case, digits)?;
        fitted(x, &case.schema.parameters[self.parameter]).ok()
    }

    /// The rule that a case breaks for which the expression gives no value of its parameter.
    fn violation(&self, case: &Case) -> Option<Violation> {
        if case.values[self.parameter].is_some() {
            return None;
        }
        let parameter = &case.schema.parameters[self.parameter];
        let message = refused(&self.rule.formula, &self.text, case, parameter)?;
        Some(Violation {
            parameter: parameter.name.clone(),
            message,
        })
    }
}

/// Why an expression gives no value of a parameter, if it gives none.
pub(in crate::study) fn refused(
    formula: &Formula,
    text: &str,
    case: &Case,
    parameter: &Parameter,
) -> Option<String> {
    let x = match formula.value(&|row| case.values[row]) {
        Ok(x) => x,
        Err(fault) => return Some(worked_out(formula, text, case, &fault)),
    };
    let allowed = fitted(x, parameter).err()?;
    let (x, with) = (shortest(x), with(formula, case));
    let text = quoted(text);
    Some(format!("must be {allowed}, got {text} = {x}{with}"))
}

/// What is wrong with an expression for a case.
pub(in crate::study) fn worked_out(
    formula: &Formula,
    text: &str,
    case: &Case,
    fault: &ExpressionFault,
) -> String {
    format!("{}{}: {}", quoted(text), with(formula, case), fault.message)
}

/// The values that a formula worked with, as ` with n = 3, L = 10`.
fn with(formula: &Formula, case: &Case) -> String {
    let told = formula.uses().iter().filter_map(|row| {
        let value: Value = case.values[*row]?;
        Some(format!("{} = {value}", case.schema.parameters[*row].name))
    });
    format!(" with {}", told.collect::<Vec<_>>().join(", "))
}

impl Condition {
    /// Whether it is met, if that is known without a case.
    pub(in crate::study) fn tabled(&self, block: &Block, digits: &[u64]) -> Option<bool> {
        self.rule.kept(block, digits).map(|x| x != 0.0)
    }

    /// Whether a case meets it; `None` where it has no value.
    pub(in crate::study) fn holds(
        &self,
        block: &Block,
        case: &Case,
        digits: &[u64],
    ) -> Option<bool> {
        self.rule.value(block, case, digits).map(|x| x == 1.0)
    }
}

impl Block {
    /// Fills in what follows from a case's parameters, and names every rule that it breaks.
    pub(in crate::study) fn complete(
        &self,
        problem: &dyn Problem,
        case: &mut Case,
    ) -> Vec<Violation> {
        let without = self.derived.iter().filter_map(|d| d.violation(case));
        let without: Vec<Violation> = without.collect();
        if !without.is_empty() {
            // What the problem fills in for a missing value is not what the study gives.
            return without;
        }
        let restated = self.derived.iter().filter(|derived| derived.restates);
        let aside = restated.map(|derived| (derived, case.values[derived.parameter].take()));
        let aside: Vec<(&Derived, Option<Value>)> = aside.collect();
        let mut violations = problem.complete(case);
        for (derived, said) in aside {
            let name = case.schema.parameters[derived.parameter].name.clone();
            let both = (said.and_then(Value::as_f64), case.number(&name));
            if let (Some(said), Some(follows)) = both
                && (said - follows).abs() > AGREES * follows.abs()
            {
                let message =
                    format!("gives {said}, but {follows} follows from the other parameters");
                violations.push(Violation {
                    parameter: name,
                    message,
                });
            }
        }
        violations
    }
}

/// A number as a value of a parameter, or what it must be.
pub(in crate::study) fn fitted(x: f64, parameter: &Parameter) -> Result<Value, String> {
    match parameter.kind {
        Kind::Number(range) if range.contains(x) => Ok(Value::Number(x)),
        Kind::Number(range) => Err(range.to_string()),
        Kind::Whole { min, max } => {
            let whole = x.round();
            let near = (x - whole).abs() <= WHOLE * whole.abs();
            if near && whole >= min as f64 && whole <= max as f64 {
                return Ok(Value::Whole(whole as u64));
            }
            Err(format!("a whole number from {min} to {max}"))
        }
        Kind::Choice(_) => Err("a name".into()),
    }
}
