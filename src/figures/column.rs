//! Columns of the results, as scatters and samples draw them.

use crate::figures::DrawnCase;
use slipgap_study::{Column, Scale, Study};

/// The value of a case in a column.
pub fn value(shown: &DrawnCase, column: Column) -> Option<f64> {
    match column {
        Column::Parameter(row) => shown.number(row),
        Column::Metric(row) => shown.metric(row),
    }
}

/// The title of a column, in markup.
pub fn title(study: &Study, column: Column) -> &str {
    match column {
        Column::Parameter(row) => &study.problem.parameters()[row].symbol,
        Column::Metric(row) => &study.measures[row].symbol,
    }
}

/// Whether a number has a place on a scale.
pub fn has_place(scale: Scale, x: f64) -> bool {
    x.is_finite() && (scale == Scale::Linear || x > 0.0)
}

/// The caption that gives the number of cases without a dot; empty if there are none.
pub fn without_dot(some: usize, all: usize) -> String {
    match all - some {
        0 => String::new(),
        lacking => format!("{lacking} of {all} cases without a value"),
    }
}
