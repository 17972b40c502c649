//! Metrics over a parameter.

use super::{Decoded, FigureKind, Kind, Needs};
use crate::Scale;
use crate::figure::checker::Checker;
use crate::figure::keys::{BY_OTHERS, METRICS, X, X_RANGE, X_SCALE, Y_RANGE, Y_SCALE};
use crate::figure::{sampled, vary};
use slipgap_solver::problem::Problem;

pub(super) const KIND: Kind = Kind {
    name: "metric",
    needs: Needs::Nothing,
    meaning: "metrics over a parameter",
    keys: &[X, METRICS, BY_OTHERS, X_SCALE, Y_SCALE, X_RANGE, Y_RANGE],
    decode: |values, _| {
        Some(FigureKind::Metric(Metric {
            x: values.row("x")?,
            y: values.rows("y")?,
            by: values.row("by"),
            x_scale: values.scale("x_scale"),
            y_scale: values.scale("y_scale"),
        }))
    },
};

/// Metrics over a parameter.
#[derive(Debug)]
pub struct Metric {
    /// Parameter along the horizontal axis.
    pub x: usize,
    /// Rows of the study's measures, one panel each.
    pub y: Vec<usize>,
    /// Parameter with one line style for each value; `None`: all others that vary.
    pub by: Option<usize>,
    /// Scale of the horizontal axis.
    pub x_scale: Scale,
    /// Scale of the vertical axes.
    pub y_scale: Scale,
}

impl Decoded for Metric {
    fn limited_axes(&self) -> Option<([Scale; 2], usize)> {
        Some(([self.x_scale, self.y_scale], self.y.len()))
    }

    fn check_cases(&self, checker: &mut Checker) {
        if !sampled::refused(checker, KIND.name) {
            check(checker, self.x, self.x_scale, self.by, KIND.name);
        }
    }

    fn measures(&self, _: &dyn Problem) -> Vec<usize> {
        self.y.clone()
    }
}

/// Reports parameters that cannot be along the axis of `kind` or distinguish its curves.
pub(super) fn check(checker: &mut Checker, x: usize, scale: Scale, by: Option<usize>, kind: &str) {
    checker.has_values("x", x);
    checker.suits_scale("x", x, scale);
    checker.range_shows_some(x);
    if let Some(by) = by {
        checker.has_values("by", by);
        let what = format!("a {kind} figure with \"by\" shows one case at each point of a curve");
        vary::check(checker, &[x, by], &what, vary::OR_WITHOUT_BY);
    }
}
