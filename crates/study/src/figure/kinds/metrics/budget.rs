//! The error and its parts over a parameter.

use crate::Scale;
use crate::field::{field, fields};
use crate::figure::checker::Checker;
use crate::figure::keys::{COLOUR, MARKERS, PANELS, Takes, X, X_RANGE, Y_RANGE};
use crate::figure::kinds::{Decoded, FigureKind, Kind, Needs};
use crate::figure::{sampled, vary};
use slipgap_problem::problem::{self, Problem};

pub(in crate::figure::kinds) const KIND: Kind = Kind {
    name: "budget",
    needs: Needs::Nothing,
    meaning: "the error and its parts over a parameter on logarithmic scales, with the slope where a curve is straight",
    keys: &fields![
        X,
        /// quantities; default all
        field("y", Takes::Budgets),
        PANELS,
        X_RANGE,
        Y_RANGE,
        COLOUR,
        MARKERS,
    ],
    decode: |values, scope| {
        Some(FigureKind::Budget(Budget {
            x: values.row("x")?,
            y: values
                .rows("y")
                .unwrap_or_else(|| (0..scope.problem.schema().budgets.len()).collect()),
            panels: values.row("panels"),
        }))
    },
};

/// The error and its parts over a parameter.
#[derive(Debug)]
pub struct Budget {
    /// Parameter along the horizontal axis.
    pub x: usize,
    /// Rows of `problem.schema().budgets`, one row of panels each.
    pub y: Vec<usize>,
    /// Parameter with one panel for each value.
    pub panels: Option<usize>,
}

impl Decoded for Budget {
    fn limited_axes(&self) -> Option<([Scale; 2], usize)> {
        Some(([Scale::Log; 2], self.y.len()))
    }

    fn check_cases(&self, checker: &mut Checker) {
        if sampled::refused(checker, KIND.name) {
            return;
        }
        checker.has_values("x", self.x);
        checker.suits_scale("x", self.x, Scale::Log);
        checker.range_shows_some(self.x);
        if let Some(row) = self.panels {
            checker.has_values("panels", row);
            checker.panels_fit(row, self.y.len());
        }
        let distinguished: Vec<usize> = [self.x].into_iter().chain(self.panels).collect();
        vary::check(
            checker,
            &distinguished,
            "a budget shows one case at each point",
            "",
        );
        checker.has_two_values("x", self.x, KIND.name);
    }

    fn measures(&self, problem: &dyn Problem) -> Vec<usize> {
        let budgets = self.y.iter().map(|row| &problem.schema().budgets[*row]);
        budgets.flat_map(problem::Budget::metrics).collect()
    }
}
