//! The parameters of the bar impact.

use crate::problem::Case;
use crate::problem::numbers::choice::choice;
use crate::problem::numbers::parameter::{Default, Kind, Parameter, Range, Value};
use std::borrow::Cow::Borrowed;

choice! {
    /// Mass matrix of the bars.
    pub enum MassMatrix {
        Lumped = "lumped": "half of an element at each node",
        Consistent = "consistent": "from the shape functions",
        MasslessContact = "massless-contact": "lumped, that of a contact node at its neighbour",
    }
}

impl MassMatrix {
    /// The choice of a case.
    pub fn of(case: &Case) -> Option<MassMatrix> {
        MassMatrix::parse(case.name_at(rows::MASS))
    }
}

choice! {
    /// What the left bar meets, if not a right bar.
    pub enum Opposite {
        Wall = "wall": "a rigid wall instead of the right bar",
    }
}

impl Opposite {
    /// The choice of a case; `None` for a right bar.
    pub fn of(case: &Case) -> Option<Opposite> {
        Opposite::parse(case.name_at(rows::RIGHT))
    }
}

const POSITIVE: Kind = Kind::Number(Range::Positive);
const ELEMENTS: Kind = Kind::Whole {
    min: 1,
    max: 1_000_000,
};
const AS_LEFT: Default = Default::Follows(Borrowed("as the left bar"));

const fn is(x: f64) -> Default {
    Default::Is(Value::Number(x))
}

pub(super) static PARAMETERS: [Parameter; 19] = [
    Parameter::new(
        ["gamma", "*γ*", "1"],
        POSITIVE,
        Default::Follows(Borrowed("from k_I; one of the two is given")),
        "stiffness of the spring over that of an element of the left bar, k_I L/(n E A) [I (16)]",
    ),
    Parameter::new(
        ["k_I", "*k*_I_", "force/length"],
        POSITIVE,
        Default::Follows(Borrowed("from gamma; one of the two is given")),
        "stiffness of the impact spring [I (7)]",
    ),
    Parameter::new(
        ["n", "*n*", "1"],
        ELEMENTS,
        Default::Required,
        "number of elements of a bar",
    ),
    Parameter::new(
        ["dt", "Δ*t*/*T*_I_", "T_I"],
        POSITIVE,
        Default::Required,
        "time step; at most duration",
    ),
    Parameter::new(
        ["duration", "*t*_end_/*T*_I_", "T_I"],
        POSITIVE,
        Default::Required,
        "end of the motion, over T_I",
    ),
    Parameter::new(
        ["gap", "gap/(*cT*_I_/2)", "c T_I/2"],
        Kind::Number(Range::NotNegative),
        is(0.0),
        "distance of the facing ends at t = 0",
    ),
    Parameter::new(
        ["mass", "mass", "1"],
        MassMatrix::KIND,
        Default::Is(Value::Name("lumped")),
        "mass matrix of the bars",
    ),
    Parameter::new(
        ["E", "*E*", "force/length^2"],
        POSITIVE,
        is(100.0),
        "Young's modulus of the left bar",
    ),
    Parameter::new(
        ["A", "*A*", "length^2"],
        POSITIVE,
        is(1.0),
        "cross-section of the left bar",
    ),
    Parameter::new(
        ["rho", "*ρ*", "mass/length^3"],
        POSITIVE,
        is(0.01),
        "density of the left bar",
    ),
    Parameter::new(
        ["L", "*L*", "length"],
        POSITIVE,
        is(10.0),
        "length of the left bar",
    ),
    Parameter::new(
        ["V0", "*V*_0_", "length/time"],
        Kind::Number(Range::Any),
        is(0.1),
        "velocity of the left bar at t = 0, positive to the right",
    ),
    Parameter::new(
        ["right", "right", "1"],
        Opposite::KIND,
        Default::Follows(Borrowed("a bar")),
        "what the left bar meets: \"wall\", or an object with what differs in the right bar",
    ),
    Parameter::new(
        ["right.E", "*E*_R_", "force/length^2"],
        POSITIVE,
        AS_LEFT,
        "Young's modulus of the right bar",
    ),
    Parameter::new(
        ["right.A", "*A*_R_", "length^2"],
        POSITIVE,
        AS_LEFT,
        "cross-section of the right bar",
    ),
    Parameter::new(
        ["right.rho", "*ρ*_R_", "mass/length^3"],
        POSITIVE,
        AS_LEFT,
        "density of the right bar",
    ),
    Parameter::new(
        ["right.L", "*L*_R_", "length"],
        POSITIVE,
        AS_LEFT,
        "length of the right bar",
    ),
    Parameter::new(
        ["right.n", "*n*_R_", "1"],
        ELEMENTS,
        AS_LEFT,
        "number of elements of the right bar",
    ),
    Parameter::new(
        ["right.V0", "*V*_0R_", "length/time"],
        Kind::Number(Range::Any),
        Default::Follows(Borrowed("minus the V0 of the left bar")),
        "velocity of the right bar at t = 0, positive to the right",
    ),
];

/// Rows of the parameters.
pub mod rows {
    use super::PARAMETERS;
    use crate::problem::numbers::parameter::row_of;

    pub const GAMMA: usize = row_of(&PARAMETERS, "gamma");
    pub const K_I: usize = row_of(&PARAMETERS, "k_I");
    pub const N: usize = row_of(&PARAMETERS, "n");
    pub const DT: usize = row_of(&PARAMETERS, "dt");
    pub const DURATION: usize = row_of(&PARAMETERS, "duration");
    pub const GAP: usize = row_of(&PARAMETERS, "gap");
    pub const MASS: usize = row_of(&PARAMETERS, "mass");
    pub const E: usize = row_of(&PARAMETERS, "E");
    pub const A: usize = row_of(&PARAMETERS, "A");
    pub const RHO: usize = row_of(&PARAMETERS, "rho");
    pub const L: usize = row_of(&PARAMETERS, "L");
    pub const V0: usize = row_of(&PARAMETERS, "V0");
    pub const RIGHT: usize = row_of(&PARAMETERS, "right");
    pub const RIGHT_E: usize = row_of(&PARAMETERS, "right.E");
    pub const RIGHT_A: usize = row_of(&PARAMETERS, "right.A");
    pub const RIGHT_RHO: usize = row_of(&PARAMETERS, "right.rho");
    pub const RIGHT_L: usize = row_of(&PARAMETERS, "right.L");
    pub const RIGHT_N: usize = row_of(&PARAMETERS, "right.n");
    pub const RIGHT_V0: usize = row_of(&PARAMETERS, "right.V0");

    /// Parameters of the right bar that are equal to those of the left one if not given.
    pub const FOLLOWS: [[usize; 2]; 6] = [
        [RIGHT_E, E],
        [RIGHT_A, A],
        [RIGHT_RHO, RHO],
        [RIGHT_L, L],
        [RIGHT_N, N],
        [RIGHT_V0, V0],
    ];
}
