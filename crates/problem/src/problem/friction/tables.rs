//! The tables of the friction oscillator: parameters, metrics, quantities.

use crate::contact::numbers::oscillator as number;
use crate::contact::offer::Place;
use crate::problem::laws::{law_names, laws, others};
use crate::problem::method;
use crate::problem::numbers::choice::choice;
use crate::problem::numbers::parameter::{Default, Kind, Parameter, Range, Value};
use crate::problem::numbers::unit::Dimension;
use crate::problem::table::schema::{Text, TimeAxis};
use crate::problem::{Budget, Channel, Metric, Quantity, Schema, metric_of};
use std::borrow::Cow::{self, Borrowed};
use std::ops::Range as Rows;
use std::sync::{Arc, LazyLock};

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

/// A number, and the laws that have it.
macro_rules! of_laws {
    ($number:ident) => {
        Parameter::of_laws(
            &number::$number,
            law_names!(Oscillator, Which::With(&number::$number)),
        )
    };
}

static PARAMETERS: [Parameter; 15] = [
    Parameter::new(
        ["law", "law", "1"],
        Kind::Choice(laws!(Oscillator, Which::All)),
        Default::Required,
        "friction model",
    ),
    of_laws!(ALPHA),
    of_laws!(BETA),
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
        ("law", law_names!(Oscillator, Which::Hysteretic)),
        "slip of the friction element at release",
    ),
    of_laws!(EXPONENT).with_column_if_given(),
    of_laws!(SIGMA0).with_column_if_given(),
    of_laws!(SIGMA1).with_column_if_given(),
    of_laws!(SIGMA2).with_column_if_given(),
    of_laws!(STATIC_RATIO).with_column_if_given(),
    of_laws!(STRIBECK_VELOCITY).with_column_if_given(),
    of_laws!(NU_RATIO).with_column_if_given(),
    of_laws!(NU_RATE).with_column_if_given(),
];

/// Rows of the parameters.
pub(super) mod rows {
    use super::PARAMETERS;
    use crate::contact::offer::Place;
    use crate::problem::laws::count_others;
    use crate::problem::numbers::parameter::row_of;

    pub const LAW: usize = row_of(&PARAMETERS, "law");
    pub const ALPHA: usize = row_of(&PARAMETERS, "alpha");
    pub const BETA: usize = row_of(&PARAMETERS, "beta");
    pub const DT: usize = row_of(&PARAMETERS, "dT");
    pub const DURATION: usize = row_of(&PARAMETERS, "duration");
    pub const X0: usize = row_of(&PARAMETERS, "x0");
    pub const INITIAL_SLIP: usize = row_of(&PARAMETERS, "initial_slip");
    pub const STATIC_RATIO: usize = row_of(&PARAMETERS, "static_ratio");
    pub const NU_RATIO: usize = row_of(&PARAMETERS, "nu_ratio");
    /// First row of the parameters of the method, behind the numbers that only one law has.
    pub const METHOD: usize = PARAMETERS.len() + count_others(Place::Oscillator, &PARAMETERS);
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

pub(super) static METRICS: [Metric; 19] = [
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
        "error of the softened law alone: rms_error with g instead of c; g is the exact motion with the softened law in continuous time, a closed form for the laws of [F], else integrated",
    ),
    Metric::selected(
        ["step_error", "step error", "1"],
        "error of the time step alone: rms_error with g instead of e; g is the exact motion with the softened law in continuous time, a closed form for the laws of [F], else integrated",
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
        "energy that the method takes up to the last step, over the energy at t = 0; below 0 where it adds energy; round-off for average-acceleration",
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
    Metric::selected(
        ["reference_error", "reference error", "1"],
        "estimated error of an integrated g: rms_error of g with a tolerance of 1e-10 against g with 1e-12, or the part of step_error that the convergence of the steps dT to dT/64 does not explain, if that is larger; empty for the laws of [F]",
    ),
];

/// Rows of the parts of the error.
pub(super) const BUDGET: Rows<usize> =
    metric_of(&METRICS, "regularisation_error")..metric_of(&METRICS, "step_share") + 1;

/// Row of the error of the reference, the last one.
pub(super) const REFERENCE_ERRORS: Rows<usize> =
    metric_of(&METRICS, "reference_error")..METRICS.len();

/// Rows of what the method takes and costs, and of its amplification.
pub(super) const LOSSES_AND_COST: Rows<usize> =
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
    total: metric_of(&METRICS, "rms_error"),
    parts: Borrowed(&[
        (
            Borrowed("regularisation"),
            metric_of(&METRICS, "regularisation_error"),
        ),
        (Borrowed("step"), metric_of(&METRICS, "step_error")),
    ]),
}];

pub(super) static SCHEMA: LazyLock<Arc<Schema>> = LazyLock::new(|| {
    Arc::new(Schema {
        name: Borrowed("friction-oscillator"),
        meaning: Borrowed(
            "free vibration of a mass on a spring with Coulomb friction, released at rest from x0 [F]",
        ),
        described: false,
        parameters: PARAMETERS
            .iter()
            .cloned()
            .chain(others(Place::Oscillator, &PARAMETERS))
            .chain(method::PARAMETERS.iter().cloned())
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
