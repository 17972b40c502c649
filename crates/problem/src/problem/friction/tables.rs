//! The tables of the friction oscillator: parameters, metrics, quantities.

use super::metric_table::{self, DEFAULT, PARTS, ROWS};
use crate::contact::numbers::oscillator as number;
use crate::contact::offer::Place;
use crate::problem::method;
use crate::problem::numbers::choice::choice;
use crate::problem::numbers::parameter::{Default, Kind, Parameter, Range, Value};
use crate::problem::numbers::unit::Dimension;
use crate::problem::offered_laws::{law_names, laws, others};
use crate::problem::table::schema::{Text, TimeAxis};
use crate::problem::{Budget, Channel, Quantity, Schema, metric_of};
use std::borrow::Cow::{self, Borrowed};
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
    use crate::problem::numbers::parameter::row_of;
    use crate::problem::offered_laws::count_others;

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
    total: metric_of(&DEFAULT, "rms_error"),
    parts: Borrowed(&[
        (
            Borrowed("regularisation"),
            ROWS.parts.start + metric_of(&PARTS, "regularisation_error"),
        ),
        (
            Borrowed("step"),
            ROWS.parts.start + metric_of(&PARTS, "step_error"),
        ),
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
        metrics: metric_table::table().into(),
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
