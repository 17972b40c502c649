//! The path of a contact in a plane.

use crate::Scale;
use crate::field::{field, fields, needed};
use crate::figure::checker::Checker;
use crate::figure::keys::{BY, COLOUR, IN_UNITS, MARKERS, PANELS, Takes};
use crate::figure::kinds::{Curve, Decoded, FigureKind, Kind, Needs};

pub(in crate::figure::kinds) const KIND: Kind = Kind {
    name: "orbit",
    needs: Needs::Structure,
    meaning: "the path of a contact in a plane: r.1 and r.2, or S.1 and S.2 with the disc of its largest limit; at most 8 cases in a panel",
    keys: &fields![
        /// quantity of the first direction
        needed("x", Takes::Quantity),
        /// quantity of the second direction
        needed("y", Takes::Quantities),
        BY,
        PANELS,
        IN_UNITS,
        /// first and last time; default the whole motion
        field("time_range", Takes::Range),
        COLOUR,
        MARKERS,
    ],
    decode: |values, _| {
        Some(FigureKind::Orbit(Orbit(Curve {
            x: values.row("x")?,
            y: values.rows("y")?,
            by: values.row("by"),
            panels: values.row("panels"),
            in_units: values.switch("in_units"),
            times: values.range("time_range"),
            section: false,
        })))
    },
};

/// One quantity over another with equal scales.
#[derive(Debug)]
pub struct Orbit(pub Curve);

impl Decoded for Orbit {
    fn limited_axes(&self) -> Option<([Scale; 2], usize)> {
        None
    }

    fn check_keys(&self, checker: &mut Checker) {
        if self.0.y.len() > 1 {
            checker.fault_of_item("y", 1, "an orbit has one quantity along each axis");
        }
        self.0.check_keys(checker);
    }

    fn check_cases(&self, checker: &mut Checker) {
        self.0.check_cases(checker);
    }

    fn draws_histories(&self) -> bool {
        true
    }
}
