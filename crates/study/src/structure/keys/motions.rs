//! The keys of the ground and of supports.

use super::functions::{FUNCTIONS, OF_FUNCTION, OF_KINDS, SINE};
use super::kinds::{ANY_NUMBER, ANY_NUMBERS, BASELINE, COLUMN_KIND, FUNCTION_OF_TIME};
use super::spectra::OF_GROUND;
use crate::source::field::Kind::{self, Number, Object, OneOf, Text, Words};
use crate::source::field::{Field, Keys, Rule, field, fields, needed};
use slipgap_problem::problem::numbers::parameter::Range::NotNegative;
use slipgap_problem::problem::structure::given::supports::Line;

/// The directions x, y and z with these values.
const fn directions(kind: Kind) -> [Field; 3] {
    fields![
        /// acceleration in x
        field("x", kind),
        /// acceleration in y
        field("y", kind),
        /// acceleration in z
        field("z", kind),
    ]
}

/// The keys of directions.
pub(crate) const DIRECTIONS: [&str; 3] = ["x", "y", "z"];

/// A number in each direction.
pub(crate) const ACCELERATIONS: Keys = Keys::new(&directions(ANY_NUMBER));

/// A motion of the ground in each direction.
pub(crate) const GROUND: Keys = Keys::new(&directions(FUNCTION_OF_TIME))
    .and(&[OF_GROUND])
    .rules(&[
        Rule::Any(&DIRECTIONS, &[]),
        Rule::With(&["scale_to"], &[Rule::Has(&["x", "y"])]),
    ]);

/// Imposed displacements.
pub(crate) const IMPOSED: Keys = Keys::new(&fields![
    /// times, rising
    needed("t", ANY_NUMBERS),
    /// displacements, the first one 0
    needed("u", ANY_NUMBERS),
    BETWEEN,
]);

/// The line between two points.
const BETWEEN: Field = field("between", Words("line", || Line::ALL.map(Line::name).to_vec(), None))
    .means("\"cubic\" (default), which turns only at points, or \"straight\", whose velocity jumps at points");

/// An imposed displacement that is a sine.
pub(crate) const IMPOSED_SINE: Keys = Keys::new(&fields![
    /// amplitude (sin(omega t + phase) - sin(phase)), without drift
    needed("sine", Object(&SINE)),
]);

/// Imposed displacements of a file: three keys that only these have, and the line.
pub(crate) const IMPOSED_BY_FILE: Keys = Keys::new(&fields![
    /// CSV file as of `measured`, or a parameter that chooses it
    needed("file", Text),
    /// name of the column of times, or an object with its unit
    needed("time", COLUMN_KIND),
    /// the same of displacements; u is the column less its first number
    needed("column", COLUMN_KIND),
    BETWEEN,
]);

/// The key of imposed displacements.
pub(crate) const DISPLACEMENT: Field = field(
    "displacement",
    OneOf(&[
        Object(&IMPOSED),
        Object(&IMPOSED_BY_FILE),
        Object(&IMPOSED_SINE),
    ]),
)
.means("instead of an acceleration, here or under a direction");

/// The key of the velocity at the start.
pub(crate) const VELOCITY: Field = field("velocity", ANY_NUMBER)
    .means("velocity at t = 0, here or under a direction; without an acceleration it is constant");

/// The keys of a support besides those of a function and the directions.
pub(crate) const OF_SUPPORT: &[Field] = &fields![
    DISPLACEMENT,
    VELOCITY,
    /// time by which all is later; at rest before
    field("delay", Number(NotNegative)),
    /// as of a function; with "linear" the support rests after the end
    field("baseline", BASELINE),
];

/// A support.
pub(crate) const SUPPORT: Keys = Keys::new(OF_FUNCTION)
    .and(&directions(OneOf(&[
        FUNCTION_OF_TIME,
        Object(&Keys::new(&[DISPLACEMENT.needed()])),
        Object(
            &Keys::new(OF_FUNCTION)
                .and(&[VELOCITY.needed()])
                .rules(&OF_KINDS),
        ),
    ])))
    .and(OF_SUPPORT)
    .rules(&[
        OF_KINDS[0],
        OF_KINDS[1],
        Rule::One(
            &COURSES,
            &[
                &[Rule::Any(&DIRECTIONS, &[])],
                &[Rule::Has(&["velocity"]), Rule::No(&COURSES)],
            ],
        ),
    ]);

/// How a support moves.
const COURSES: [&str; 6] = {
    let [a, b, c, d, e] = FUNCTIONS;
    [a, b, c, d, e, DISPLACEMENT.name]
};

/// A direction of a support.
pub(crate) const IN_DIRECTION: Keys = Keys::new(OF_FUNCTION).and(&[DISPLACEMENT, VELOCITY]);
