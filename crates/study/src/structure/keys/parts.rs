//! The keys of masses, bars, matrices and springs.

use super::Keys;

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
        "forces",
        "CSV file with lines name,quantity and cells dof:factor, or its content: sums of displacements of rows that are a force or a moment of members, channels NAME.FORCE",
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
    (
        "ratios",
        "instead: two damping ratios, from which both factors follow",
    ),
    (
        "modes",
        "the two modes with these ratios: numbers from 1 by rising frequency, without rigid-body modes",
    ),
    ("periods", "or their natural periods"),
];
