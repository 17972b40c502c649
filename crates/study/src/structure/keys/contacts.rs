//! The keys of contacts and of their laws.

use super::kinds::{ANY_NUMBERS, BETWEEN_KIND, FUNCTION_OF_TIME};
use crate::source::field::{ANY, Field, Keys, Kind, Rule, field, fields, needed};
use slipgap_contact::contact::number::Number;
use slipgap_problem::problem::numbers::parameter::Range;
use slipgap_problem::problem::structure::parts::contact_law::{NAMES, NUMBERS, meaning};
use std::sync::LazyLock;

/// A contact: the keys of all, the numbers of the laws, and lists of laws.
pub(crate) static CONTACT: LazyLock<Keys> = LazyLock::new(|| {
    const RULES: [Rule; 5] = {
        let [first, second, third] = OF_LAWS;
        let plane = Rule::With(&["plane"], &[Rule::No(&["gap"])]);
        let two = Rule::With(&["directions"], &[Rule::No(&["gap", "along", "pairs"])]);
        [first, second, third, plane, two]
    };
    Keys::new(OF_CONTACT)
        .and(numbers())
        .and(&LISTS)
        .rules(&RULES)
});

/// A law in a list of laws.
pub(crate) static PART: LazyLock<Keys> = LazyLock::new(|| {
    Keys::new(OF_LAW)
        .and(numbers())
        .and(&INNER_LISTS)
        .rules(&OF_LAWS)
});

const OF_LAW: &[Field] = &fields![
    LAW,
    /// r at rest of this law
    field("gap", NUMBER),
];

const NUMBER: Kind = Kind::Number(Range::Any);

const LAW: Field = field(
    "law",
    Kind::OneOf(&[Kind::Meant(|| NAMES), Kind::Chooses(|| NAMES)]),
)
.means("law of the contact, or a parameter that chooses it");

/// What the numbers of laws need of each other.
const OF_LAWS: [Rule; 3] = [
    Rule::With(&["nu_min"], &[Rule::Has(&["nu_rate"])]),
    Rule::With(&["nu_rate"], &[Rule::Has(&["nu_min"])]),
    Rule::With(&["pressure_exponent"], &[Rule::Has(&["N"])]),
];

/// The keys that contacts of all laws may have.
const OF_CONTACT: &[Field] = &fields![
    LAW,
    /// nodes I and J; r = u_J - u_I + gap
    field("between", BETWEEN_KIND),
    /// instead of between: nodes with factors, whose sum with u, plus the gap, is r
    field("along", Kind::Factors),
    /// instead of between: CSV file with lines of a name and cells dof:factor, one for each contact NAME.LINE
    field("pairs", Kind::Text),
    /// instead of between: friction in a plane, with nodes I and J for each of two directions; ["ground", "ground"] holds one
    field("plane", Kind::List(&BETWEEN_KIND, [2, 2])),
    /// two of x, y and z: friction in a plane
    field("directions", Kind::Directions),
    /// r at rest
    field("gap", NUMBER),
];

/// A list of laws.
const LAWS: Kind = Kind::List(&Kind::Shared("part"), [2, ANY]);

/// The keys of lists of laws.
pub(crate) const LISTS: [Field; 2] = fields![
    /// instead of law: laws one behind the other, NAME.1, NAME.2, .., with nodes without mass NAME.node1, ..
    field("series", LAWS),
    /// instead of law: laws side by side, NAME.1, NAME.2, ..
    field("parallel", LAWS),
];

/// The same in a list.
const INNER_LISTS: [Field; 2] = fields![
    /// in parallel, instead of law: laws one behind the other, NAME.i.1, .., with nodes NAME.i.node1, ..
    field(LISTS[0].name, LAWS),
    /// in series, instead of law: laws side by side, NAME.i.1, ..; they are laws only
    field(LISTS[1].name, LAWS),
];

/// The numbers of the laws; the normal force and the table are more than a number.
fn numbers() -> &'static [Field] {
    static FIELDS: LazyLock<Vec<Field>> = LazyLock::new(|| {
        let one = |number: &&Number| {
            let kind = match number.key {
                "N" => NORMAL_FORCE,
                "table" => Kind::Object(&LAW_TABLE),
                _ => Kind::Number(number.range),
            };
            field(number.key, kind).means(meaning(number).leak())
        };
        NUMBERS.iter().map(one).collect()
    });
    &FIELDS
}

/// A normal force: a number, a table, a weight, or the force of other contacts and springs.
const NORMAL_FORCE: Kind = Kind::OneOf(&[
    NUMBER,
    Kind::Object(&NORMAL_TABLE),
    Kind::Object(&WEIGHT),
    Kind::Object(&PRESSING),
]);

/// A table of normal forces.
pub(crate) const NORMAL_TABLE: Keys = Keys::new(&fields![
    /// times
    needed("t", ANY_NUMBERS),
    /// forces at these times
    needed("N", ANY_NUMBERS),
]);

/// The table of a law.
pub(crate) const LAW_TABLE: Keys = Keys::new(&fields![
    /// deflections
    needed("r", ANY_NUMBERS),
    /// forces at these deflections
    needed("S", ANY_NUMBERS),
]);

/// A weight under vertical acceleration.
pub(crate) const WEIGHT: Keys = Keys::new(&fields![
    /// W; N = W (1 + a/g)
    needed("weight", Kind::Number(Range::Positive)),
    /// vertical acceleration a of the ground
    needed("vertical", FUNCTION_OF_TIME),
]);

/// A normal force that other parts have.
pub(crate) const PRESSING: Keys = Keys::new(&fields![
    /// impact contact or spring, or a list of these: N is the sum of max(-S, 0) at the end of each step
    needed("contact", Kind::Several(&Kind::Text, [1, ANY])),
]);
