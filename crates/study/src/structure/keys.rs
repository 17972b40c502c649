//! The keys of a structure in a study, each with its meaning, for decoding, schema and documentation.

use slipgap_solver::contact::number::Number;
use slipgap_solver::problem::structure::contacts::{NUMBERS, meaning};
use std::sync::LazyLock;

/// Keys with their meanings.
pub(crate) type Keys = &'static [(&'static str, &'static str)];

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
    ("rayleigh", "C += mass M + stiffness K"),
    ("modal_damping", "damping ratio in every mode of M and K"),
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
        "start",
        "displacement and velocity at t = 0 of nodes, bars, or matrices in a direction",
    ),
    (
        "contacts_reference",
        "the exact motion in histories, figures and errors: \"softened\" or \"rigid\" laws",
    ),
];

/// Keys of a mass with a direction.
pub(crate) const MASS: Keys = &[("mass", "its mass"), DIRECTION];

/// The direction in which a part moves.
const DIRECTION: (&str, &str) = (
    "direction",
    "direction of motion, \"x\" (if left out), \"y\" or \"z\"",
);

/// Keys of matrices.
pub(crate) const MATRICES: Keys = &[
    (
        "M",
        "file of the mass matrix, its content, or a parameter that chooses it; so for K and C",
    ),
    ("K", "file of the stiffness matrix"),
    ("C", "file of the damping matrix, if there is one"),
    (
        "dofs",
        "CSV file with the header node,direction, if wanted support and X,Y,Z, and a row for each row of the matrices; or a list of [node, direction] or [node, direction, X, Y, Z]",
    ),
    (
        "ties",
        "CSV file with lines node,direction and cells dof:factor, or its content: tied dofs as sums of rows, named as nodes are",
    ),
    (
        "reduce",
        "keeps the dofs that the study names, and lowest modes (Craig and Bampton)",
    ),
];

/// Keys of `reduce`, of which one is given.
pub(crate) const REDUCE: Keys = &[
    ("modes", "number of modes; all if there are fewer"),
    (
        "up_to",
        "the modes up to this frequency in cycles per unit of time",
    ),
];

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
];

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
];

/// The key of imposed displacements.
pub(crate) const DISPLACEMENT: (&str, &str) = (
    "displacement",
    "instead of an acceleration, here or under a direction: points t, u with a cubic between them that turns only there",
);

/// Keys of a support besides those of a function, or of the directions.
pub(crate) const SUPPORT: Keys = &[
    DISPLACEMENT,
    ("delay", "time by which all is later; at rest before"),
    (
        "baseline",
        "as of a function; with \"linear\" the support rests after the end",
    ),
];

/// Keys of a bar.
pub(crate) const BAR: Keys = &[
    ("L", "length"),
    ("EA", "axial stiffness E A"),
    (
        "mass",
        "mass of the whole bar; m/n at each node, half of it at the ends",
    ),
    ("n", "number of elements, each with the stiffness E A n/L"),
    (
        "stiffness_damping",
        "dashpot of each element over its stiffness; a time",
    ),
    DIRECTION,
];

/// Keys of a spring.
pub(crate) const SPRING: Keys = &[
    ("name", "name, with which its force is the channel NAME.S"),
    ("between", "two nodes"),
    ALONG,
    ("k", "stiffness; below 0 where contacts hold the nodes"),
    ("c", "dashpot"),
    (
        "mass",
        "mass that has the period; with period and ratio, instead of k and c",
    ),
    ("period", "k = mass (2 pi/period)^2"),
    ("ratio", "c = 2 ratio (2 pi/period) mass"),
    DIRECTION,
    (
        "directions",
        "two of x, y and z: a spring in each between nodes with both, as a.x and a.y; numbers may be lists of two",
    ),
];

/// Nodes with factors instead of two nodes.
const ALONG: (&str, &str) = (
    "along",
    "instead of between: nodes with factors, whose sum with u is the extension",
);

/// Keys of `rayleigh`.
pub(crate) const RAYLEIGH: Keys = &[
    ("mass", "factor of M, 1 over time"),
    ("stiffness", "factor of K, a time"),
];

/// Keys of a contact: those of all, then the numbers of the laws.
pub(crate) static CONTACT: LazyLock<Vec<(&str, &str)>> = LazyLock::new(|| {
    let of_all = [
        ("law", "law of the contact, or a parameter that chooses it"),
        ("between", "nodes I and J; r = u_J - u_I + gap"),
        (
            "along",
            "instead of between: nodes with factors, whose sum with u, plus the gap, is r",
        ),
        (
            "pairs",
            "instead of between: CSV file with lines of a name and cells dof:factor, one for each contact NAME.LINE",
        ),
        (
            "plane",
            "instead of between: nodes I and J of each of two directions, of friction in a plane; [\"ground\", \"ground\"] holds one",
        ),
        (
            "directions",
            "two of x, y and z: with between, friction in a plane between nodes with both directions, as a.x and a.y",
        ),
        ("gap", "r at rest"),
    ];
    of_all
        .into_iter()
        .chain(numbers())
        .chain(LISTS.iter().copied())
        .collect()
});

/// Keys of a law in a list of laws.
pub(crate) static PART: LazyLock<Vec<(&str, &str)>> = LazyLock::new(|| {
    let of_all = [CONTACT[0], ("gap", "r at rest of this law")];
    let inner = INNER_LISTS.iter().copied();
    of_all.into_iter().chain(numbers()).chain(inner).collect()
});

/// Keys of lists of laws.
pub(crate) const LISTS: [(&str, &str); 2] = [
    (
        "series",
        "instead of law: laws one behind the other, NAME.1, NAME.2, .., with nodes without mass NAME.node1, ..",
    ),
    (
        "parallel",
        "instead of law: laws side by side, NAME.1, NAME.2, ..",
    ),
];

/// The same in a list.
const INNER_LISTS: [(&str, &str); 2] = [
    (
        LISTS[0].0,
        "in parallel, instead of law: laws one behind the other, NAME.i.1, .., with nodes NAME.i.node1, ..",
    ),
    (
        LISTS[1].0,
        "in series, instead of law: laws side by side, NAME.i.1, ..; they are laws only",
    ),
];

fn numbers() -> impl Iterator<Item = (&'static str, &'static str)> {
    let number = |number: &&Number| (number.key, &*meaning(number).leak());
    NUMBERS.iter().map(number)
}

/// Keys of a table of normal forces.
pub(crate) const NORMAL_TABLE: Keys = &[("t", "times"), ("N", "forces at these times")];

/// Keys of the table of a law.
pub(crate) const LAW_TABLE: Keys = &[("r", "deflections"), ("S", "forces at these deflections")];

/// Keys of a weight under vertical acceleration.
pub(crate) const WEIGHT: Keys = &[
    ("weight", "W; N = W (1 + a/g)"),
    ("vertical", "vertical acceleration a of the ground"),
];

/// The key of a normal force that other parts have.
pub(crate) const PRESSING: Keys = &[(
    "contact",
    "name of an impact contact or of a spring, or a list of names: N is the sum of max(-S, 0), with their S at the start of each step",
)];

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
        "unit of a record: g, m/s2, cm/s2 or mm/s2; if left out, that of the file",
    ),
    (
        "mean",
        "mean of a record: \"removed\" (if left out, for K-NET) or \"kept\" (for others)",
    ),
    (
        "column",
        "column of a table with the accelerations, from 1; t and a if left out",
    ),
    ("dt", "time step in s of a table without times"),
    ("component", "component of a file with several, from 1"),
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
    ("scale_to", "strength of the motion from start to end"),
    ("delay", "time by which all is later; 0 before"),
];

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
        "damping ratio of \"Sa\" and \"spectrum\"; 0.05 if left out",
    ),
    (
        "unit",
        "unit of the accelerations, as of a record; that of the study if left out",
    ),
];

/// Keys of a target spectrum: one of these, or those of a table.
pub(crate) const SPECTRUM: Keys = &[
    (
        "EN 1998-1",
        "elastic response spectrum of EN 1998-1:2004, (3.2) to (3.6)",
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

/// Number of the keys of [`FUNCTION`] of which one is needed.
pub(crate) const FUNCTIONS: usize = 5;

/// Key of the files of an axis of records.
pub(crate) const FILES: Keys = &[(
    "files",
    "a folder (without .md), or a pattern with one *, such as \"records/*.smc\"; in the order of names",
)];

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

/// Keys of `pulse`.
pub(crate) const PULSE: Keys = &[
    (
        "ricker",
        "a (1 - 2 x) exp(-x), x = (pi f (t - at))^2, from 0 to 2 at",
    ),
    ("cosine", "one sine cycle"),
];

/// Meaning of `sampled`. The last sample is at the end also where the end is no multiple.
const SAMPLED: &str = "time between samples, straight between, the last one at the end; then 0";

/// Keys of `ricker`.
pub(crate) const RICKER: Keys = &[
    ("amplitude", "a"),
    ("frequency", "f"),
    ("at", "time of the peak"),
    ("sampled", SAMPLED),
];

/// Keys of `cosine`.
pub(crate) const COSINE: Keys = &[
    ("amplitude", "amplitude"),
    ("period", "length of the cycle"),
    ("sampled", SAMPLED),
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

/// Keys of static loads besides names.
pub(crate) const STATIC: Keys = &[GRAVITY];

/// The key of gravity.
pub(crate) const GRAVITY: (&str, &str) = (
    "gravity",
    "acceleration of all masses: a number in y, or an object with x, y and z; -9.81 in y is weight",
);

/// Keys of a start.
pub(crate) const START: Keys = &[("u", "displacement"), ("v", "velocity")];

/// Keys of `measured`.
pub(crate) const MEASURED: Keys = &[
    (
        "file",
        "CSV file with a line of names above its columns, its path relative to the study; a parameter that chooses it; or {\"files\": ...} as an axis",
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
];

/// Keys of a column of `measured`.
pub(crate) const COLUMN: Keys = &[
    ("column", "its name in the file"),
    (
        "unit",
        "its unit, such as mm, kip, g or mm/s; if left out, that of the study",
    ),
];

/// Names of the references.
pub(crate) const REFERENCES: [&str; 2] = ["softened", "rigid"];

/// Names of the stiffnesses of damping.
pub(crate) const DAMPING_STIFFNESSES: [&str; 2] = ["without-contacts", "initial"];

/// The names of keys.
pub(crate) fn names(keys: Keys) -> Vec<&'static str> {
    keys.iter().map(|key| key.0).collect()
}
