//! Units of columns, as far as they are known.

use slipgap::problem::Problem;
use slipgap::problem::numbers::parameter::{Kind, Parameter};
use slipgap::problem::numbers::unit::Dimension;
use slipgap::study::Measure;

/// How the tables begin a unit that the study may name.
const OF_STUDY: &str = "the study's ";

/// The unit of a parameter; `None` for names, and where the study names none.
pub fn of_parameter(problem: &dyn Problem, parameter: &Parameter) -> Option<String> {
    if let Some(unit) = &parameter.shown_unit {
        return Some(unit.to_string());
    }
    match (parameter.kind, parameter.unit.strip_prefix(OF_STUDY)) {
        (Kind::Choice(_), _) => None,
        (_, Some("time")) => problem
            .as_structure()
            .and_then(|structure| structure.unit_name(Dimension::Time)),
        (_, Some(_)) => None,
        (_, None) => Some(parameter.unit.to_string()),
    }
}

/// The unit of a metric; `None` where the study names none.
pub fn of_measure(problem: &dyn Problem, measure: &Measure) -> Option<String> {
    let known = !problem.schema().described
        || problem
            .as_structure()
            .and_then(|structure| structure.unit_name(Dimension::Time))
            .is_some();
    (known || measure.unit != "1").then(|| measure.unit.clone())
}

/// The unit of a channel of this dimension.
pub fn of_dimension(problem: &dyn Problem, dimension: Dimension) -> Option<String> {
    let scales = &problem.schema().units;
    let scale = scales.iter().find(|unit| unit.dimension == dimension);
    match scale {
        Some(scale) => Some(scale.name.to_string()),
        None => problem
            .as_structure()
            .and_then(|structure| structure.unit_name(dimension)),
    }
}
