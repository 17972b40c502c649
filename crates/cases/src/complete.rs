//! The values that follow from the parameters of a case, and the rules that a case breaks.

use super::block::Block;
use crate::formulas::derived::Derived;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_problem::problem::{Case, Problem, Violation};

/// The relative round-off of a few operations, and some margin.
const AGREES: f64 = 1e-9;

impl Block {
    /// Fills in the values that follow from other parameters, and gives every rule that the case breaks.
    pub fn complete(&self, problem: &dyn Problem, case: &mut Case) -> Vec<Violation> {
        let without_value = Vec::from_iter(self.derived.iter().filter_map(|d| d.violation(case)));
        if !without_value.is_empty() {
            // The problem would fill in values that the study does not give.
            return without_value;
        }
        let restated = self.derived.iter().filter(|derived| derived.restates);
        let taken = restated.map(|derived| (derived, case.values[derived.parameter].take()));
        let given: Vec<(&Derived, Option<Value>)> = taken.collect();
        let mut violations = problem.complete(case);
        for (derived, given) in given {
            let follows = case.at(derived.parameter);
            if let (Some(given), Some(follows)) = (given.and_then(Value::as_f64), follows)
                && (given - follows).abs() > AGREES * follows.abs()
            {
                violations.push(Violation {
                    parameter: case.schema.parameters[derived.parameter].name.clone(),
                    message: format!(
                        "gives {given}, but {follows} follows from the other parameters"
                    ),
                    at: None,
                });
            }
        }
        violations
    }

    /// Combination `raw` as a completed case. `Study::columns` reports the rules that it breaks.
    pub fn completed(&self, problem: &dyn Problem, raw: u64) -> Case {
        let mut case = self.raw_case(problem, raw);
        let _ = self.complete(problem, &mut case);
        case
    }
}
