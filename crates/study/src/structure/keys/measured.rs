//! The keys of measurements.

use super::Keys;

/// Keys of `measured`.
pub(crate) const MEASURED: Keys = &[
    (
        "file",
        "CSV file with a line of names above its columns, its path relative to the study; a parameter that chooses it; or {\"files\": ...} as an axis; of tests compared as a sample a list of files, or {\"files\": ...}",
    ),
    (
        "time",
        "name of the column of times, or an object with its unit",
    ),
    (
        "columns",
        "for each measured channel the name of its column, or an object with its unit",
    ),
    (
        "delay",
        "time of the file at t = 0 of the motion; 0 if left out",
    ),
    (
        "compare",
        "histories, point by point, if left out; or distribution: peak, last, min, max, rms, mean, residual and time_of_peak of each test, over all times of its file or a window of numbers, as a sample with those of each ensemble",
    ),
];

/// How tests are compared, the usual way first.
pub(crate) const COMPARE: [&str; 2] = ["histories", "distribution"];

/// Keys of a column of `measured`.
pub(crate) const COLUMN: Keys = &[
    ("column", "its name in the file"),
    (
        "unit",
        "its unit, such as mm, kip, g or mm/s; if left out, that of the study",
    ),
];

/// The key with its meaning.
pub(crate) const KEY: (&str, &str) = (
    "measured",
    "measured channels of a study of structures, with which its metrics compare, as in rms_error(deck.u, measured)",
);
