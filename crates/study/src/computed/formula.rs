//! The arithmetic of metrics, with the measures known so far as names.

use crate::Measure;
use slipgap_problem::problem::Problem;
use slipgap_problem::problem::expression::{ExpressionFault, Formula};
use slipgap_problem::problem::numbers::parameter::Parameter;
use slipgap_problem::problem::structure::tables::schema::named;

/// The parameters of the problem, then these measures, then other names.
pub fn table(problem: &dyn Problem, measures: &[Measure], others: &[&str]) -> Vec<Parameter> {
    let parameters = problem.parameters().iter().cloned();
    let measures = measures.iter().map(|measure| named(&measure.name));
    let others = others.iter().map(|name| named(name));
    parameters.chain(measures).chain(others).collect()
}

/// The arithmetic of a text, and the rows of `table` from `from` on that it uses.
///
/// # Errors
/// What is wrong, with its place in the text.
pub fn parse(
    text: &str,
    table: &[Parameter],
    from: usize,
) -> Result<(Formula, Vec<usize>), ExpressionFault> {
    let formula = Formula::number(text, table)?;
    let uses = formula
        .uses()
        .iter()
        .filter_map(|row| row.checked_sub(from))
        .collect();
    Ok((formula, uses))
}
