//! The parameters that a design samples, in pairs.

use crate::field::{field, fields, needed};
use crate::figure::checker::Checker;
use crate::figure::keys::Takes;
use crate::figure::kinds::{Decoded, FigureKind, Kind, Needs};
use crate::figure::{limits, sampled};
use crate::{ColumnRef, Scale};
use slipgap_problem::problem::Problem;

pub(in crate::figure::kinds) const KIND: Kind = Kind {
    name: "samples",
    needs: Needs::Nothing,
    meaning: "every pair of at most 8 parameters of a design, a dot for each case; a metric is the colour and the last row",
    keys: &fields![
        /// metric of the last row and of the colours
        needed("y", Takes::Metric),
        /// scale of the metric; default linear
        field("y_scale", Takes::Scale),
    ],
    decode: |values, scope| {
        Some(FigureKind::Samples(Samples {
            parameters: sampled::parameters(scope, &values.filter()),
            y: values.row("y")?,
            y_scale: values.scale("y_scale"),
        }))
    },
};

/// Every pair of the parameters that a design samples, and one metric; a dot for each case.
#[derive(Debug)]
pub struct Samples {
    /// The parameters, with the scale of their distribution.
    pub parameters: Vec<(usize, Scale)>,
    /// Row of the study's measures.
    pub y: usize,
    /// Scale of the metric.
    pub y_scale: Scale,
}

impl Decoded for Samples {
    fn limited_axes(&self) -> Option<([Scale; 2], usize)> {
        None
    }

    fn check_keys(&self, checker: &mut Checker) {
        limits::check_matrix(self.parameters.len(), checker);
    }

    fn check_cases(&self, checker: &mut Checker) {
        sampled::check(self.parameters.len(), checker);
    }

    fn columns(&self) -> Option<Vec<ColumnRef>> {
        let rows = self.parameters.iter();
        let parameters = rows.map(|(row, _)| ColumnRef::Parameter(*row));
        Some(parameters.chain([ColumnRef::Metric(self.y)]).collect())
    }

    fn measures(&self, _: &dyn Problem) -> Vec<usize> {
        vec![self.y]
    }
}
