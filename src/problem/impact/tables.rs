//! The tables of the bar impact: parameters, metrics, quantities.

use crate::problem::parameter::{Default, Kind, Parameter, Range, Value};
use crate::problem::unit::{Dimension, Unit};
use crate::problem::{self, Budget, Metric, Profile, Quantity, Source};
use std::ops::Range as Rows;

/// A row of the table of parameters that applies always.
const fn row(
    name: &'static str,
    symbol: &'static str,
    unit: &'static str,
    kind: Kind,
    default: Default,
    meaning: &'static str,
) -> Parameter {
    Parameter {
        name,
        symbol,
        unit,
        kind,
        default,
        applies: None,
        meaning,
    }
}

const POSITIVE: Kind = Kind::Number(Range::Positive);
const ELEMENTS: Kind = Kind::Whole {
    min: 1,
    max: 1_000_000,
};
const AS_LEFT: Default = Default::Follows("as the left bar");

const fn is(x: f64) -> Default {
    Default::Is(Value::Number(x))
}

pub(super) static PARAMETERS: [Parameter; 19] = [
    row(
        "gamma",
        "*γ*",
        "1",
        POSITIVE,
        Default::Follows("from k_I; exactly one of the two is given"),
        "stiffness of the impact spring over the stiffness of an element, gamma = k_I L/(n E A) of the left bar [I (16)]",
    ),
    row(
        "k_I",
        "*k*_I_",
        "force/length",
        POSITIVE,
        Default::Follows("from gamma; exactly one of the two is given"),
        "stiffness of the impact spring [I (7)]",
    ),
    row(
        "n",
        "*n*",
        "1",
        ELEMENTS,
        Default::Required,
        "number of elements of a bar",
    ),
    row(
        "dt",
        "Δ*t*/*T*_I_",
        "T_I",
        POSITIVE,
        Default::Required,
        "time step, over the contact duration T_I = 2 L/C0 of the left bar; at most duration",
    ),
    row(
        "duration",
        "*t*_end_/*T*_I_",
        "T_I",
        POSITIVE,
        Default::Required,
        "end of the motion, over T_I",
    ),
    row(
        "gap",
        "gap/(*cT*_I_/2)",
        "c T_I/2",
        Kind::Number(Range::NotNegative),
        is(0.0),
        "distance between the facing ends at t = 0, over c T_I/2; c is the closing speed; at 0 the ends touch",
    ),
    row(
        "mass",
        "mass",
        "1",
        Kind::Choice(&[
            (
                "lumped",
                "half of the mass of an element at each of its nodes",
            ),
            ("consistent", "from the shape functions of the displacement"),
        ]),
        Default::Is(Value::Name("lumped")),
        "mass matrix of the bars",
    ),
    row(
        "E",
        "*E*",
        "force/length^2",
        POSITIVE,
        is(100.0),
        "Young's modulus of the left bar",
    ),
    row(
        "A",
        "*A*",
        "length^2",
        POSITIVE,
        is(1.0),
        "cross-section of the left bar",
    ),
    row(
        "rho",
        "*ρ*",
        "mass/length^3",
        POSITIVE,
        is(0.01),
        "density of the left bar ([I] prints 0.1, but its T_I = 0.2 needs 0.01); scaled results do not depend on it if right.rho is left out",
    ),
    row(
        "L",
        "*L*",
        "length",
        POSITIVE,
        is(10.0),
        "length of the left bar",
    ),
    row(
        "V0",
        "*V*_0_",
        "length/time",
        Kind::Number(Range::Any),
        is(0.1),
        "velocity of the left bar at t = 0, positive to the right; the bars must close",
    ),
    row(
        "right",
        "right",
        "1",
        Kind::Choice(&[("wall", "a rigid wall instead of the right bar")]),
        Default::Follows("a bar"),
        "what the left bar meets: an object with the data of the right bar that differ, or \"wall\"",
    ),
    row(
        "right.E",
        "*E*_R_",
        "force/length^2",
        POSITIVE,
        AS_LEFT,
        "Young's modulus of the right bar",
    ),
    row(
        "right.A",
        "*A*_R_",
        "length^2",
        POSITIVE,
        AS_LEFT,
        "cross-section of the right bar",
    ),
    row(
        "right.rho",
        "*ρ*_R_",
        "mass/length^3",
        POSITIVE,
        AS_LEFT,
        "density of the right bar",
    ),
    row(
        "right.L",
        "*L*_R_",
        "length",
        POSITIVE,
        AS_LEFT,
        "length of the right bar",
    ),
    row(
        "right.n",
        "*n*_R_",
        "1",
        ELEMENTS,
        AS_LEFT,
        "number of elements of the right bar",
    ),
    row(
        "right.V0",
        "*V*_0R_",
        "length/time",
        Kind::Number(Range::Any),
        Default::Follows("minus the V0 of the left bar"),
        "velocity of the right bar at t = 0, positive to the right",
    ),
];

const fn metric(
    name: &'static str,
    symbol: &'static str,
    unit: &'static str,
    meaning: &'static str,
) -> Metric {
    Metric {
        name,
        symbol,
        unit,
        meaning,
        default: true,
    }
}

/// A column that only those studies have that ask for it.
const fn part(
    name: &'static str,
    symbol: &'static str,
    unit: &'static str,
    meaning: &'static str,
) -> Metric {
    Metric {
        default: false,
        ..metric(name, symbol, unit, meaning)
    }
}

/// Rows that every case is read by.
pub(super) mod rows {
    use super::PARAMETERS;
    use crate::problem::parameter::row_of;

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

    /// What the right bar has as the left one where it is not said.
    pub const FOLLOWS: [[usize; 2]; 6] = [
        [RIGHT_E, E],
        [RIGHT_A, A],
        [RIGHT_RHO, RHO],
        [RIGHT_L, L],
        [RIGHT_N, N],
        [RIGHT_V0, V0],
    ];
}

/// The scales of an impact.
pub(super) static SCALES: [[&str; 2]; 4] = [
    [
        "T_I",
        "2 L/C0 of the left bar, C0 = sqrt(E/ρ): time in which a wave travels through the bar and back; contact duration of two equal bars",
    ],
    [
        "c",
        "closing speed: velocity of the left bar minus velocity of the right bar before the impact",
    ],
    ["Z", "A sqrt(E ρ), impedance of a bar"],
    [
        "F0",
        "c Z1 Z2/(Z1 + Z2), exact contact force of two bars while the wave travels; c Z1 on a wall",
    ],
];

const fn unit(dimension: Dimension, name: &'static str, over: &'static str) -> Unit {
    Unit {
        dimension,
        name,
        over,
    }
}

/// The units of metrics and quantities.
pub(super) static UNITS: [Unit; 4] = [
    unit(Dimension::Time, "T_I", "/*T*_I_"),
    unit(Dimension::Length, "c T_I/2", "/(*cT*_I_/2)"),
    unit(Dimension::Velocity, "c", "/*c*"),
    unit(Dimension::Force, "F0", "/*F*_0_"),
];

pub(super) static METRICS: [Metric; 27] = [
    metric(
        "contact_duration",
        "contact duration/*T*_I_",
        "T_I",
        "time from the first zero of r (falling) to the last zero of r (rising), with r interpolated linearly between steps; undefined without contact, and if the bars still touch at the end",
    ),
    metric(
        "contact_steps",
        "contact in whole steps/*T*_I_",
        "T_I",
        "contact_duration in whole steps: first step with r >= 0 after the last step with r < 0, minus last step with r >= 0 before the first step with r < 0; undefined without contact, and if the bars still touch at the end",
    ),
    metric(
        "separations",
        "separations",
        "1",
        "number of openings that close again, both within 0.9 exact contact durations after the exact first touch; undefined without contact",
    ),
    metric(
        "max_overlap",
        "max. overlap/(*cT*_I_/2)",
        "c T_I/2",
        "max(-r); undefined without contact",
    ),
    metric(
        "rdot_oscillation",
        "rms of *ṙ*/*c* in contact",
        "c",
        "root mean square of rdot - exact rdot over the steps from 0.3 to 0.9 exact contact durations after the exact first touch; undefined without contact",
    ),
    metric(
        "peak_force",
        "peak of *F*/*F*_0_",
        "F0",
        "max force; undefined without contact",
    ),
    metric(
        "impulse_error",
        "impulse error",
        "1",
        "impulse (trapezoidal rule) over the exact impulse, minus 1; needs a duration beyond the exact separation",
    ),
    metric(
        "restitution",
        "restitution",
        "1",
        "relative velocity of the mass centres at the end, over c; undefined without contact",
    ),
    metric(
        "energy_drift_max",
        "max. energy drift",
        "1",
        "(E - E_0)/E_0 of the largest magnitude; E is the energy of bars and spring in the frame of the common mass centre",
    ),
    metric(
        "energy_drift_final",
        "final energy drift",
        "1",
        "(E - E_0)/E_0 at the last step",
    ),
    metric(
        "rms_error_r",
        "rms error of *r*/(*cT*_I_/2)",
        "c T_I/2",
        "sqrt(1/duration times the integral of (c - e)^2) of r, trapezoidal rule",
    ),
    metric(
        "rms_error_rdot",
        "rms error of *ṙ*/*c*",
        "c",
        "sqrt(1/duration times the integral of (c - e)^2) of rdot, trapezoidal rule; at a jump of e, each side has its own limit",
    ),
    part(
        "regularisation_error_r",
        "regularisation error of *r*/(*cT*_I_/2)",
        "c T_I/2",
        "error of the softened law alone: rms_error_r of continuous bars on the impact spring, compared with e; equal bars, gamma n >= 0.404, n <= 1000, gamma n^2 <= 10^20",
    ),
    part(
        "regularisation_error_rdot",
        "regularisation error of *ṙ*/*c*",
        "c",
        "error of the softened law alone: rms_error_rdot of continuous bars on the impact spring, compared with e; equal bars, gamma n >= 0.404, n <= 1000, gamma n^2 <= 10^20",
    ),
    part(
        "mesh_error_r",
        "mesh error of *r*/(*cT*_I_/2)",
        "c T_I/2",
        "error of the mesh alone: rms_error_r of the elements in continuous time, compared with continuous bars on the impact spring; equal bars, gamma n >= 0.404, n <= 1000, gamma n^2 <= 10^20",
    ),
    part(
        "mesh_error_rdot",
        "mesh error of *ṙ*/*c*",
        "c",
        "error of the mesh alone: rms_error_rdot of the elements in continuous time, compared with continuous bars on the impact spring; equal bars, gamma n >= 0.404, n <= 1000, gamma n^2 <= 10^20",
    ),
    part(
        "step_error_r",
        "step error of *r*/(*cT*_I_/2)",
        "c T_I/2",
        "error of the time step alone: rms_error_r of c, compared with the elements in continuous time; equal bars, gamma n >= 0.404, n <= 1000, gamma n^2 <= 10^20",
    ),
    part(
        "step_error_rdot",
        "step error of *ṙ*/*c*",
        "c",
        "error of the time step alone: rms_error_rdot of c, compared with the elements in continuous time; equal bars, gamma n >= 0.404, n <= 1000, gamma n^2 <= 10^20",
    ),
    part(
        "regularisation_share_r",
        "regularisation share of *r*",
        "1",
        "share of this part in the error of r: mean of (part) (c - e) over mean of (c - e)^2; the three shares add up to 1; a share outside 0..1 means that parts have opposite signs",
    ),
    part(
        "regularisation_share_rdot",
        "regularisation share of *ṙ*",
        "1",
        "share of this part in the error of rdot: mean of (part) (c - e) over mean of (c - e)^2; the three shares add up to 1; a share outside 0..1 means that parts have opposite signs",
    ),
    part(
        "mesh_share_r",
        "mesh share of *r*",
        "1",
        "share of this part in the error of r: mean of (part) (c - e) over mean of (c - e)^2; the three shares add up to 1; a share outside 0..1 means that parts have opposite signs",
    ),
    part(
        "mesh_share_rdot",
        "mesh share of *ṙ*",
        "1",
        "share of this part in the error of rdot: mean of (part) (c - e) over mean of (c - e)^2; the three shares add up to 1; a share outside 0..1 means that parts have opposite signs",
    ),
    part(
        "step_share_r",
        "step share of *r*",
        "1",
        "share of this part in the error of r: mean of (part) (c - e) over mean of (c - e)^2; the three shares add up to 1; a share outside 0..1 means that parts have opposite signs",
    ),
    part(
        "step_share_rdot",
        "step share of *ṙ*",
        "1",
        "share of this part in the error of rdot: mean of (part) (c - e) over mean of (c - e)^2; the three shares add up to 1; a share outside 0..1 means that parts have opposite signs",
    ),
    part(
        "contact_duration_exact",
        "exact contact duration/*T*_I_",
        "T_I",
        "contact_duration of the exact motion; undefined without contact, and if the bars still touch at the end",
    ),
    part(
        "peak_force_exact",
        "exact peak of *F*/*F*_0_",
        "F0",
        "peak_force of the exact motion; undefined without contact",
    ),
    part(
        "restitution_exact",
        "exact restitution",
        "1",
        "restitution of the exact motion, from its impulse until the last step; undefined without contact",
    ),
];

const fn quantity(name: &'static str, title: &'static str, source: Source) -> Quantity {
    Quantity {
        name,
        title,
        source,
    }
}

pub(super) static QUANTITIES: [Quantity; 5] = [
    quantity("r", "*r*/(*cT*_I_/2)", Source::Displacement),
    quantity("rdot", "*ṙ*/*c*", Source::Velocity),
    quantity("force", "*F*/*F*_0_", Source::Force),
    quantity("r_error", "*r* − *r*_exact_", Source::DisplacementError),
    quantity("rdot_error", "*ṙ* − *ṙ*_exact_", Source::VelocityError),
];

pub(super) static PROFILES: [Profile; 2] = [
    Profile {
        name: "velocity",
        title: "*v*/(*c*/2)",
    },
    Profile {
        name: "stress",
        title: "*σ*/(*F*_0_/*A*)",
    },
];

const fn metric_of(name: &str) -> usize {
    problem::metric_of(&METRICS, name)
}

/// Rows of what the errors are made of.
pub(super) const BUDGET: Rows<usize> =
    metric_of("regularisation_error_r")..metric_of("step_share_rdot") + 1;

/// Rows of what the exact motion has.
pub(super) const REFERENCE: Rows<usize> =
    metric_of("contact_duration_exact")..metric_of("restitution_exact") + 1;

/// Empty exactly where no contact happens.
pub(super) const MAX_OVERLAP: usize = metric_of("max_overlap");

pub(super) static BUDGETS: [Budget; 2] = [
    Budget {
        name: "r",
        title: "rms error of *r*/(*cT*_I_/2)",
        total: metric_of("rms_error_r"),
        parts: &[
            ("regularisation", metric_of("regularisation_error_r")),
            ("mesh", metric_of("mesh_error_r")),
            ("step", metric_of("step_error_r")),
        ],
    },
    Budget {
        name: "rdot",
        title: "rms error of *ṙ*/*c*",
        total: metric_of("rms_error_rdot"),
        parts: &[
            ("regularisation", metric_of("regularisation_error_rdot")),
            ("mesh", metric_of("mesh_error_rdot")),
            ("step", metric_of("step_error_rdot")),
        ],
    },
];
