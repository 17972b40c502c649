//! One case over place and time.

use super::{Decoded, FigureKind, Kind, Needs};
use crate::Scale;
use crate::figure::checker::{Checker, NARROW};
use crate::figure::keys::{Takes, key};

/// Most times that a wave is drawn at: about two pixels each.
const MOST_ROWS: u64 = 300;

pub(super) const KIND: Kind = Kind {
    name: "wave",
    needs: Needs::Profiles,
    meaning: "one case over place and time, as shades with a colour bar: the computed motion and the exact one",
    keys: &[key(
        "y",
        Takes::Profile,
        false,
        "quantity along the structure; if left out, the last one of the problem",
    )],
    decode: |values, scope| {
        let last = scope.problem.schema().profiles.len().checked_sub(1);
        Some(FigureKind::Wave(Wave {
            y: values.row("y").or(last)?,
        }))
    },
};

/// One case over place and time, computed and exact, as shades with a colour bar.
#[derive(Debug)]
pub struct Wave {
    /// Row of `problem.schema().profiles`.
    pub y: usize,
}

impl Decoded for Wave {
    fn limited_axes(&self) -> Option<([Scale; 2], usize)> {
        None
    }

    fn check_cases(&self, checker: &mut Checker) {
        if checker.has_more_cases_than(1) {
            let message = format!("a wave figure shows one case, but more are chosen; {NARROW}");
            checker.fault("where", message);
        }
    }

    fn draws_snapshots(&self) -> bool {
        true
    }

    fn snapshot_times(&self, end: f64, steps: u64) -> Vec<f64> {
        let rows = steps.clamp(1, MOST_ROWS);
        let time = |row| end * row as f64 / rows as f64;
        (0..=rows).map(time).collect()
    }
}
