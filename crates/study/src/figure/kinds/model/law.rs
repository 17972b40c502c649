//! The laws of the cases.

use crate::Scale;
use crate::figure::checker::Checker;
use crate::figure::keys::{COLOUR, MARKERS};
use crate::figure::kinds::{Decoded, FigureKind, Kind, Needs};

pub(in crate::figure::kinds) const KIND: Kind = Kind {
    name: "law",
    needs: Needs::OneContact,
    meaning: "the laws of the cases: force over displacement or velocity",
    keys: &[COLOUR, MARKERS],
    decode: |_, _| Some(FigureKind::Law(Law)),
};

/// The laws of the cases: force over displacement or velocity.
#[derive(Debug)]
pub struct Law;

impl Decoded for Law {
    fn limited_axes(&self) -> Option<([Scale; 2], usize)> {
        None
    }

    fn check_cases(&self, _: &mut Checker) {}
}
