//! Quantities along the structure at given times.

use crate::Scale;
use crate::field::{field, fields, needed};
use crate::figure::checker::{Checker, MOST_PANELS, NARROW};
use crate::figure::keys::{COLOUR, MARKERS, Takes, X_RANGE, Y_RANGE};
use crate::figure::kinds::{Decoded, FigureKind, Kind, Needs};

/// Most cases in a panel, because their markers are close.
const MOST_CASES: usize = 6;

pub(in crate::figure::kinds) const KIND: Kind = Kind {
    name: "profile",
    needs: Needs::Profiles,
    meaning: "quantities along the structure at given times; at most 6 cases",
    keys: &fields![
        /// quantities; default all
        field("y", Takes::Profiles),
        /// times, one row of panels each
        needed("times", Takes::Times),
        X_RANGE,
        Y_RANGE,
        COLOUR,
        MARKERS,
    ],
    decode: |values, scope| {
        Some(FigureKind::Profile(Profile {
            y: values
                .rows("y")
                .unwrap_or_else(|| (0..scope.problem.schema().profiles.len()).collect()),
            times: values.numbers("times"),
        }))
    },
};

/// Quantities along the structure at given times, the exact solution thin.
#[derive(Debug)]
pub struct Profile {
    /// Rows of `problem.schema().profiles`, one column of panels each.
    pub y: Vec<usize>,
    /// Times, in the problem's unit.
    pub times: Vec<f64>,
}

impl Decoded for Profile {
    fn limited_axes(&self) -> Option<([Scale; 2], usize)> {
        Some(([Scale::Linear; 2], self.y.len()))
    }

    fn check_cases(&self, checker: &mut Checker) {
        let panels = self.y.len() * self.times.len();
        if panels > MOST_PANELS {
            let message = format!("{panels} panels; allowed: at most {MOST_PANELS}");
            checker.fault("times", message);
        }
        if checker.has_more_cases_than(MOST_CASES) {
            let message = format!("more than {MOST_CASES} cases in one panel; {NARROW}");
            checker.fault("where", message);
        }
        self.check_times(checker);
    }

    fn draws_snapshots(&self) -> bool {
        true
    }

    fn snapshot_times(&self, _end: f64, _steps: u64) -> Vec<f64> {
        self.times.clone()
    }
}

impl Profile {
    /// Reports times after the end of a case.
    fn check_times(&self, checker: &mut Checker) {
        let schema = checker.scope.problem.schema();
        let ends = checker.levels(schema.duration);
        let durations = ends.iter().filter_map(|level| level.as_f64());
        let end = durations.fold(f64::INFINITY, f64::min);
        for (i, time) in self.times.iter().enumerate().filter(|(_, t)| **t > end) {
            let name = &schema.parameters[schema.duration].name;
            let message = format!("must be at most {name} = {end}, got {time}");
            checker.fault_of_item("times", i, message);
        }
    }
}
