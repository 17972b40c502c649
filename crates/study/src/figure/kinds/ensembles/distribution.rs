//! The distribution functions of metrics over ensembles.

use crate::Scale;
use crate::figure::checker::Checker;
use crate::figure::ensembles;
use crate::figure::keys::{BY_OUTSIDE, COLOUR, METRICS, X_RANGE, X_SCALE, Y_RANGE};
use crate::figure::kinds::{Decoded, FigureKind, Kind, Needs};
use slipgap_problem::problem::Problem;

pub(in crate::figure::kinds) const KIND: Kind = Kind {
    name: "distribution",
    needs: Needs::Ensemble,
    meaning: "distribution functions of metrics over the ensemble, each with a 95 % band (independent cases)",
    keys: &[METRICS, BY_OUTSIDE, X_SCALE, X_RANGE, Y_RANGE, COLOUR],
    decode: |values, _| {
        Some(FigureKind::Distribution(Distribution {
            y: values.rows("y")?,
            by: values.row("by"),
            x_scale: values.scale("x_scale"),
        }))
    },
};

/// The distribution functions of metrics over ensembles.
#[derive(Debug)]
pub struct Distribution {
    /// Rows of the study's measures, one panel each.
    pub y: Vec<usize>,
    /// Parameter with one line style for each value; `None`: all outside of the ensemble that vary.
    pub by: Option<usize>,
    /// Scale of the metrics.
    pub x_scale: Scale,
}

impl Decoded for Distribution {
    /// All panels share the vertical axis.
    fn limited_axes(&self) -> Option<([Scale; 2], usize)> {
        Some(([self.x_scale, Scale::Linear], 1))
    }

    fn check_keys(&self, checker: &mut Checker) {
        if checker.figure.ranges[0].is_some() && self.y.len() > 1 {
            let count = self.y.len();
            let message = format!("takes one metric in \"y\", and the figure has {count}");
            checker.fault("x_range", message);
        }
    }

    fn check_cases(&self, checker: &mut Checker) {
        ensembles::check(checker, None, self.by, KIND.name);
    }

    fn measures(&self, _: &dyn Problem) -> Vec<usize> {
        self.y.clone()
    }
}
