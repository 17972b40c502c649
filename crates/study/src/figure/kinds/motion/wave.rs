//! One case over place and time.

use crate::Scale;
use crate::field::{field, fields};
use crate::figure::checker::{Checker, NARROW};
use crate::figure::keys::{Takes, X_RANGE};
use crate::figure::kinds::{Decoded, FigureKind, Kind, Needs};

/// Most times that a wave is drawn at: about two pixels each.
const MOST_ROWS: u64 = 300;

pub(in crate::figure::kinds) const KIND: Kind = Kind {
    name: "wave",
    needs: Needs::Profiles,
    meaning: "one case over place and time, as shades: the computed motion and the exact one",
    keys: &fields![
        /// quantity along the structure; default: the last one of the problem
        field("y", Takes::Profile),
        X_RANGE,
        /// first and last time shown; default the whole motion
        field("y_range", Takes::Range),
    ],
    decode: |values, scope| {
        let last = scope.problem.schema().profiles.len().checked_sub(1);
        Some(FigureKind::Wave(Wave {
            y: values.row("y").or(last)?,
            times: values.range("y_range"),
        }))
    },
};

/// One case over place and time, computed and exact, as shades with a colour bar.
#[derive(Debug)]
pub struct Wave {
    /// Row of `problem.schema().profiles`.
    pub y: usize,
    /// First and last time, if the study gives them.
    pub times: Option<[f64; 2]>,
}

impl Decoded for Wave {
    fn limited_axes(&self) -> Option<([Scale; 2], usize)> {
        Some(([Scale::Linear; 2], 1))
    }

    fn check_cases(&self, checker: &mut Checker) {
        if checker.has_more_cases_than(1) {
            let message = format!("a wave figure shows one case, but more are chosen; {NARROW}");
            checker.fault("where", message);
        }
        let schema = checker.scope.problem.schema();
        let ends = checker.levels(schema.duration);
        let durations = ends.iter().filter_map(|level| level.as_f64());
        let end = durations.fold(f64::NEG_INFINITY, f64::max);
        checker.overlaps("y_range", self.times, "the time", [0.0, end]);
    }

    fn draws_snapshots(&self) -> bool {
        true
    }

    fn snapshot_times(&self, end: f64, steps: u64) -> Vec<f64> {
        let [from, to] = self
            .times
            .map_or([0.0, end], |[from, to]| [from.max(0.0), to.min(end)]);
        let rows = steps.clamp(1, MOST_ROWS);
        let time = |row| from + (to - from) * row as f64 / rows as f64;
        (0..=rows).map(time).collect()
    }
}
