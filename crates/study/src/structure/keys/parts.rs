//! The keys of masses, bars, matrices and springs.

use super::kinds::{BETWEEN_KIND, NAME};
use crate::source::field::{ANY, Field, Keys, Kind, Rule, Usual, field, needed};
use slipgap_problem::problem::numbers::parameter::Range::{self, NotNegative, Positive};
use slipgap_problem::problem::structure::MOST_NODES;
use slipgap_system::system::structure::Direction;

/// A mass with a direction.
pub(crate) const MASS: Keys = Keys::new(&[
    needed("mass", Kind::Number(NotNegative), "its mass"),
    Field {
        kind: Kind::OneOf(&[DIRECTION.kind, Kind::Directions]),
        ..DIRECTION
    },
]);

/// The direction in which a part moves.
const DIRECTION: Field = field(
    "direction",
    Kind::Words(
        "direction",
        || Direction::TRANSLATIONS.map(Direction::name).to_vec(),
        Some(Usual),
    ),
    "direction of motion, \"x\" (if left out), \"y\" or \"z\"",
);

/// A model of matrices.
pub(crate) const MATRICES: Keys = Keys::new(&[
    needed(
        "M",
        Kind::Text,
        "file of the mass matrix, its content, or a parameter that chooses it; so for K and C",
    ),
    needed("K", Kind::Text, "file of the stiffness matrix"),
    field(
        "C",
        Kind::Text,
        "file of the damping matrix, if there is one",
    ),
    needed(
        "dofs",
        Kind::OneOf(&[
            Kind::Text,
            Kind::List(&Kind::List(&Kind::Any, [2, 5]), [0, ANY]),
        ]),
        "CSV file with the header node,direction, if wanted support and X,Y,Z, and a row for each row of the matrices; or a list of [node, direction] or [node, direction, X, Y, Z]",
    ),
    field(
        "ties",
        Kind::Text,
        "CSV file with lines node,direction and cells dof:factor, or its content: tied dofs as sums of rows, named as nodes are",
    ),
    field(
        "forces",
        Kind::Text,
        "CSV file with lines name,quantity and cells dof:factor, or its content: sums of displacements of rows that are a force or a moment of members, channels NAME.FORCE",
    ),
    field(
        "reduce",
        Kind::Object(&REDUCE),
        "keeps the dofs that the study names, and lowest modes (Craig and Bampton)",
    ),
]);

/// A reduction of matrices.
pub(crate) const REDUCE: Keys = Keys::new(&[
    field(
        "modes",
        Kind::Number(NotNegative),
        "number of modes; all if there are fewer",
    ),
    field(
        "up_to",
        Kind::Number(Positive),
        "the modes up to this frequency in cycles per unit of time",
    ),
])
.rules(&[Rule::One(&["modes", "up_to"], &[])]);

/// A bar.
pub(crate) const BAR: Keys = Keys::new(&[
    needed("L", Kind::Number(Positive), "length"),
    needed("EA", Kind::Number(Positive), "axial stiffness E A"),
    needed(
        "mass",
        Kind::Number(Positive),
        "mass of the whole bar; m/n at each node, half of it at the ends",
    ),
    needed(
        "n",
        Kind::Whole([1, MOST_NODES as u64]),
        "number of elements, each with the stiffness E A n/L",
    ),
    field(
        "stiffness_damping",
        Kind::Number(NotNegative),
        "dashpot of each element over its stiffness; a time",
    ),
    DIRECTION,
]);

/// A spring.
pub(crate) const SPRING: Keys = Keys::new(&[
    field(
        "name",
        NAME,
        "name, with which its force is the channel NAME.S",
    ),
    field("between", BETWEEN_KIND, "two nodes"),
    field(
        "along",
        Kind::Factors,
        "instead of between: nodes with factors, whose sum with u is the extension",
    ),
    field(
        "k",
        Kind::Several(&Kind::Number(Range::Any), [2, 2]),
        "stiffness; below 0 where contacts hold the nodes",
    ),
    field("c", NOT_NEGATIVE, "dashpot"),
    field(
        "mass",
        POSITIVE,
        "mass that has the period; with period and ratio, instead of k and c",
    ),
    field("period", POSITIVE, "k = mass (2 pi/period)^2"),
    field("ratio", NOT_NEGATIVE, "c = 2 ratio (2 pi/period) mass"),
    DIRECTION,
    field(
        "directions",
        Kind::Directions,
        "two of x, y and z: a spring in each between nodes with both, as a.x and a.y; numbers may be lists of two",
    ),
])
.rules(&[Rule::All(&[
    &[Rule::One(&["between", "along"], &[])],
    &[Rule::Any(&[], &[
        &[Rule::All(&[
            &[Rule::Any(&["k", "c"], &[])],
            &[Rule::No(&["mass", "period", "ratio"])],
        ])],
        &[Rule::Has(&["mass", "period"]), Rule::No(&["k", "c"])],
    ])],
])]);

/// A number of a spring, or one for each of two directions.
const POSITIVE: Kind = Kind::Several(&Kind::Number(Positive), [2, 2]);

/// The same of one that may be 0.
const NOT_NEGATIVE: Kind = Kind::Several(&Kind::Number(NotNegative), [2, 2]);

/// Rayleigh damping.
pub(crate) const RAYLEIGH: Keys = Keys::new(&[
    field("mass", Kind::Number(NotNegative), "factor of M, 1 over time"),
    field("stiffness", Kind::Number(NotNegative), "factor of K, a time"),
    field(
        "ratios",
        Kind::List(&Kind::Number(NotNegative), [2, 2]),
        "instead: two damping ratios, from which both factors follow",
    ),
    field(
        "modes",
        Kind::List(&Kind::Number(Positive), [2, 2]),
        "the two modes with these ratios: numbers from 1 by rising frequency, without rigid-body modes",
    ),
    field(
        "periods",
        Kind::List(&Kind::Number(Positive), [2, 2]),
        "or their natural periods",
    ),
])
.rules(&[Rule::Any(&[], &[
    &[Rule::No(&["ratios", "modes", "periods"])],
    &[
        Rule::Has(&["ratios"]),
        Rule::One(&["modes", "periods"], &[]),
        Rule::No(&["mass", "stiffness"]),
    ],
])]);
