//! The probability that a metric exceeds a limit, over a parameter.

use crate::field::{field, fields, needed};
use crate::figure::checker::Checker;
use crate::figure::choice::Fit;
use crate::figure::ensembles;
use crate::figure::keys::{BY_OUTSIDE, COLOUR, Takes, X_RANGE, X_SCALE, Y_RANGE};
use crate::figure::kinds::{Decoded, FigureKind, Kind, Needs};
use crate::{ColumnRef, Scale};
use slipgap_problem::problem::Problem;

pub(in crate::figure::kinds) const KIND: Kind = Kind {
    name: "fragility",
    needs: Needs::Ensemble,
    meaning: "fraction of the ensemble in which a metric exceeds a limit, over the scale of records or a measure such as ground.Sa(T1), with 95 % intervals and a lognormal function",
    keys: &fields![
        /// parameter along the horizontal axis, not of the ensemble; with incremental or cloud also a metric, such as ground.Sa(1)
        needed("x", Takes::Column),
        /// metric
        needed("y", Takes::Metric),
        /// a case exceeds the limit if its metric is greater
        needed("limit", Takes::Number),
        /// likelihood (default): from the fractions that exceed at each x; incremental: from the x at which each member reaches the limit, straight between its cases; cloud: from a line through ln y over ln x
        field("fit", Takes::Fit),
        /// value of y, at least the limit, from which on a case, as one without a value, exceeds the limit by an unknown amount; default: cases without a value are left out
        field("collapse", Takes::Number),
        /// parameters or metrics, such as a magnitude, for the slope of the residuals and its p; with incremental or cloud
        field("against", Takes::Columns),
        /// points [x, annual frequency of larger x] of a hazard curve, straight between their logarithms, for the mean annual frequency of exceeding the limit
        field("hazard", Takes::Hazard),
        BY_OUTSIDE,
        X_SCALE,
        X_RANGE,
        Y_RANGE,
        COLOUR,
    ],
    decode: |values, _| {
        Some(FigureKind::Fragility(Fragility {
            x: values.column("x")?,
            y: values.row("y")?,
            limit: values.numbers("limit").first().copied()?,
            fit: values.fit("fit"),
            collapse: values.numbers("collapse").first().copied(),
            against: values.columns("against"),
            hazard: values.points("hazard"),
            by: values.row("by"),
            x_scale: values.scale("x_scale"),
        }))
    },
};

/// The probability that a metric exceeds a limit, over a parameter or a metric.
#[derive(Debug)]
pub struct Fragility {
    /// Column along the horizontal axis.
    pub x: ColumnRef,
    /// Row of the study's measures.
    pub y: usize,
    /// A case exceeds it if its metric is greater.
    pub limit: f64,
    /// How the function is found.
    pub fit: Fit,
    /// From which value on a case has collapsed; `None`: no case has.
    pub collapse: Option<f64>,
    /// Columns over which residuals are tested.
    pub against: Vec<ColumnRef>,
    /// Points of the hazard curve; none without one.
    pub hazard: Vec<[f64; 2]>,
    /// Parameter with one line style for each value; `None`: all outside of the ensemble that vary, but one line if x is a metric.
    pub by: Option<usize>,
    /// Scale of the horizontal axis.
    pub x_scale: Scale,
}

impl Fragility {
    /// The parameter along the horizontal axis, if it is one.
    pub fn parameter(&self) -> Option<usize> {
        match self.x {
            ColumnRef::Parameter(row) => Some(row),
            ColumnRef::Metric(_) => None,
        }
    }
}

impl Decoded for Fragility {
    fn limited_axes(&self) -> Option<([Scale; 2], usize)> {
        Some(([self.x_scale, Scale::Linear], 1))
    }

    fn check_keys(&self, checker: &mut Checker) {
        if self.collapse.is_some_and(|collapse| collapse < self.limit) {
            checker.fault("collapse", "must be at least the limit");
        }
        if !self.against.is_empty() && self.fit == Fit::Likelihood {
            let message = "needs \"fit\": incremental or cloud; a likelihood has no residuals";
            checker.fault("against", message);
        }
    }

    fn check_cases(&self, checker: &mut Checker) {
        match self.x {
            ColumnRef::Parameter(row) => {
                ensembles::check(checker, Some(row), self.by, KIND.name);
                checker.suits_scale("x", row, self.x_scale);
                checker.range_shows_some(row);
            }
            ColumnRef::Metric(row) => {
                if self.fit == Fit::Likelihood {
                    let message = "is a metric; give \"fit\": incremental or cloud";
                    checker.fault("x", message);
                }
                if row == self.y {
                    checker.fault("y", "must be a metric other than x");
                }
                let ensemble = checker.scope.ensemble.as_deref().unwrap_or_default();
                if self.by.is_some_and(|by| ensemble.contains(&by)) {
                    let message = "is a parameter of the ensemble; choose another one";
                    checker.fault("by", message);
                }
            }
        }
    }

    fn measures(&self, _: &dyn Problem) -> Vec<usize> {
        let columns = [self.x].into_iter().chain(self.against.iter().copied());
        let metrics = columns.filter_map(|column| match column {
            ColumnRef::Parameter(_) => None,
            ColumnRef::Metric(row) => Some(row),
        });
        [self.y].into_iter().chain(metrics).collect()
    }
}
