//! Columns of the results, as scatters and samples draw them.

use super::DrawnCase;
use slipgap_study::{ColumnRef, Scale, Study};

/// The value of a case in a column.
pub fn value(shown: &DrawnCase, column: ColumnRef) -> Option<f64> {
    match column {
        ColumnRef::Parameter(row) => shown.number(row),
        ColumnRef::Metric(row) => shown.metric(row),
    }
}

/// The title of a column, in markup.
pub fn title(study: &Study, column: ColumnRef) -> String {
    match column {
        ColumnRef::Parameter(row) => study.problem.parameters()[row].title(),
        ColumnRef::Metric(row) => study.title(row),
    }
}

/// Whether a number has a place on a scale.
pub fn has_place(scale: Scale, x: f64) -> bool {
    x.is_finite() && (scale == Scale::Linear || x > 0.0)
}

/// The caption that gives the number of cases without a dot; empty if there are none.
pub fn without_dot(some: usize, cases: usize) -> String {
    match cases - some {
        0 => String::new(),
        lacking => format!("{lacking} of {cases} cases without a value"),
    }
}
