//! Metrics that are computed from others after the cases: arithmetic, as in `max(a3 - a2)/h`, and ratios to a reference case, as
//! in `peak(gap.S) relative to gamma = 1`.

pub(super) mod decode;
mod formula;
pub mod reference_case;
pub(super) mod sources;
#[cfg(test)]
mod tests;

pub use reference_case::Reference;

use super::{Measure, Study};
use slipgap_problem::problem::Case;
use slipgap_problem::problem::expression::Formula;
use slipgap_problem::problem::numbers::parameter::Value;

/// How a metric is computed from others.
#[derive(Debug, Clone)]
pub struct Computed {
    /// The rule.
    pub rule: Rule,
    /// Whether it needs all cases of the study: it is a ratio, or an expression of one.
    pub late: bool,
}

/// A rule for the value of a case.
#[derive(Debug, Clone)]
pub enum Rule {
    /// Arithmetic. Row i of its table is parameter i of the problem, or behind the parameters measure i of the study.
    Formula(Formula),
    /// The measure in this row over that of the reference case.
    Ratio(usize, Reference),
}

impl Computed {
    /// The value of a formula in a case whose measures `value` gives by their rows; `None` if it is undefined, and for a ratio.
    pub fn value(&self, case: &Case, value: &dyn Fn(usize) -> Option<f64>) -> Option<f64> {
        let Rule::Formula(formula) = &self.rule else {
            return None;
        };
        let count = case.values.len();
        let of = |row: usize| match row.checked_sub(count) {
            None => case.values[row],
            Some(measure) => value(measure).map(Value::Number),
        };
        formula.value(&of).ok()
    }

    /// Whether its arithmetic contains the parameter in this row.
    pub fn contains(&self, parameter: usize) -> bool {
        match &self.rule {
            Rule::Formula(formula) => formula.uses().contains(&parameter),
            Rule::Ratio(..) => false,
        }
    }

    /// Rows of the measures that it is computed from; `parameters` is the number of parameters of the problem.
    pub fn uses(&self, parameters: usize) -> Vec<usize> {
        match &self.rule {
            Rule::Ratio(of, _) => vec![*of],
            Rule::Formula(formula) => {
                let rows = formula.uses().iter();
                rows.filter_map(|row| row.checked_sub(parameters)).collect()
            }
        }
    }
}

/// The rows of `problem.metrics()` that a measure is made of.
pub(super) fn metrics_of(measures: &[Measure], row: usize, parameters: usize) -> Vec<usize> {
    let measure = &measures[row];
    let of_measure = measure.metric.into_iter();
    let formulas = measure.computed.iter();
    let used = formulas.flat_map(|computed| computed.uses(parameters));
    let reduced = measure.reduction.iter().map(|reduction| reduction.of);
    // A measure is computed from earlier ones.
    let parts = used.chain(reduced).filter(|part| *part < row);
    of_measure
        .chain(parts.flat_map(|part| metrics_of(measures, part, parameters)))
        .collect()
}

impl Study {
    /// The measures that are computed from others, with their rows, each behind those that it is computed from.
    pub fn computed(&self) -> impl Iterator<Item = (usize, &Measure, &Computed)> {
        let measures = self.measures.iter().enumerate();
        measures.filter_map(|(row, measure)| Some((row, measure, measure.computed.as_ref()?)))
    }

    /// Whether a measure needs all cases of the study.
    pub fn has_ratios(&self) -> bool {
        self.computed().any(|(_, _, computed)| computed.late)
    }
}
