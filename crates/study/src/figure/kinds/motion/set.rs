//! The spectra of a set of ground motions and its target.

use crate::Scale;
use crate::field::{field, fields};
use crate::figure::checker::{Checker, NARROW};
use crate::figure::keys::{COLOUR, Takes};
use crate::figure::kinds::{Decoded, FigureKind, Kind, Needs};

/// Most cases: each may have another set, which is computed.
const MOST_CASES: usize = 1000;

pub(in crate::figure::kinds) const KIND: Kind = Kind {
    name: "set",
    needs: Needs::Structure,
    meaning: "pseudo-acceleration of all motions of a \"set\", their mean or envelope, the target, and the range of the rule; one panel for each set",
    keys: &fields![
        /// first and last period; default: half the first and twice the last one of the rule
        field("periods", Takes::Periods),
        COLOUR,
    ],
    decode: |values, _| {
        Some(FigureKind::Set(Set {
            periods: values.range("periods"),
        }))
    },
};

/// Spectra of a set of ground motions over the period.
#[derive(Debug)]
pub struct Set {
    /// First and last period, if they are given.
    pub periods: Option<[f64; 2]>,
}

impl Decoded for Set {
    fn limited_axes(&self) -> Option<([Scale; 2], usize)> {
        None
    }

    fn check_keys(&self, checker: &mut Checker) {
        if self.periods.is_some_and(|periods| periods[0] <= 0.0) {
            checker.fault_of_item("periods", 0, "must be > 0");
        }
    }

    fn check_cases(&self, checker: &mut Checker) {
        if checker.has_more_cases_than(MOST_CASES) {
            checker.fault("where", format!("more than {MOST_CASES} cases; {NARROW}"));
        } else if !checker.scope.has_set() {
            let message = "a set figure needs a \"set\" under \"scale_to\" of the ground";
            checker.fault("kind", message);
        }
    }
}
