//! The keys of measurements.

use super::functions::FILES;
use super::kinds::COLUMN_KIND;
use crate::source::field::{ANY, Field, Keys, Kind, Usual, field, fields, needed};
use slipgap_problem::problem::numbers::parameter::Range;
use slipgap_problem::problem::structure::channels::sample::FEWEST_TESTS;

/// What was measured.
pub(crate) const MEASURED: Keys = Keys::new(&fields![
    /// CSV file with a line of names, its path relative to the study; a parameter that chooses it; or {"files": ...} as an axis; of tests compared as a sample a list of files, or {"files": ...}
    needed("file", Kind::OneOf(&[Kind::Text, TESTS, Kind::Object(&FILES)])),
    /// name of the column of times, or an object with its unit
    needed("time", COLUMN_KIND),
    /// for each measured channel the name of its column, or an object with its unit
    needed("columns", Kind::Named(&COLUMN_KIND)),
    /// time of the file at t = 0 of the motion; default 0
    field("delay", Kind::Number(Range::Any)),
    /// histories (default), point by point; or distribution: peak, last, min, max, rms, mean, residual and time_of_peak of each test, over its file or a window of numbers, as a sample with those of each ensemble
    field("compare", Kind::Words("way", || vec!["histories", "distribution"], Some(Usual))),
]);

/// The files of tests that are compared as a sample.
const TESTS: Kind = Kind::List(&Kind::Text, [FEWEST_TESTS, ANY]);

/// The key of a study.
pub(crate) const KEY: Field = field("measured", Kind::Any)
    .means("measured channels of a structure, for metrics such as rms_error(deck.u, measured)");
