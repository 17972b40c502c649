//! The keys of measurements.

use super::Keys;

/// Keys of `measured`.
pub(crate) const MEASURED: Keys = &[
    (
        "file",
        "CSV file with a line of names above its columns, a parameter that chooses it, or {\"files\": ...} as an axis",
    ),
    (
        "time",
        "name of the column of times, or an object with its unit",
    ),
    ("columns", "for each measured channel its column"),
    (
        "delay",
        "time of the file at t = 0 of the motion; default 0",
    ),
];

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
    "measured channels of a structure, for metrics such as rms_error(deck.u, measured)",
);
