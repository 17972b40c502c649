//! The keys of contacts and of their laws.

use super::Keys;
use slipgap_contact::contact::number::Number;
use slipgap_problem::problem::structure::parts::contact_law::{NUMBERS, meaning};
use std::sync::LazyLock;

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
    "name of an impact contact or of a spring, or a list of names: N is the sum of max(-S, 0), with their S at the end of each step",
)];
