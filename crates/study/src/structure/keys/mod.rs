//! The keys of a structure in a study, each with its meaning, for decoding, schema and documentation.

mod contacts;
mod measured;
mod motions;
mod parts;
mod ranges;
mod spectra;

pub(crate) use contacts::{CONTACT, LAW_TABLE, LISTS, NORMAL_TABLE, PART, PRESSING, WEIGHT};
pub(crate) use measured::{COLUMN, COMPARE, KEY, MEASURED};
pub(crate) use motions::{
    BETWEEN, DISPLACEMENT, FILES, FUNCTION, FUNCTIONS, GROUND, IMPOSED, IMPOSED_BY_FILE,
    IMPOSED_SINE, LOAD_AT, SINE, SUPPORT, SYNTHETIC, TABLE, VELOCITY,
};
pub(crate) use parts::{BAR, MASS, MATRICES, RAYLEIGH, REDUCE, SPRING};
pub(crate) use ranges::{of_pulse, range};
pub(crate) use spectra::{
    AS_GROUND, ASCE_7, CHOOSE, EN_1998, GOALS, OF_GROUND, RULES, Rule, SCALE_TO, SET, SPECTRUM,
    STATISTICS, TARGET_TABLE,
};

/// Keys with their meanings.
pub(crate) type Keys = &'static [(&'static str, &'static str)];

/// The key of damping ratios of modes.
pub(crate) const MODAL_DAMPING: &str = "modal_damping";

/// Keys of `structure`.
pub(crate) const STRUCTURE: Keys = &[
    (
        "units",
        "units of mass, force, length and time, such as \"t, kN, m, s\"; only records are converted",
    ),
    (
        "masses",
        "lumped masses: a node for each name, \"a|b\" two alike; a mass of 0 is held by springs or contacts",
    ),
    (
        "bars",
        "bars of n elements, with the nodes NAME.left, NAME.1, .., NAME.right; \"a|b|c\" is three alike",
    ),
    (
        "matrices",
        "M, K and C in Matrix Market files, with the nodes NAME.NODE.DIRECTION",
    ),
    (
        "springs",
        "springs with dashpots; \"ground\" is a node, too",
    ),
    (
        "rayleigh",
        "C += mass M + stiffness K, with the factors or with damping ratios of two modes",
    ),
    (
        MODAL_DAMPING,
        "damping ratio in every mode of M and K, or a list with one for each mode from the longest period on; further modes have none",
    ),
    (
        "damping_stiffness",
        "K of rayleigh and modal_damping: \"without-contacts\" (if left out), or \"initial\" with elastic contacts",
    ),
    ("contacts", "contacts by name"),
    (
        "loads",
        "forces on nodes, on each node of a bar, or of matrices in a direction, as tower.x",
    ),
    (
        "ground",
        "acceleration of the ground in x, or an object with those in x, y and z; u is then relative to the ground",
    ),
    (
        "supports",
        "supports with motions of their own: nodes NAME, NAME.x, NAME.y, NAME.z; u is then absolute",
    ),
    (
        "static",
        "loads that act before t = 0 and stay; the structure starts in equilibrium with them",
    ),
    (
        GRAVITY.0,
        "acceleration of all masses from t = 0 on, as under `static`, but without an equilibrium at the start: bodies fall",
    ),
    (
        "start",
        "displacement and velocity at t = 0 of nodes, bars, or matrices in a direction",
    ),
    (
        "contacts_reference",
        "the exact motion in histories, figures and errors: \"softened\" or \"rigid\" laws",
    ),
];

/// Keys of static loads besides names.
pub(crate) const STATIC: Keys = &[GRAVITY];

/// The key of gravity.
pub(crate) const GRAVITY: (&str, &str) = (
    "gravity",
    "acceleration of all masses: a number in y, or an object with x, y and z; -9.81 in y is weight",
);

/// Keys of a start.
pub(crate) const START: Keys = &[("u", "displacement"), ("v", "velocity")];

/// Names of the references.
pub(crate) const REFERENCES: [&str; 2] = ["softened", "rigid"];

/// Names of the stiffnesses of damping.
pub(crate) const DAMPING_STIFFNESSES: [&str; 2] = ["without-contacts", "initial"];

/// The names of keys.
pub(crate) fn names(keys: Keys) -> Vec<&'static str> {
    keys.iter().map(|key| key.0).collect()
}
