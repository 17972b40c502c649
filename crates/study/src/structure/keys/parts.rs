//! The keys of masses, bars, matrices and springs.

use super::kinds::{BETWEEN_KIND, NAME};
use crate::source::field::{ANY, Field, Keys, Kind, Rule, Usual, field, fields, needed};
use slipgap_problem::problem::numbers::parameter::Range::{self, NotNegative, Positive, UpToOne};
use slipgap_problem::problem::structure::MOST_NODES;
use slipgap_system::system::structure::Direction;

/// A mass with a direction.
pub(crate) const MASS: Keys = Keys::new(&fields![
    /// its mass
    needed("mass", Kind::Number(NotNegative)),
    DIRECTION_OR_TWO,
]);

/// The direction in which a mass moves, or two of them.
const DIRECTION_OR_TWO: Field = Field {
    kind: Kind::OneOf(&[DIRECTION.kind, Kind::Directions]),
    ..DIRECTION
};

/// The direction in which a part moves.
const DIRECTION: Field = field(
    "direction",
    Kind::Words(
        "direction",
        || Direction::TRANSLATIONS.map(Direction::name).to_vec(),
        Some(Usual),
    ),
)
.means("direction of motion, \"x\" (default), \"y\" or \"z\"");

/// A model of matrices.
pub(crate) const MATRICES: Keys = Keys::new(&fields![
    /// file of the mass matrix, its content, or a parameter that chooses it; so for K and C
    needed("M", Kind::Text),
    /// file of the stiffness matrix
    needed("K", Kind::Text),
    /// file of the damping matrix, if there is one
    field("C", Kind::Text),
    /// CSV file with the header node,direction (if wanted, support and X,Y,Z) and a line for each row of the matrices; or a list of [node, direction] or [node, direction, X, Y, Z]
    needed("dofs", Kind::OneOf(&[Kind::Text, Kind::List(&Kind::List(&Kind::Any, [2, 5]), [0, ANY]),
])),
    /// CSV file with lines node,direction and cells dof:factor, or its content: degrees of freedom that rigid links or diaphragms tie, as sums of others
    field("ties", Kind::Text),
    /// CSV file with lines name,quantity and cells dof:factor, or its content: sums of displacements that are a force or a moment of members, channels NAME.FORCE
    field("forces", Kind::Text),
    /// keeps the degrees of freedom that the study names, and lowest modes (Craig and Bampton)
    field("reduce", Kind::Object(&REDUCE)),
]);

/// A reduction of matrices.
pub(crate) const REDUCE: Keys = Keys::new(&fields![
    /// number of modes; all if there are fewer
    field("modes", Kind::Whole([0, u32::MAX as u64])),
    /// the modes up to this frequency in cycles per unit of time
    field("up_to", Kind::Number(Positive)),
])
.rules(&[Rule::One(&["modes", "up_to"], &[])]);

/// A bar.
pub(crate) const BAR: Keys = Keys::new(&fields![
    /// length
    needed("L", Kind::Number(Positive)),
    /// axial stiffness E A
    needed("EA", Kind::Number(Positive)),
    /// mass of the whole bar; m/n at each node, half of it at the ends
    needed("mass", Kind::Number(Positive)),
    /// number of elements, each with the stiffness E A n/L
    needed("n", Kind::Whole([1, MOST_NODES as u64])),
    /// dashpot of each element over its stiffness; a time
    field("stiffness_damping", Kind::Number(NotNegative)),
    DIRECTION,
]);

/// A spring.
pub(crate) const SPRING: Keys = Keys::new(&fields![
    /// name, with which its force is the channel NAME.S
    field("name", NAME),
    /// two nodes
    field("between", BETWEEN_KIND),
    /// instead of between: nodes with factors, whose sum with u is the extension
    field("along", Kind::Factors),
    /// stiffness; below 0 where contacts hold the nodes
    field("k", Kind::Several(&Kind::Number(Range::Any), [2, 2])),
    /// dashpot
    field("c", NOT_NEGATIVE),
    /// mass that has the period, instead of k and c
    field("mass", POSITIVE),
    /// k = mass (2 pi/period)^2
    field("period", POSITIVE),
    /// c = 2 ratio (2 pi/period) mass
    field("ratio", RATIO),
    DIRECTION,
    /// two of x, y and z: a spring in each; numbers may be lists of two
    field("directions", Kind::Directions),
])
.rules(&[Rule::All(&[
    &[Rule::One(&["between", "along"], &[])],
    &[Rule::Any(
        &[],
        &[
            &[Rule::All(&[
                &[Rule::Any(&["k", "c"], &[])],
                &[Rule::No(&["mass", "period", "ratio"])],
            ])],
            &[Rule::Has(&["mass", "period"]), Rule::No(&["k", "c"])],
        ],
    )],
])]);

/// A number of a spring, or one for each of two directions.
const POSITIVE: Kind = Kind::Several(&Kind::Number(Positive), [2, 2]);

/// The same of one that may be 0.
const RATIO: Kind = Kind::Several(&Kind::Likely(NotNegative, UpToOne), [2, 2]);
const NOT_NEGATIVE: Kind = Kind::Several(&Kind::Number(NotNegative), [2, 2]);

/// Rayleigh damping.
pub(crate) const RAYLEIGH: Keys = Keys::new(&fields![
    /// factor of M, 1 over time
    field("mass", Kind::Number(NotNegative)),
    /// factor of K, a time
    field("stiffness", Kind::Number(NotNegative)),
    /// instead: two damping ratios, from which both factors follow
    field("ratios", Kind::List(&Kind::Number(NotNegative), [2, 2])),
    /// the two modes with these ratios, from 1 by rising frequency, without rigid-body modes
    field("modes", Kind::List(&Kind::Whole([1, u32::MAX as u64]), [2, 2])),
    /// or their natural periods
    field("periods", Kind::List(&Kind::Number(Positive), [2, 2])),
])
.rules(&[Rule::Any(
    &[],
    &[
        &[Rule::No(&["ratios", "modes", "periods"])],
        &[
            Rule::Has(&["ratios"]),
            Rule::One(&["modes", "periods"], &[]),
            Rule::No(&["mass", "stiffness"]),
        ],
    ],
)]);
