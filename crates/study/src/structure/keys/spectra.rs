//! The keys of motions that are scaled to a spectrum.

use super::Keys;

/// Keys of `scale_to`; one of the first three is given.
pub(crate) const SCALE_TO: Keys = &[
    ("pga", "largest acceleration"),
    ("Sa", "pseudo-acceleration of an oscillator"),
    (
        "spectrum",
        "target spectrum, by least squares at 101 periods from \"from\" to \"to\"",
    ),
    ("T", "period of the oscillator of \"Sa\""),
    ("from", "the shorter period of \"spectrum\""),
    ("to", "the longer period of \"spectrum\""),
    (
        "ratio",
        "damping ratio of \"Sa\" and \"spectrum\"; default 0.05",
    ),
    ("unit", "unit of the accelerations"),
];

/// Keys of a target spectrum: one of these, or those of a table.
pub(crate) const SPECTRUM: Keys = &[
    (
        "EN 1998-1",
        "elastic response spectrum, EN 1998-1:2004, (3.2) to (3.6)",
    ),
    ("ASCE 7", "design response spectrum of ASCE 7-16, 11.4.6"),
];

/// Keys of a target spectrum as a table.
pub(crate) const TARGET_TABLE: Keys = &[
    ("T", "periods, rising"),
    ("Sa", "ordinates, straight between, constant beyond"),
];

/// Keys of the spectrum of EN 1998-1.
pub(crate) const EN_1998: Keys = &[
    ("ag", "design ground acceleration on type A ground"),
    ("S", "soil factor"),
    ("TB", "start of the plateau"),
    ("TC", "end of the plateau"),
    ("TD", "start of constant displacement"),
];

/// Keys of the spectrum of ASCE 7.
pub(crate) const ASCE_7: Keys = &[
    ("SDS", "design acceleration at short periods"),
    ("SD1", "design acceleration at 1 s"),
    ("TL", "long-period transition"),
];
