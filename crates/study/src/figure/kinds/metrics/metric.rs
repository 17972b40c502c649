//! Metrics over a parameter.

use crate::Scale;
use crate::field::{field, fields};
use crate::figure::checker::Checker;
use crate::figure::keys::{
    BY_OTHERS, COLOUR, MARKERS, METRICS, PANELS, Takes, X, X_RANGE, X_SCALE, Y_RANGE, Y_SCALE,
};
use crate::figure::kinds::{Decoded, FigureKind, Kind, Needs};
use crate::figure::{sampled, vary};
use slipgap_problem::problem::Problem;

pub(in crate::figure::kinds) const KIND: Kind = Kind {
    name: "metric",
    needs: Needs::Nothing,
    meaning: "metrics over a parameter",
    keys: &fields![
        X,
        METRICS,
        BY_OTHERS,
        PANELS,
        /// true: with the limits of the study's checks
        field("checks", Takes::Switch),
        X_SCALE,
        Y_SCALE,
        X_RANGE,
        Y_RANGE,
        COLOUR,
        MARKERS,
    ],
    decode: |values, _| {
        Some(FigureKind::Metric(Metric {
            x: values.row("x")?,
            y: values.rows("y")?,
            by: values.row("by"),
            panels: values.row("panels"),
            checks: values.switch("checks"),
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
    /// Parameter with one panel for each value.
    pub panels: Option<usize>,
    /// Whether the limits of the study's checks are drawn.
    pub checks: bool,
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
            let distinguished = [self.by, self.panels];
            check(checker, self.x, self.x_scale, distinguished, KIND.name);
            if let Some(row) = self.panels {
                checker.has_values("panels", row);
                checker.panels_fit(row, self.y.len());
            }
            self.checks_exist(checker);
        }
    }

    fn measures(&self, _: &dyn Problem) -> Vec<usize> {
        self.y.clone()
    }
}

impl Metric {
    /// Reports the key `checks` of a figure whose metrics have no checks.
    fn checks_exist(&self, checker: &mut Checker) {
        let scope = checker.scope;
        if self.checks && !self.y.iter().any(|row| scope.checked.contains(row)) {
            let message = "the study has no check of a metric of this figure";
            checker.fault("checks", message);
        }
    }
}

/// Reports parameters that cannot be along the axis of `kind` or distinguish its curves, those of the keys `by` and `panels`.
pub(in crate::figure::kinds) fn check(
    checker: &mut Checker,
    x: usize,
    scale: Scale,
    [by, panels]: [Option<usize>; 2],
    kind: &str,
) {
    checker.has_values("x", x);
    checker.suits_scale("x", x, scale);
    checker.range_shows_some(x);
    if let Some(by) = by {
        checker.has_values("by", by);
        let what = format!("a {kind} figure with \"by\" shows one case at each point of a curve");
        let distinguished: Vec<usize> = [x, by].into_iter().chain(panels).collect();
        vary::check(checker, &distinguished, &what, vary::OR_WITHOUT_BY);
    }
}
