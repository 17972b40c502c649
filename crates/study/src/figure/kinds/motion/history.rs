//! Curves over time.

use crate::Scale;
use crate::field::{field, fields};
use crate::figure::checker::{Checker, NARROW};
use crate::figure::keys::{BY, COLOUR, IN_UNITS, MARKERS, PANELS, Takes, X_RANGE, Y_RANGE};
use crate::figure::kinds::{Decoded, FigureKind, Kind, Needs};
use crate::figure::vary;
use crate::scope::Scope;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_problem::problem::numbers::unit::Dimension;
use std::collections::HashMap;

/// Most curves that line styles can distinguish in one panel.
const MOST_CURVES: usize = 8;

/// Most steps of all histories in one figure: the histories of all its cases are held at once.
pub(super) const MOST_DRAWN: u64 = 10_000_000;

pub(in crate::figure::kinds) const KIND: Kind = Kind {
    name: "history",
    needs: Needs::Nothing,
    meaning: "curves over time, the exact solution as a thin line; at most 8 cases in a panel",
    keys: &fields![
        /// quantities, one panel each; default: the response and its error
        field("y", Takes::Quantities),
        BY,
        PANELS,
        IN_UNITS,
        /// true: quantities such as energies as areas on one another; one panel for each case
        field("stacked", Takes::Switch),
        /// first and last time of an enlarged part inside each panel
        field("inset", Takes::Range),
        X_RANGE,
        Y_RANGE,
        COLOUR,
        MARKERS,
    ],
    decode: |values, scope| {
        Some(FigureKind::History(History {
            y: values
                .rows("y")
                .unwrap_or_else(|| response_and_error(scope)),
            by: values.row("by"),
            panels: values.row("panels"),
            in_units: values.switch("in_units"),
            stacked: values.switch("stacked"),
            inset: values.range("inset"),
        }))
    },
};

/// Curves over time, one panel for each quantity, the exact solution thin.
#[derive(Debug)]
pub struct History {
    /// Rows of `problem.schema().quantities`, one panel each.
    pub y: Vec<usize>,
    /// Parameter with one line style for each value; `None`: all that vary.
    pub by: Option<usize>,
    /// Parameter with one panel for each value.
    pub panels: Option<usize>,
    /// Whether the axes are in the units of the study.
    pub in_units: bool,
    /// Whether the quantities are areas on one another, with one panel for each case.
    pub stacked: bool,
    /// First and last time of the enlarged part, in the unit of the axis, if there is one.
    pub inset: Option<[f64; 2]>,
}

/// The first quantity, and the first that is an error.
fn response_and_error(scope: &Scope) -> Vec<usize> {
    let quantities = &scope.problem.schema().quantities;
    let error = quantities.iter().position(|quantity| quantity.error);
    let response = (!quantities.is_empty()).then_some(0);
    response.into_iter().chain(error).collect()
}

impl Decoded for History {
    fn limited_axes(&self) -> Option<([Scale; 2], usize)> {
        let axes = if self.stacked { 1 } else { self.y.len() };
        Some(([Scale::Linear; 2], axes))
    }

    fn check_cases(&self, checker: &mut Checker) {
        self.check_stacked(checker);
        check(checker, self.by, self.panels, 1, KIND.name);
        let range = checker.figure.ranges[0];
        check_times(checker, "x_range", range, self.in_units);
        check_times(checker, "inset", self.inset, self.in_units);
    }

    fn draws_histories(&self) -> bool {
        true
    }
}

impl History {
    /// Reports stacked quantities of several dimensions, errors, and keys that stacked panels do not have.
    fn check_stacked(&self, checker: &mut Checker) {
        if !self.stacked {
            return;
        }
        let schema = checker.scope.problem.schema();
        let mut quantities = self.y.iter().map(|row| &schema.quantities[*row]);
        let dimension = |channel: usize| schema.channels[channel].dimension;
        let first = quantities
            .clone()
            .next()
            .map(|quantity| dimension(quantity.channel));
        let fits = quantities
            .all(|quantity| !quantity.error && Some(dimension(quantity.channel)) == first);
        if !fits {
            checker.fault(
                "stacked",
                "needs quantities of one dimension, without errors",
            );
        }
        if self.by.is_some() || self.panels.is_some() || self.in_units || self.inset.is_some() {
            let message = "has one panel for each case; leave out by, panels, in_units and inset";
            checker.fault("stacked", message);
        }
    }
}

/// Reports times of a key after the end of every history, or before their start.
pub(in crate::figure::kinds) fn check_times(
    checker: &mut Checker,
    key: &str,
    times: Option<[f64; 2]>,
    in_units: bool,
) {
    let problem = &*checker.scope.problem;
    let ends = checker.cases().filter_map(|case| {
        let size = match in_units {
            true => problem
                .as_textbook()
                .and_then(|textbook| textbook.size(&case, Dimension::Time))?,
            false => 1.0,
        };
        Some(case.at(problem.schema().duration)? * size)
    });
    let end = ends.fold(f64::NEG_INFINITY, f64::max);
    checker.overlaps(key, times, "the time", [0.0, end]);
}

/// Reports cases that the curves of `kind` cannot show, with so many rows of panels for each value of `panels`.
pub(in crate::figure::kinds) fn check(
    checker: &mut Checker,
    by: Option<usize>,
    panels: Option<usize>,
    rows: usize,
    kind: &str,
) {
    let keys = [("by", by), ("panels", panels)];
    for (key, row) in keys {
        if let Some(row) = row {
            checker.has_values(key, row);
        }
    }
    if let Some(by) = by {
        let distinguished: Vec<usize> = panels.into_iter().chain([by]).collect();
        let what = format!("a {kind} figure with \"by\" shows one case for each curve");
        vary::check(checker, &distinguished, &what, vary::OR_WITHOUT_BY);
    }
    if panels.is_none_or(|row| checker.panels_fit(row, rows)) {
        check_curves(checker, panels);
    }
}

/// Reports more curves in a panel than can be distinguished, or more steps than fit in memory.
fn check_curves(checker: &mut Checker, panels: Option<usize>) {
    let mut counts: HashMap<Option<(u64, &str)>, usize> = HashMap::new();
    let mut steps = 0u64;
    for case in checker.cases() {
        let panel = panels.and_then(|row| case.values[row]);
        let count = counts.entry(panel.map(Value::identity)).or_default();
        *count += 1;
        steps = steps.saturating_add(case.steps());
        let most = if *count > MOST_CURVES {
            format!("{MOST_CURVES} cases in one panel")
        } else if steps > MOST_DRAWN {
            format!("{MOST_DRAWN} steps to draw")
        } else {
            continue;
        };
        checker.fault("where", format!("more than {most}; {NARROW}"));
        return;
    }
}
