//! Errors over the time step.

use super::metric;
use crate::Scale;
use crate::field::{field, fields};
use crate::figure::checker::Checker;
use crate::figure::keys::{BY_OTHERS, COLOUR, MARKERS, METRICS, Takes, X_RANGE, Y_RANGE};
use crate::figure::kinds::{Decoded, FigureKind, Kind, Needs};
use crate::figure::sampled;
use slipgap_problem::problem::Problem;

pub(in crate::figure::kinds) const KIND: Kind = Kind {
    name: "convergence",
    needs: Needs::Nothing,
    meaning: "errors over the time step on logarithmic scales, with the observed order where a curve is straight",
    keys: &fields![
        /// parameter along the horizontal axis; if left out, the time step
        field("x", Takes::NumericParameter),
        METRICS,
        BY_OTHERS,
        X_RANGE,
        Y_RANGE,
        COLOUR,
        MARKERS,
    ],
    decode: |values, scope| {
        Some(FigureKind::Convergence(Convergence {
            x: values.row("x").unwrap_or(scope.problem.schema().step),
            y: values.rows("y")?,
            by: values.row("by"),
        }))
    },
};

/// Metrics over the time step, with the observed order.
#[derive(Debug)]
pub struct Convergence {
    /// The step, along the horizontal axis.
    pub x: usize,
    /// Rows of the study's measures, one panel each.
    pub y: Vec<usize>,
    /// Parameter with one line style for each value; `None`: all others that vary.
    pub by: Option<usize>,
}

impl Decoded for Convergence {
    fn limited_axes(&self) -> Option<([Scale; 2], usize)> {
        Some(([Scale::Log; 2], self.y.len()))
    }

    fn check_cases(&self, checker: &mut Checker) {
        if !sampled::refused(checker, KIND.name) {
            metric::check(checker, self.x, Scale::Log, [self.by, None], KIND.name);
            checker.has_two_values("x", self.x, KIND.name);
        }
    }

    fn measures(&self, _: &dyn Problem) -> Vec<usize> {
        self.y.clone()
    }
}
