//! Sobol' indices.

use crate::figure::checker::Checker;
use crate::figure::keys::METRICS;
use crate::figure::kinds::{Decoded, FigureKind, Kind, Needs};
use crate::{Block, ColumnRef, Sampling, Scale};
use slipgap_problem::problem::Problem;

pub(in crate::figure::kinds) const KIND: Kind = Kind {
    name: "sobol",
    needs: Needs::Nothing,
    meaning: "Sobol' indices of a saltelli design, with the middle 95 % of bootstrap samples",
    keys: &[METRICS],
    decode: |values, _| {
        Some(FigureKind::Sobol(Sobol {
            y: values.rows("y")?,
        }))
    },
};

/// Sobol' indices of metrics, from a saltelli design.
#[derive(Debug)]
pub struct Sobol {
    /// Rows of the study's measures, one panel each.
    pub y: Vec<usize>,
}

impl Decoded for Sobol {
    fn limited_axes(&self) -> Option<([Scale; 2], usize)> {
        None
    }

    /// Reports cases that are not exactly those of one saltelli design.
    fn check_cases(&self, checker: &mut Checker) {
        let (scope, filter) = (checker.scope, &checker.figure.filter);
        let chosen = scope.select(filter).count() as u64;
        let complete = |block: &Block| {
            let mut designs = block.design.iter();
            designs.any(|d| d.sampling == Sampling::Saltelli && d.points() == chosen)
                && block.select(&*scope.problem, filter).count() as u64 == chosen
        };
        if !scope.blocks.iter().any(complete) {
            let message = "a sobol figure shows all cases of one block with a saltelli design, and no other cases";
            checker.fault("where", message);
        }
    }

    fn columns(&self) -> Option<Vec<ColumnRef>> {
        Some(self.y.iter().copied().map(ColumnRef::Metric).collect())
    }

    fn measures(&self, _: &dyn Problem) -> Vec<usize> {
        self.y.clone()
    }
}
