//! The tables of the bar impact.

pub(super) mod law_parameters;
mod metric_table;
mod parameters;

pub(super) use metric_table::{DEFAULT, ROWS, Taken, of_exact, taken, values};
pub(super) use parameters::{MassMatrix, Opposite, rows};

use crate::contact::offer::Place;
use crate::problem::numbers::parameter::Parameter;
use crate::problem::numbers::unit::{Dimension, Unit};
use crate::problem::offered_laws::{count_others, others};
use crate::problem::table::schema::{Text, TimeAxis};
use crate::problem::{Channel, Profile, Quantity, Schema, method};
pub(super) use metric_table::{CONTACT_STEPS, ENERGY_DRIFT_FINAL, ENERGY_DRIFT_MAX, MAX_OVERLAP};
use parameters::PARAMETERS;
use std::borrow::Cow::{Borrowed, Owned};
use std::sync::{Arc, LazyLock};

/// The scales of an impact.
static SCALES: [[Text; 2]; 4] = [
    [
        Borrowed("T_I"),
        Borrowed(
            "2 L/C0 of the left bar, C0 = sqrt(E/ρ): time in which a wave travels through the bar and back; contact duration of two equal bars",
        ),
    ],
    [
        Borrowed("c"),
        Borrowed(
            "closing speed: velocity of the left bar minus velocity of the right bar before the impact",
        ),
    ],
    [Borrowed("Z"), Borrowed("A sqrt(E ρ), impedance of a bar")],
    [
        Borrowed("F0"),
        Borrowed(
            "c Z1 Z2/(Z1 + Z2), exact contact force of two bars while the wave travels; c Z1 on a wall",
        ),
    ],
];

const fn unit(dimension: Dimension, name: &'static str, over: &'static str) -> Unit {
    Unit {
        dimension,
        name: Borrowed(name),
        over: Borrowed(over),
    }
}

/// The units of metrics and quantities.
static UNITS: [Unit; 4] = [
    unit(Dimension::Time, "T_I", "/*T*_I_"),
    unit(Dimension::Length, "c T_I/2", "/(*cT*_I_/2)"),
    unit(Dimension::Velocity, "c", "/*c*"),
    unit(Dimension::Force, "F0", "/*F*_0_"),
];

/// What `Textbook::after` gives, in its order; each is 1 in the exact solution.
static LATER: [Text; 2] = [Borrowed("closing_speed"), Borrowed("rebound_speed")];

static CHANNELS: [Channel; 3] = [
    Channel::with_exact("r", Dimension::Length),
    Channel::with_exact("rdot", Dimension::Velocity),
    Channel::computed("force", Dimension::Force),
];

static QUANTITIES: [Quantity; 5] = [
    Quantity::of("r", "*r*/(*cT*_I_/2)", 0),
    Quantity::of("rdot", "*ṙ*/*c*", 1),
    Quantity::of("force", "*F*/*F*_0_", 2),
    Quantity::error_of("r_error", "*r* − *r*_exact_", 0),
    Quantity::error_of("rdot_error", "*ṙ* − *ṙ*_exact_", 1),
];

static PROFILES: [Profile; 2] = [
    Profile {
        name: Borrowed("velocity"),
        title: Borrowed("*v*/(*c*/2)"),
    },
    Profile {
        name: Borrowed("stress"),
        title: Borrowed("*σ*/(*F*_0_/*A*)"),
    },
];

/// The parameters of the bars and of the contact laws.
fn own() -> impl Iterator<Item = Parameter> {
    let tables = PARAMETERS.iter().chain(&law_parameters::PARAMETERS);
    tables
        .cloned()
        .chain(others(Place::Bars, &law_parameters::PARAMETERS))
}

/// First row of the parameters of the contact laws.
pub(in crate::problem::impact) const LAW: usize = PARAMETERS.len();

/// First row of the parameters of the method.
pub(in crate::problem::impact) const METHOD: usize =
    LAW + law_parameters::PARAMETERS.len() + count_others(Place::Bars, &law_parameters::PARAMETERS);

pub(super) static SCHEMA: LazyLock<Arc<Schema>> = LazyLock::new(|| {
    Arc::new(Schema {
        name: Borrowed("bar-impact"),
        meaning: Borrowed(
            "longitudinal impact of two uniform bars, or of a bar on a wall, with an impact spring [I]",
        ),
        described: false,
        parameters: Owned(own().chain(method::PARAMETERS.iter().cloned()).collect()),
        metrics: Owned(metric_table::table()),
        contact_metric: Some(MAX_OVERLAP),
        channels: Borrowed(&CHANNELS),
        quantities: Borrowed(&QUANTITIES),
        profiles: Borrowed(&PROFILES),
        budgets: Owned(metric_table::budgets()),
        step: rows::DT,
        duration: rows::DURATION,
        time: TimeAxis {
            column: Borrowed("t"),
            title: Borrowed("Time *t*/*T*_I_"),
            in_pi: false,
        },
        place_title: Borrowed("*x*/*L*"),
        later: Borrowed(&LATER),
        scales: Borrowed(&SCALES),
        units: Borrowed(&UNITS),
        alternatives: Borrowed(&[[Borrowed("gamma"), Borrowed("k_I")]]),
    })
});
