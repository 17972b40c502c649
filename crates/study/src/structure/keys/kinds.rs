//! Values that several objects of a structure have.

use crate::source::field::Kind::{self, List, Number, Object, OneOf, Shared, Text, Words};
use crate::source::field::{ANY, Keys, field, fields, needed};
use slipgap_problem::problem::numbers::parameter::Range;
use slipgap_system::system::loads::Unit;
use slipgap_system::system::structure::Baseline;

/// A name: letters, digits and _, not beginning with a digit.
pub(super) const NAME: Kind = Kind::Like("^[A-Za-z_][A-Za-z0-9_]*$");

/// Two nodes.
pub(super) const BETWEEN_KIND: Kind = Kind::List(&Kind::Text, [2, 2]);

/// Any number.
pub(super) const ANY_NUMBER: Kind = Number(Range::Any);

/// A list of numbers.
pub(super) const ANY_NUMBERS: Kind = List(&ANY_NUMBER, [1, ANY]);

/// A function of time by its definition.
pub(super) const FUNCTION_OF_TIME: Kind = Shared("function");

/// A unit of accelerations.
pub(super) const UNIT: Kind = Words("unit", || Unit::ALL.map(Unit::name).to_vec(), None);

/// What is removed from an acceleration.
pub(super) const BASELINE: Kind = Words(
    "baseline",
    || Baseline::ALL.map(Baseline::name).to_vec(),
    None,
);

/// A column of a file: its name, or an object with its unit.
pub(super) const COLUMN_KIND: Kind = OneOf(&[Text, Object(&COLUMN)]);

/// A column with its unit.
pub(crate) const COLUMN: Keys = Keys::new(&fields![
    /// its name in the file
    needed("column", Text),
    /// its unit, such as mm, kip, g or mm/s; default: that of the study
    field("unit", Text),
]);
