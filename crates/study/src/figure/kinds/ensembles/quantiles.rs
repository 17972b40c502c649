//! Quantiles of metrics over ensembles, over a parameter.

use crate::Scale;
use crate::figure::checker::Checker;
use crate::figure::ensembles;
use crate::figure::keys::{
    BAND, BY_OUTSIDE, COLOUR, MARKERS, METRICS, USUAL, X, X_RANGE, X_SCALE, Y_RANGE, Y_SCALE,
};
use crate::figure::kinds::{Decoded, FigureKind, Kind, Needs};
use slipgap_problem::problem::Problem;

pub(in crate::figure::kinds) const KIND: Kind = Kind {
    name: "quantiles",
    needs: Needs::Ensemble,
    meaning: "metrics over a parameter: median of the ensemble and a band between two quantiles",
    keys: &[
        X, METRICS, BY_OUTSIDE, BAND, X_SCALE, Y_SCALE, X_RANGE, Y_RANGE, COLOUR, MARKERS,
    ],
    decode: |values, _| {
        Some(FigureKind::Quantiles(Quantiles {
            x: values.row("x")?,
            y: values.rows("y")?,
            by: values.row("by"),
            band: values.range("band").unwrap_or(USUAL),
            scales: ["x_scale", "y_scale"].map(|key| values.scale(key)),
        }))
    },
};

/// Quantiles of metrics over ensembles, over a parameter.
#[derive(Debug)]
pub struct Quantiles {
    /// Parameter along the horizontal axis.
    pub x: usize,
    /// Rows of the study's measures, one panel each.
    pub y: Vec<usize>,
    /// Parameter with one line style for each value; `None`: all outside of the ensemble that vary.
    pub by: Option<usize>,
    /// Probabilities of the quantiles at the edges of the band.
    pub band: [f64; 2],
    /// Scales of the axes.
    pub scales: [Scale; 2],
}

impl Decoded for Quantiles {
    fn limited_axes(&self) -> Option<([Scale; 2], usize)> {
        Some((self.scales, self.y.len()))
    }

    fn check_cases(&self, checker: &mut Checker) {
        ensembles::check(checker, Some(self.x), self.by, KIND.name);
        checker.suits_scale("x", self.x, self.scales[0]);
        checker.range_shows_some(self.x);
    }

    fn measures(&self, _: &dyn Problem) -> Vec<usize> {
        self.y.clone()
    }
}
