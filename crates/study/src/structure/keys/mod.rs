//! The keys of a structure in a study, from which it is decoded, and schema and pages are made.

mod contacts;
mod functions;
mod kinds;
mod measured;
mod motions;
mod parts;
mod spectra;

pub(crate) use contacts::{CONTACT, LAW_TABLE, LISTS, NORMAL_TABLE, PART, PRESSING, WEIGHT};
pub(crate) use functions::{
    AS_GROUND, FILES, FUNCTION, FUNCTIONS, LOAD, MOST, PULSE, SINE, SYNTHETIC, TABLE,
};
pub(crate) use kinds::COLUMN;
pub(crate) use measured::{KEY, MEASURED};
pub(crate) use motions::{
    ACCELERATIONS, DIRECTIONS, DISPLACEMENT, GROUND, IMPOSED, IMPOSED_BY_FILE, IMPOSED_SINE,
    IN_DIRECTION, OF_SUPPORT, SUPPORT, VELOCITY,
};
pub(crate) use parts::{BAR, MASS, MATRICES, RAYLEIGH, REDUCE, SPRING};
pub(crate) use spectra::{
    ASCE_7, CHOOSE, EN_1998, GOALS, OF_GROUND, RULES, Rule, SCALE_TO, SET, SPECTRUM, STATISTICS,
    TARGET, TARGET_TABLE, TOGETHER,
};

use crate::source::field::Kind::{
    Like, Likely, List, Named, Number, Object, OneOf, Parts, Several, Shared, Words,
};
use crate::source::field::{ANY, Field, Keys, Usual, field, fields};
use slipgap_problem::problem::numbers::parameter::Range::{self, NotNegative, UpToOne};

/// The reference of the softened laws.
pub(crate) const SOFTENED: &str = "softened";

/// Four names, of which the first is no usual unit of force or length and the second none of mass: an editor shows a wrong order. The
/// reader compares the sizes of all.
const FOUR_UNITS: &str = "^\\s*(?!([kMGm]?N|daN|kip|lbf|mm|cm|m)\\s*,)[^,]+,\\s*(?!(t|kg|Mg|slug|m|mm)\\s*,)[^,]+,[^,]+,[^,]+$";

/// The key of damping ratios of modes.
pub(crate) const MODAL_DAMPING: &str = "modal_damping";

/// A structure.
pub(crate) const STRUCTURE: Keys = Keys::new(&fields![
    /// units of mass, force, length and time, such as "t, kN, m, s"; only records are converted
    field("units", Like(FOUR_UNITS)),
    /// lumped masses: a node for each name, "a|b" two alike; a mass of 0 is held by springs or contacts
    field("masses", Parts(&OneOf(&[Number(NotNegative), Object(&MASS),
]))),
    /// bars of n elements, with the nodes NAME.left, NAME.1, .., NAME.right; "a|b|c" is three alike
    field("bars", Parts(&Object(&BAR))),
    /// M, K and C in Matrix Market files, with the nodes NAME.NODE.DIRECTION
    field("matrices", Parts(&Object(&MATRICES))),
    /// springs with dashpots; "ground" is a node, too
    field("springs", List(&Object(&SPRING), [0, ANY])),
    /// C += mass M + stiffness K, with the factors or with damping ratios of two modes
    field("rayleigh", Object(&RAYLEIGH)),
    /// damping ratio of every mode, or a list from the longest period on; further modes have none
    field(MODAL_DAMPING, Several(&Likely(NotNegative, UpToOne), [0, ANY])),
    /// K of rayleigh and modal_damping: "without-contacts" (default), or "initial" with elastic contacts
    field("damping_stiffness", Words("stiffness", || vec!["without-contacts", "initial"], Some(Usual))),
    /// contacts by name
    field("contacts", Parts(&Shared("contact"))),
    /// forces on nodes, on each node of a bar, or of matrices in a direction, as tower.x
    field("loads", List(&Object(&LOAD), [0, ANY])),
    /// acceleration of the ground in x, or an object with x, y and z; u is then relative to the ground
    field("ground", OneOf(&[Shared("function"), Object(&GROUND),
])),
    /// supports with motions of their own: nodes NAME, NAME.x, NAME.y, NAME.z; u is then absolute
    field("supports", Parts(&Object(&SUPPORT))),
    /// loads that act before t = 0 and stay; the structure starts in equilibrium with them
    field("static", Shared("static")),
    /// acceleration of all masses from t = 0 on, without the equilibrium of `static`: masses fall
    GRAVITY,
    /// displacement and velocity at t = 0 of nodes, bars, or matrices in a direction
    field("start", Named(&Object(&START))),
    /// the exact motion in histories, figures and errors: "softened" or "rigid" laws
    field("contacts_reference", Words("reference", || vec![SOFTENED, "rigid"], None)),
]);

/// Static loads besides names.
pub(crate) const STATIC: Keys = Keys::new(&[GRAVITY]);

/// The key of gravity.
pub(crate) const GRAVITY: Field = field(
    "gravity",
    OneOf(&[Number(Range::Any), Object(&ACCELERATIONS)]),
)
.means("acceleration of all masses: a number in y (-9.81 is weight), or an object with x, y and z");

/// A start.
pub(crate) const START: Keys = Keys::new(&fields![
    /// displacement
    field("u", Number(Range::Any)),
    /// velocity
    field("v", Number(Range::Any)),
]);
