//! Errors over the time step.

use super::metric;
use crate::Scale;
use crate::field::{field, fields};
use crate::figure::checker::Checker;
use crate::figure::keys::{BY_OTHERS, COLOUR, MARKERS, METRICS, Takes, X_RANGE, Y_RANGE};
use crate::figure::kinds::{Decoded, FigureKind, Kind, Needs};
use crate::figure::sampled;
use slipgap_problem::problem::Problem;
use slipgap_problem::problem::numbers::parameter::Value;

pub(in crate::figure::kinds) const KIND: Kind = Kind {
    name: "convergence",
    needs: Needs::Nothing,
    meaning: "errors over the time step on logarithmic scales, with the order where a curve is straight",
    keys: &fields![
        /// parameter along the horizontal axis; default the time step
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

impl Convergence {
    /// The error of a program that chooses its own steps is not over dt.
    fn refuse_adaptive(&self, checker: &mut Checker) {
        let problem = &checker.scope.problem;
        let programs = problem.programs();
        let listed = programs.map_or(&[][..], |programs| &programs.list);
        let mut adaptive = listed.iter().filter(|program| program.adaptive);
        let table = problem.parameters();
        let row = table.iter().position(|known| known.name == "method");
        let (true, Some(row)) = (self.x == problem.schema().step, row) else {
            return;
        };
        let shown = checker.levels(row);
        if let Some(program) = adaptive.find(|program| shown.contains(&Value::Name(program.name))) {
            let message = format!(
                "{} is adaptive: dt is only the spacing of its answers; give a number of its own as x, or leave it out by \"where\"",
                program.name
            );
            checker.fault("x", message);
        }
    }
}

impl Decoded for Convergence {
    fn limited_axes(&self) -> Option<([Scale; 2], usize)> {
        Some(([Scale::Log; 2], self.y.len()))
    }

    fn check_cases(&self, checker: &mut Checker) {
        if !sampled::refused(checker, KIND.name) {
            metric::check(checker, self.x, Scale::Log, [self.by, None], KIND.name);
            checker.has_two_values("x", self.x, KIND.name);
            self.refuse_adaptive(checker);
        }
    }

    fn measures(&self, _: &dyn Problem) -> Vec<usize> {
        self.y.clone()
    }
}
