//! What the steady motion has in each cycle of the excitation, over its frequency or a parameter.

use super::history::{self, MOST_DRAWN};
use crate::Scale;
use crate::field::{field, fields, needed};
use crate::figure::checker::{Checker, NARROW};
use crate::figure::choice::Each;
use crate::figure::keys::{BY_OTHERS, COLOUR, Takes, X_RANGE, X_SCALE, Y_RANGE, Y_SCALE};
use crate::figure::kinds::metrics::metric;
use crate::figure::kinds::{Decoded, FigureKind, Kind, Needs};

/// Cycles of each frequency that are drawn if the study does not say how many.
const CYCLES: f64 = 8.0;

pub(in crate::figure::kinds) const KIND: Kind = Kind {
    name: "response",
    needs: Needs::Structure,
    meaning: "the last cycles of a sine, sweep or stepped_sweep at each frequency, a point each: one where the motion repeats, two where its period doubles",
    keys: &fields![
        /// quantities, one panel each
        needed("y", Takes::Quantities),
        /// parameter along the horizontal axis; default: the frequency of the excitation
        field("x", Takes::NumericParameter),
        /// peak (default), max or min of each cycle, or the value at its start, where the excitation rises through 0
        field("each", Takes::Each),
        /// number of last cycles of each frequency; default 8
        field("cycles", Takes::Number),
        BY_OTHERS,
        X_SCALE,
        Y_SCALE,
        X_RANGE,
        Y_RANGE,
        COLOUR,
    ],
    decode: |values, _| {
        Some(FigureKind::Response(Response {
            y: values.rows("y")?,
            x: values.row("x"),
            each: values.each("each"),
            cycles: values.numbers("cycles").first().copied().unwrap_or(CYCLES),
            by: values.row("by"),
            scales: ["x_scale", "y_scale"].map(|key| values.scale(key)),
        }))
    },
};

/// What the last cycles of the excitation have at each frequency.
#[derive(Debug)]
pub struct Response {
    /// Rows of `problem.schema().quantities`, one panel each.
    pub y: Vec<usize>,
    /// Parameter along the horizontal axis; `None`: the frequency.
    pub x: Option<usize>,
    /// What is drawn of each cycle.
    pub each: Each,
    /// Number of last cycles of each frequency, a whole number.
    pub cycles: f64,
    /// Parameter with one marker for each value; `None`: all others that vary.
    pub by: Option<usize>,
    /// Scales of the two axes.
    pub scales: [Scale; 2],
}

impl Decoded for Response {
    fn limited_axes(&self) -> Option<([Scale; 2], usize)> {
        Some((self.scales, self.y.len()))
    }

    fn check_keys(&self, checker: &mut Checker) {
        if !(self.cycles >= 1.0 && self.cycles.fract() == 0.0) {
            checker.fault("cycles", "must be a whole number >= 1");
        }
    }

    fn check_cases(&self, checker: &mut Checker) {
        let frequencies = check_cycles(checker, "kind");
        let Some(x) = self.x else {
            checker.range_overlaps("the frequency", frequencies);
            history::check(checker, self.by, None, 1, KIND.name);
            return;
        };
        metric::check(checker, x, self.scales[0], [self.by, None], KIND.name);
        let steps = checker.cases().map(|case| case.steps());
        if steps.fold(0, u64::saturating_add) > MOST_DRAWN {
            let message = format!("more than {MOST_DRAWN} steps to draw; {NARROW}");
            checker.fault("where", message);
        }
    }

    fn draws_histories(&self) -> bool {
        true
    }
}

/// Reports a case whose excitation has no known cycles; the smallest and largest frequency of the others.
pub(super) fn check_cycles(checker: &mut Checker, key: &str) -> [f64; 2] {
    let mut extent = [f64::INFINITY, f64::NEG_INFINITY];
    let problem = &*checker.scope.problem;
    for case in checker.cases() {
        let none = || Err("needs the excitation of a structure".to_owned());
        let structure = problem.as_structure();
        match structure.map_or_else(none, |structure| structure.cycles(&case)) {
            Ok(cycles) => {
                let frequencies = cycles.iter().map(|cycles| cycles.frequency);
                extent = frequencies.fold(extent, |[a, b], f| [a.min(f), b.max(f)]);
            }
            Err(message) => {
                checker.fault(key, message);
                break;
            }
        }
    }
    extent
}
