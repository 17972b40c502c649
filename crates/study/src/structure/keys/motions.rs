//! The keys of the ground, of supports, and of functions of time.

use super::Keys;

/// Keys of the ground by directions.
pub(crate) const GROUND: Keys = &[
    ("x", "acceleration in x"),
    ("y", "acceleration in y"),
    ("z", "acceleration in z"),
];

/// Keys of imposed displacements.
pub(crate) const IMPOSED: Keys = &[
    ("t", "times, rising"),
    ("u", "displacements, the first one 0"),
    BETWEEN,
];

/// The key of the line between two points.
pub(crate) const BETWEEN: (&str, &str) = (
    "between",
    "\"cubic\" (if left out), which turns only at points, or \"straight\", whose velocity jumps at points",
);

/// Keys of an imposed displacement that is a sine.
pub(crate) const IMPOSED_SINE: Keys = &[(
    "sine",
    "amplitude (sin(omega t + phase) - sin(phase)), without drift",
)];

/// Keys of imposed displacements of a file.
pub(crate) const IMPOSED_BY_FILE: Keys = &[
    (
        "file",
        "CSV file as of `measured`, or a parameter that chooses it",
    ),
    (
        "time",
        "name of the column of times, or an object with its unit",
    ),
    (
        "column",
        "name of the column of displacements, or an object with its unit; u is the column less its first number",
    ),
    BETWEEN,
];

/// The key of imposed displacements.
pub(crate) const DISPLACEMENT: (&str, &str) = (
    "displacement",
    "instead of an acceleration, here or under a direction: points t, u, of a file or here, or a sine",
);

/// The key of the velocity at the start.
pub(crate) const VELOCITY: (&str, &str) = (
    "velocity",
    "velocity at t = 0, here or under a direction, in addition to an acceleration; without one it is constant",
);

/// Keys of a support besides those of a function, or of the directions.
pub(crate) const SUPPORT: Keys = &[
    DISPLACEMENT,
    VELOCITY,
    ("delay", "time by which all is later; at rest before"),
    (
        "baseline",
        "as of a function; with \"linear\" the support rests after the end",
    ),
];

/// Keys of a function of time; one of the first ones.
pub(crate) const FUNCTION: Keys = &[
    ("sine", "amplitude sin(omega t + phase)"),
    ("table", "straight lines between points, constant beyond"),
    (
        "record",
        "file of a recorded acceleration, relative to the study; a parameter that chooses it; or {\"files\": ...} as an axis",
    ),
    ("pulse", "a pulse of acceleration"),
    (
        "synthetic",
        "a synthetic acceleration by its seed, or by seed and omega",
    ),
    (
        "unit",
        "unit of a record: g, m/s2, cm/s2 or mm/s2, or a parameter with these; if left out, that of the file",
    ),
    (
        "mean",
        "mean of a record: \"removed\" (if left out, for K-NET) or \"kept\" (for others)",
    ),
    (
        "column",
        "column of a table, or of UNAM, with the accelerations, from 1, or a parameter; t and a if left out; another file has the column 1",
    ),
    (
        "dt",
        "time step in s of a table without times, or a parameter; of another file that of its header",
    ),
    (
        "component",
        "component of a file with several, from 1, or a parameter",
    ),
    (
        "scale",
        "factor of the function, in addition to \"scale_to\"",
    ),
    (
        "start",
        "time that becomes t = 0; this and the keys below not of a sine",
    ),
    ("end", "time at which it ends; 0 after"),
    (
        "baseline",
        "what is removed: \"none\"; \"mean\" of the points; \"linear\", the mean slope of the velocity, which is then 0 at the end",
    ),
    (
        "scale_to",
        "strength of the motion from start to end; \"ground\": the factor of the ground",
    ),
    ("delay", "time by which all is later; 0 before"),
];

/// Number of the keys of [`FUNCTION`] of which one is needed.
pub(crate) const FUNCTIONS: usize = 5;

/// Keys of the files of an axis of records.
pub(crate) const FILES: Keys = &[
    (
        "files",
        "a folder (without .md), or a pattern with one *, such as \"records/*.smc\"; in the order of names, numbers in them by their values (r_2 before r_10)",
    ),
    (
        "choose",
        "only those records whose spectra come nearest to a target; other files with the same text for * go with them",
    ),
];

/// Keys of `sine`.
pub(crate) const SINE: Keys = &[
    ("amplitude", "amplitude"),
    ("omega", "circular frequency"),
    ("phase", "phase; 0 if not given"),
];

/// Keys of `table`.
pub(crate) const TABLE: Keys = &[
    ("t", "times, rising; two equal times make a jump"),
    ("f", "values at these times"),
];

/// Keys of `synthetic`.
pub(crate) const SYNTHETIC: Keys = &[
    ("seed", "a whole number from 0 to 4294967295"),
    (
        "omega",
        "circular frequency of the ground filter in rad/s; 15.6 (firm ground) if left out",
    ),
];

/// Keys of a load: the node, and those of a function.
pub(crate) const LOAD_AT: (&str, &str) = (
    "at",
    "node on which the force acts, a bar, or matrices and a direction such as tower.x; on each node the same force",
);
