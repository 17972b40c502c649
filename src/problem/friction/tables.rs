//! The tables of the friction oscillator: parameters, metrics, quantities.

use crate::problem::parameter::{Default, Kind, Parameter, Range, Value};
use crate::problem::{Budget, Metric, Quantity, Source};

pub(super) static PARAMETERS: [Parameter; 7] = [
    Parameter {
        name: "law",
        symbol: "law",
        unit: "1",
        kind: Kind::Choice(&[
            (
                "displacement-control",
                "elastic up to the displacement r^E, then sliding at the friction limit [F (9)]",
            ),
            (
                "velocity-control",
                "viscous up to the velocity rdot^E, then at the friction limit [F (16)]",
            ),
        ]),
        default: Default::Required,
        applies: None,
        meaning: "friction model",
    },
    Parameter {
        name: "alpha",
        symbol: "*α*",
        unit: "1",
        kind: Kind::Number(Range::Positive),
        default: Default::Required,
        applies: Some(("law", "displacement-control")),
        meaning: "elastic displacement before sliding, alpha = r^E/Delta [F (22)]",
    },
    Parameter {
        name: "beta",
        symbol: "*β*",
        unit: "1",
        kind: Kind::Number(Range::Positive),
        default: Default::Required,
        applies: Some(("law", "velocity-control")),
        meaning: "velocity up to which the force is viscous, beta = (rdot^E/omega_n)/Delta [F (22)]",
    },
    Parameter {
        name: "dT",
        symbol: "Δ*T*",
        unit: "1",
        kind: Kind::Number(Range::Positive),
        default: Default::Required,
        applies: None,
        meaning: "time step, dT = omega_n dt; at most duration",
    },
    Parameter {
        name: "duration",
        symbol: "*T*_end_",
        unit: "1",
        kind: Kind::Number(Range::Positive),
        default: Default::Required,
        applies: None,
        meaning: "end of the motion, in T = omega_n t",
    },
    Parameter {
        name: "x0",
        symbol: "*X*_0_",
        unit: "1",
        kind: Kind::Number(Range::NotZero),
        default: Default::Is(Value::Number(12.0)),
        applies: None,
        meaning: "displacement at release, over Delta = nu N/k",
    },
    Parameter {
        name: "initial_slip",
        symbol: "initial slip",
        unit: "1",
        kind: Kind::Choice(&[
            ("unloaded", "r^S(0) = x0, no friction force at release"),
            (
                "pulled",
                "r^S(0) = x0 - sign(x0) r^E, friction as after pulling the mass to x0 by hand",
            ),
            (
                "sliding",
                "r^S(0) = x0 + sign(x0) r^E, friction as just after release in [F (19)]",
            ),
        ]),
        default: Default::Is(Value::Name("unloaded")),
        applies: Some(("law", "displacement-control")),
        meaning: "slip of the friction element at release",
    },
];

/// Rows that every case is read by.
pub(super) mod rows {
    use super::PARAMETERS;
    use crate::problem::parameter::row_of;

    pub const ALPHA: usize = row_of(&PARAMETERS, "alpha");
    pub const BETA: usize = row_of(&PARAMETERS, "beta");
    pub const DT: usize = row_of(&PARAMETERS, "dT");
    pub const DURATION: usize = row_of(&PARAMETERS, "duration");
    pub const X0: usize = row_of(&PARAMETERS, "x0");
    pub const INITIAL_SLIP: usize = row_of(&PARAMETERS, "initial_slip");
}

/// The scales of friction: [F] divides by them.
pub(super) static SCALES: [[&str; 2]; 3] = [
    [
        "νN",
        "friction force while sliding: coefficient times normal force",
    ],
    [
        "Δ",
        "νN/k, displacement at which the spring just overcomes friction",
    ],
    ["ω_n", "sqrt(k/m), natural frequency without friction"],
];

pub(super) static METRICS: [Metric; 13] = [
    Metric {
        name: "rms_error",
        symbol: "rms error",
        unit: "1",
        meaning: "sqrt(mean (c - e)^2) / abs(x0); c is the computed X, e the exact X",
        default: true,
    },
    Metric {
        name: "max_error",
        symbol: "max. error",
        unit: "1",
        meaning: "max abs(c - e) / abs(x0)",
        default: true,
    },
    Metric {
        name: "peak_error",
        symbol: "peak error",
        unit: "1",
        meaning: "largest error of a peak, over abs(x0); the computed peak k is the extreme value from (k - 1/2) pi to (k + 1/2) pi, k = 1..m; needs duration >= (m + 1/2) pi, m >= 1",
        default: true,
    },
    Metric {
        name: "rest_error",
        symbol: "rest error",
        unit: "1",
        meaning: "abs(c - e) / abs(x0) at the last step; needs duration >= m pi, the time from which the exact solution rests",
        default: true,
    },
    Metric {
        name: "residual_motion",
        symbol: "residual motion",
        unit: "1",
        meaning: "(max c - min c)/2 / abs(x0) over the steps with T >= (m + 1) pi",
        default: true,
    },
    Metric {
        name: "work_error",
        symbol: "work error",
        unit: "1",
        meaning: "work of the friction force over the exact work (a0^2 - a_m^2)/2, minus 1; needs duration >= m pi, m >= 1",
        default: true,
    },
    Metric {
        name: "sprague_geers_magnitude",
        symbol: "Sprague–Geers *M*",
        unit: "1",
        meaning: "sqrt(sum c^2 / sum e^2) - 1",
        default: true,
    },
    Metric {
        name: "sprague_geers_phase",
        symbol: "Sprague–Geers *P*",
        unit: "1",
        meaning: "acos(sum c e / sqrt(sum c^2 sum e^2)) / pi",
        default: true,
    },
    Metric {
        name: "sprague_geers_combined",
        symbol: "Sprague–Geers *C*",
        unit: "1",
        meaning: "sqrt(magnitude^2 + phase^2)",
        default: true,
    },
    Metric {
        name: "regularisation_error",
        symbol: "regularisation error",
        unit: "1",
        meaning: "error of the softened law alone: rms_error with g instead of c; g is the exact motion with the softened law in continuous time; needs alpha or beta from 1e-100 to 1e100, abs(x0) <= 1e100, abs(x0) >= 1e-6 unless initial_slip is unloaded, duration <= 1e7",
        default: false,
    },
    Metric {
        name: "step_error",
        symbol: "step error",
        unit: "1",
        meaning: "error of the time step alone: rms_error with g instead of e; g is the exact motion with the softened law in continuous time; needs alpha or beta from 1e-100 to 1e100, abs(x0) <= 1e100, abs(x0) >= 1e-6 unless initial_slip is unloaded, duration <= 1e7",
        default: false,
    },
    Metric {
        name: "regularisation_share",
        symbol: "regularisation share",
        unit: "1",
        meaning: "share of the softened law in the error: sum (g - e) (c - e) / sum (c - e)^2; below 0 or above 1 where the errors of law and step have opposite signs",
        default: false,
    },
    Metric {
        name: "step_share",
        symbol: "step share",
        unit: "1",
        meaning: "share of the time step in the error: sum (c - g) (c - e) / sum (c - e)^2; the two shares add up to 1",
        default: false,
    },
];

pub(super) static QUANTITIES: [Quantity; 5] = [
    Quantity {
        name: "X",
        title: "*X* = *x*/Δ",
        source: Source::Displacement,
    },
    Quantity {
        name: "V",
        title: "*V* = *ẋ*/(*ω*_n_Δ)",
        source: Source::Velocity,
    },
    Quantity {
        name: "S",
        title: "*S*/*νN*",
        source: Source::Force,
    },
    Quantity {
        name: "X_error",
        title: "*X* − *X*_exact_",
        source: Source::DisplacementError,
    },
    Quantity {
        name: "V_error",
        title: "*V* − *V*_exact_",
        source: Source::VelocityError,
    },
];

pub(super) static BUDGETS: [Budget; 1] = [Budget {
    name: "X",
    title: "rms error of *X* over |*X*_0_|",
    total: 0,
    parts: &[("regularisation", 9), ("step", 10)],
}];
