//! The tables of the friction oscillator: parameters, metrics, quantities.

use crate::problem::choice::choice;
use crate::problem::method;
use crate::problem::parameter::{Default, Kind, Parameter, Range, Value};
use crate::problem::schema::{Text, TimeAxis};
use crate::problem::unit::Dimension;
use crate::problem::{Budget, Channel, Metric, Quantity, Schema, metric_of};
use std::borrow::Cow::{self, Borrowed};
use std::ops::Range as Rows;
use std::sync::{Arc, LazyLock};

choice! {
    /// Friction model.
    pub(super) enum LawName {
        DisplacementControl = "displacement-control":
            "elastic up to the displacement r^E, then sliding at the friction limit [F (9)]",
        VelocityControl = "velocity-control":
            "viscous up to the velocity rdot^E, then at the friction limit [F (16)]",
        Coulomb = "coulomb": "without compliance: sticks below the friction limit, slides at it",
        Tanh = "tanh":
            "nu N tanh(rdot/rdot^E), without corners (Andersson, Soderberg and Bjorklund 2007)",
        Stribeck = "stribeck":
            "velocity-control with a static limit, from which the force falls to the kinetic limit as the velocity rises",
        BoucWen = "bouc-wen": "hysteretic; tends to displacement-control as the exponent rises (Wen 1976)",
        Dahl = "dahl": "hysteretic, its stiffness falls towards the friction limit (Dahl 1968)",
        Lugre = "lugre":
            "bristles with stiffness sigma0, damping sigma1 and viscosity sigma2 (Canudas de Wit et al. 1995)",
    }
}

choice! {
    /// Slip of the friction element at release ([F] does not specify it).
    pub(super) enum InitialSlip {
        Unloaded = "unloaded": "r^S(0) = x0, no friction force at release",
        Pulled = "pulled":
            "r^S(0) = x0 - sign(x0) r^E, friction as after pulling the mass to x0 by hand",
        Sliding = "sliding":
            "r^S(0) = x0 + sign(x0) r^E, friction as just after release in [F (19)]",
    }
}

static PARAMETERS: [Parameter; 15] = [
    Parameter::new(
        ["law", "law", "1"],
        LawName::KIND,
        Default::Required,
        "friction model",
    ),
    Parameter::only_for(
        ["alpha", "*α*", "1"],
        Kind::Number(Range::Positive),
        Default::Required,
        ("law", &["displacement-control", "bouc-wen", "dahl"]),
        "elastic displacement before sliding, alpha = r^E/Delta [F (22)]; of bouc-wen and dahl that of the stiffness at S = 0",
    ),
    Parameter::only_for(
        ["beta", "*β*", "1"],
        Kind::Number(Range::Positive),
        Default::Required,
        ("law", &["velocity-control", "tanh", "stribeck"]),
        "velocity up to which the force is viscous, beta = (rdot^E/omega_n)/Delta [F (22)]; of tanh that of its slope at rdot = 0",
    ),
    Parameter::new(
        ["dT", "Δ*T*", "1"],
        Kind::Number(Range::Positive),
        Default::Required,
        "time step, dT = omega_n dt; at most duration",
    ),
    Parameter::new(
        ["duration", "*T*_end_", "1"],
        Kind::Number(Range::Positive),
        Default::Required,
        "end of the motion, in T = omega_n t",
    ),
    Parameter::new(
        ["x0", "*X*_0_", "1"],
        Kind::Number(Range::NotZero),
        Default::Is(Value::Number(12.0)),
        "displacement at release, over Delta = nu N/k",
    ),
    Parameter::only_for(
        ["initial_slip", "initial slip", "1"],
        InitialSlip::KIND,
        Default::Is(Value::Name("unloaded")),
        ("law", &["displacement-control", "bouc-wen", "dahl", "lugre"]),
        "slip of the friction element at release",
    ),
    Parameter::only_for(
        ["exponent", "*n*", "1"],
        Kind::Number(Range::AtLeastOne),
        Default::Is(Value::Number(1.0)),
        ("law", &["bouc-wen", "dahl"]),
        "exponent of the hysteretic laws",
    )
    .with_column_if_given(),
    Parameter::only_for(
        ["sigma0", "*σ*_0_", "1"],
        Kind::Number(Range::Positive),
        Default::Required,
        ("law", &["lugre"]),
        "stiffness of the bristles, over k; 1/alpha",
    )
    .with_column_if_given(),
    Parameter::only_for(
        ["sigma1", "*σ*_1_", "1"],
        Kind::Number(Range::NotNegative),
        Default::Is(Value::Number(0.0)),
        ("law", &["lugre"]),
        "damping of the bristles, over k/omega_n",
    )
    .with_column_if_given(),
    Parameter::only_for(
        ["sigma2", "*σ*_2_", "1"],
        Kind::Number(Range::NotNegative),
        Default::Is(Value::Number(0.0)),
        ("law", &["lugre"]),
        "viscous damping of the sliding contact, over k/omega_n",
    )
    .with_column_if_given(),
    Parameter::only_for(
        ["static_ratio", "*ν*_s_/*ν*", "1"],
        Kind::Number(Range::AtLeastOne),
        Default::Is(Value::Number(1.0)),
        ("law", &["stribeck", "lugre"]),
        "static friction limit over the kinetic one",
    )
    .with_column_if_given(),
    Parameter::only_for(
        ["stribeck_velocity", "*v*_S_/(*ω*_n_Δ)", "1"],
        Kind::Number(Range::Positive),
        Default::Is(Value::Number(1.0)),
        ("law", &["stribeck", "lugre"]),
        "velocity over which the limit falls from the static to the kinetic one, over omega_n Delta",
    )
    .with_column_if_given(),
    Parameter::only_for(
        ["nu_ratio", "*ν*_min_/*ν*", "1"],
        Kind::Number(Range::Fraction),
        Default::Is(Value::Number(1.0)),
        ("law", &["velocity-control", "tanh"]),
        "coefficient of friction at rest over that at high velocity, nu = nu_max - (nu_max - nu_min) exp(-nu_rate abs(rdot)) (Constantinou et al. 1990)",
    )
    .with_column_if_given(),
    Parameter::only_for(
        ["nu_rate", "*a* *ω*_n_Δ", "1"],
        Kind::Number(Range::NotNegative),
        Default::Is(Value::Number(1.0)),
        ("law", &["velocity-control", "tanh"]),
        "rate a of the coefficient of friction over velocity, times omega_n Delta",
    )
    .with_column_if_given(),
];

/// Rows of the parameters.
pub(super) mod rows {
    use super::PARAMETERS;
    use crate::problem::parameter::row_of;

    pub const LAW: usize = row_of(&PARAMETERS, "law");
    pub const ALPHA: usize = row_of(&PARAMETERS, "alpha");
    pub const BETA: usize = row_of(&PARAMETERS, "beta");
    pub const DT: usize = row_of(&PARAMETERS, "dT");
    pub const DURATION: usize = row_of(&PARAMETERS, "duration");
    pub const X0: usize = row_of(&PARAMETERS, "x0");
    pub const INITIAL_SLIP: usize = row_of(&PARAMETERS, "initial_slip");
    pub const EXPONENT: usize = row_of(&PARAMETERS, "exponent");
    pub const SIGMA0: usize = row_of(&PARAMETERS, "sigma0");
    pub const SIGMA1: usize = row_of(&PARAMETERS, "sigma1");
    pub const SIGMA2: usize = row_of(&PARAMETERS, "sigma2");
    pub const STATIC_RATIO: usize = row_of(&PARAMETERS, "static_ratio");
    pub const STRIBECK_VELOCITY: usize = row_of(&PARAMETERS, "stribeck_velocity");
    pub const NU_RATIO: usize = row_of(&PARAMETERS, "nu_ratio");
    pub const NU_RATE: usize = row_of(&PARAMETERS, "nu_rate");
    /// First row of the parameters of the method.
    pub const METHOD: usize = PARAMETERS.len();
}

/// The scales of friction in [F].
static SCALES: [[Text; 2]; 3] = [
    [
        Borrowed("νN"),
        Borrowed("friction force while sliding: coefficient times normal force"),
    ],
    [
        Borrowed("Δ"),
        Borrowed("νN/k, displacement at which the spring just overcomes friction"),
    ],
    [
        Borrowed("ω_n"),
        Borrowed("sqrt(k/m), natural frequency without friction"),
    ],
];

pub(super) static METRICS: [Metric; 18] = [
    Metric::new(
        ["rms_error", "rms error", "1"],
        "sqrt(mean (c - e)^2) / abs(x0); c is the computed X, e the exact X",
    ),
    Metric::new(["max_error", "max. error", "1"], "max abs(c - e) / abs(x0)"),
    Metric::new(
        ["peak_error", "peak error", "1"],
        "largest error of a peak, over abs(x0); the computed peak k is the extreme value from (k - 1/2) pi to (k + 1/2) pi, k = 1..m; needs duration >= (m + 1/2) pi, m >= 1",
    ),
    Metric::new(
        ["rest_error", "rest error", "1"],
        "abs(c - e) / abs(x0) at the last step; needs duration >= m pi, the time from which the exact solution rests",
    ),
    Metric::new(
        ["residual_motion", "residual motion", "1"],
        "(max c - min c)/2 / abs(x0) over the steps with T >= (m + 1) pi",
    ),
    Metric::new(
        ["work_error", "work error", "1"],
        "work of the friction force over the exact work (a0^2 - a_m^2)/2, minus 1; needs duration >= m pi, m >= 1",
    ),
    Metric::new(
        ["sprague_geers_magnitude", "Sprague–Geers *M*", "1"],
        "sqrt(sum c^2 / sum e^2) - 1",
    ),
    Metric::new(
        ["sprague_geers_phase", "Sprague–Geers *P*", "1"],
        "acos(sum c e / sqrt(sum c^2 sum e^2)) / pi",
    ),
    Metric::new(
        ["sprague_geers_combined", "Sprague–Geers *C*", "1"],
        "sqrt(magnitude^2 + phase^2)",
    ),
    Metric::selected(
        ["regularisation_error", "regularisation error", "1"],
        "error of the softened law alone: rms_error with g instead of c; g is the exact motion with the softened law in continuous time; needs alpha or beta from 1e-100 to 1e100, abs(x0) <= 1e100, abs(x0) >= 1e-6 unless initial_slip is unloaded, duration <= 1e7",
    ),
    Metric::selected(
        ["step_error", "step error", "1"],
        "error of the time step alone: rms_error with g instead of e; g is the exact motion with the softened law in continuous time; needs alpha or beta from 1e-100 to 1e100, abs(x0) <= 1e100, abs(x0) >= 1e-6 unless initial_slip is unloaded, duration <= 1e7",
    ),
    Metric::selected(
        ["regularisation_share", "regularisation share", "1"],
        "share of the softened law in the error: sum (g - e) (c - e) / sum (c - e)^2; below 0 or above 1 where the errors of law and step have opposite signs",
    ),
    Metric::selected(
        ["step_share", "step share", "1"],
        "share of the time step in the error: sum (c - g) (c - e) / sum (c - e)^2; the two shares add up to 1",
    ),
    Metric::selected(
        ["numerical_dissipation", "numerical dissipation", "1"],
        "energy that the method takes from the motion up to the last step, over the energy at t = 0; below 0 where it adds energy; 0 to round-off for average-acceleration",
    ),
    Metric::selected(["cost", "cost", "1"], "steps times sub-steps of the method"),
    Metric::selected(
        ["spectral_radius", "spectral radius", "1"],
        "largest magnitude of the eigenvalues of a step without friction, from the closed form of the method",
    ),
    Metric::selected(
        ["period_elongation", "period elongation", "1"],
        "(T - T_0)/T_0 of the period without friction, from the closed form of the method; undefined if the step does not oscillate",
    ),
    Metric::selected(
        ["numerical_damping", "numerical damping ratio", "1"],
        "-ln(abs(lambda))/phase of the principal eigenvalue lambda of a step without friction, from the closed form of the method; undefined if the step does not oscillate",
    ),
];

/// Rows of the parts of the error.
pub(super) const BUDGET: Rows<usize> =
    metric_of(&METRICS, "regularisation_error")..metric_of(&METRICS, "step_share") + 1;

/// Rows of what the method takes and costs, and of its amplification.
pub(super) const TAKEN: Rows<usize> =
    metric_of(&METRICS, "numerical_dissipation")..metric_of(&METRICS, "numerical_damping") + 1;

static CHANNELS: [Channel; 3] = [
    Channel::with_exact("X", Dimension::Length),
    Channel::with_exact("V", Dimension::Velocity),
    Channel::computed("S", Dimension::Force),
];

static QUANTITIES: [Quantity; 5] = [
    Quantity::of("X", "*X* = *x*/Δ", 0),
    Quantity::of("V", "*V* = *ẋ*/(*ω*_n_Δ)", 1),
    Quantity::of("S", "*S*/*νN*", 2),
    Quantity::error_of("X_error", "*X* − *X*_exact_", 0),
    Quantity::error_of("V_error", "*V* − *V*_exact_", 1),
];

static BUDGETS: [Budget; 1] = [Budget {
    name: Borrowed("X"),
    title: Borrowed("rms error of *X* over |*X*_0_|"),
    total: 0,
    parts: Borrowed(&[(Borrowed("regularisation"), 9), (Borrowed("step"), 10)]),
}];

pub(super) static SCHEMA: LazyLock<Arc<Schema>> = LazyLock::new(|| {
    Arc::new(Schema {
        name: Borrowed("friction-oscillator"),
        meaning: Borrowed(
            "free vibration of a mass on a spring with Coulomb friction, released at rest from x0 [F]",
        ),
        parameters: PARAMETERS
            .iter()
            .chain(&method::PARAMETERS)
            .cloned()
            .collect(),
        metrics: Borrowed(&METRICS),
        contact_metric: None,
        channels: Borrowed(&CHANNELS),
        quantities: Borrowed(&QUANTITIES),
        profiles: Cow::default(),
        budgets: Borrowed(&BUDGETS),
        step: rows::DT,
        duration: rows::DURATION,
        time: TimeAxis {
            column: Borrowed("T"),
            title: Borrowed("Dimensionless time *T* = *ω*_n_*t*"),
            in_pi: true,
        },
        place_title: Borrowed(""),
        later: Cow::default(),
        scales: Borrowed(&SCALES),
        units: Cow::default(),
        alternatives: Cow::default(),
    })
});
