//! The probability that a metric exceeds a limit, over a parameter.

use super::{Decoded, FigureKind, Kind, Needs};
use crate::Scale;
use crate::figure::checker::Checker;
use crate::figure::ensembles;
use crate::figure::keys::{BY_OUTSIDE, Takes, X_RANGE, X_SCALE, Y_RANGE, key};
use slipgap_solver::problem::Problem;

pub(super) const KIND: Kind = Kind {
    name: "fragility",
    needs: Needs::Ensemble,
    meaning: "part of the ensemble of the study in which a metric exceeds a limit, over a parameter such as the scale of records, with 95 % intervals (Clopper and Pearson) and the lognormal function of the largest likelihood",
    keys: &[
        key(
            "x",
            Takes::NumericParameter,
            true,
            "parameter along the horizontal axis, not of the ensemble",
        ),
        key("y", Takes::Metric, true, "metric"),
        key(
            "limit",
            Takes::Number,
            true,
            "a case exceeds the limit if its metric is greater",
        ),
        BY_OUTSIDE,
        X_SCALE,
        X_RANGE,
        Y_RANGE,
    ],
    decode: |values, _| {
        Some(FigureKind::Fragility(Fragility {
            x: values.row("x")?,
            y: values.row("y")?,
            limit: values.numbers("limit").first().copied()?,
            by: values.row("by"),
            x_scale: values.scale("x_scale"),
        }))
    },
};

/// The probability that a metric exceeds a limit, over a parameter.
#[derive(Debug)]
pub struct Fragility {
    /// Parameter along the horizontal axis.
    pub x: usize,
    /// Row of the study's measures.
    pub y: usize,
    /// A case exceeds it if its metric is greater.
    pub limit: f64,
    /// Parameter with one line style for each value; `None`: all outside of the ensemble that vary.
    pub by: Option<usize>,
    /// Scale of the horizontal axis.
    pub x_scale: Scale,
}

impl Decoded for Fragility {
    fn limited_axes(&self) -> Option<([Scale; 2], usize)> {
        Some(([self.x_scale, Scale::Linear], 1))
    }

    fn check_cases(&self, checker: &mut Checker) {
        ensembles::check(checker, Some(self.x), self.by, KIND.name);
        checker.suits_scale("x", self.x, self.x_scale);
        checker.range_shows_some(self.x);
    }

    fn measures(&self, _: &dyn Problem) -> Vec<usize> {
        vec![self.y]
    }
}
