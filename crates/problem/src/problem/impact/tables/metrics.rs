//! The metrics of the bar impact, and the parts of its errors.

use crate::problem::{self, Budget, Metric};
use std::ops::Range as Rows;

/// Those of all studies.
static DEFAULT: [Metric; 12] = [
    Metric::new(
        ["contact_duration", "contact duration/*T*_I_", "T_I"],
        "time from the first zero of r (falling) to the last (rising), with r straight between steps; undefined without contact, and if the bars touch at the end",
    ),
    Metric::new(
        ["contact_steps", "contact in whole steps/*T*_I_", "T_I"],
        "contact_duration in whole steps: first step with r >= 0 after the last with r < 0, minus last step with r >= 0 before the first with r < 0",
    ),
    Metric::new(
        ["separations", "separations", "1"],
        "number of openings that close again, both within 0.9 exact contact durations after the exact first touch; undefined without contact",
    ),
    Metric::new(
        ["max_overlap", "max. overlap/(*cT*_I_/2)", "c T_I/2"],
        "max(-r); undefined without contact",
    ),
    Metric::new(
        ["rdot_oscillation", "rms of *ṙ*/*c* in contact", "c"],
        "root mean square of c - e of rdot from 0.3 to 0.9 exact contact durations after the exact first touch; undefined without contact",
    ),
    Metric::new(
        ["peak_force", "peak of *F*/*F*_0_", "F0"],
        "max force; undefined without contact",
    ),
    Metric::new(
        ["impulse_error", "impulse error", "1"],
        "impulse (trapezoidal rule) over the exact impulse, minus 1; needs a duration beyond the exact separation",
    ),
    Metric::new(
        ["restitution", "restitution", "1"],
        "relative velocity of the mass centres at the end, over c; undefined without contact",
    ),
    Metric::new(
        ["energy_drift_max", "max. energy drift", "1"],
        "(E - E_0)/E_0 of the largest magnitude; E is the energy of bars and spring in the frame of the common mass centre, with what the damping of the contact and of the method has taken",
    ),
    Metric::new(
        ["energy_drift_final", "final energy drift", "1"],
        "(E - E_0)/E_0 at the last step",
    ),
    Metric::new(
        ["rms_error_r", "rms error of *r*/(*cT*_I_/2)", "c T_I/2"],
        "sqrt(1/duration times the integral of (c - e)^2) of r, trapezoidal rule",
    ),
    Metric::new(
        ["rms_error_rdot", "rms error of *ṙ*/*c*", "c"],
        "sqrt(1/duration times the integral of (c - e)^2) of rdot, trapezoidal rule; at a jump of e, each side has its own limit",
    ),
];

/// Those of the exact motion.
static OF_EXACT: [Metric; 3] = [
    Metric::selected(
        [
            "contact_duration_exact",
            "exact contact duration/*T*_I_",
            "T_I",
        ],
        "contact_duration of the exact motion",
    ),
    Metric::selected(
        ["peak_force_exact", "exact peak of *F*/*F*_0_", "F0"],
        "peak_force of the exact motion",
    ),
    Metric::selected(
        ["restitution_exact", "exact restitution", "1"],
        "restitution of the exact motion, from its impulse until the last step",
    ),
];

/// The energies that contact and method take, and the cost.
static TAKEN: [Metric; 4] = [
    Metric::selected(
        ["contact_dissipation", "contact dissipation", "1"],
        "energy that the damping of the contact takes up to the last step, over E_0",
    ),
    Metric::selected(
        ["numerical_dissipation", "numerical dissipation", "1"],
        "energy that the method takes up to the last step, over E_0; below 0 where it adds energy; round-off for average-acceleration",
    ),
    Metric::selected(
        ["energy_lost", "energy lost", "1"],
        "energy of bars and spring that is gone at the last step, over E_0: contact_dissipation plus numerical_dissipation minus energy_drift_final",
    ),
    Metric::selected(
        ["cost", "cost", "1"],
        "steps times modes times sub-steps of the method",
    ),
];

/// A channel with parts of an error: its name, its symbol, what it is over, and its unit.
type Component = [&'static str; 4];

const COMPONENTS: [Component; 2] = [
    ["r", "*r*", "/(*cT*_I_/2)", "c T_I/2"],
    ["rdot", "*ṙ*", "/*c*", "c"],
];

/// The parts of an error: their names, what makes them, and the motion up to which each is.
const PARTS: [[&str; 3]; 3] = [
    [
        "regularisation",
        "the softened law",
        "continuous bars with the law",
    ],
    ["mesh", "the mesh", "the elements in continuous time"],
    ["step", "the time step", "c"],
];

/// All: those of all studies, the parts of the error, those of the exact motion, what is taken, and the errors of the motions between.
pub(super) fn all() -> Vec<Metric> {
    let each = |metric: fn(usize, Component) -> Metric| {
        let parts = 0..PARTS.len();
        parts.flat_map(move |part| COMPONENTS.map(|of| metric(part, of)))
    };
    let default = DEFAULT.iter().cloned();
    let all = default.chain(each(error)).chain(each(share));
    let all = all.chain(OF_EXACT.iter().chain(&TAKEN).cloned());
    all.chain(COMPONENTS.map(reference_error)).collect()
}

/// The norm of a part of the error.
fn error(part: usize, [name, symbol, over, unit]: Component) -> Metric {
    let [own, made_by, motion] = PARTS[part];
    let before = part.checked_sub(1).map_or("e", |before| PARTS[before][2]);
    Metric::built(
        [
            format!("{own}_error_{name}"),
            format!("{own} error of {symbol}{over}"),
            unit.into(),
        ],
        format!(
            "error of {made_by} alone: rms_error_{name} of {motion}, compared with {before}; for equal bars (integrated laws: or a wall) \
             and n <= 1000, as docs/scope.md says; empty for rigid contact"
        ),
    )
}

/// Its share in the error.
fn share(part: usize, [name, symbol, ..]: Component) -> Metric {
    let [own, ..] = PARTS[part];
    Metric::built(
        [
            format!("{own}_share_{name}"),
            format!("{own} share of {symbol}"),
            "1".into(),
        ],
        format!(
            "share of this part in the error of {name}: mean of (part) (c - e) over mean of (c - e)^2; the three shares add up to 1; \
             a share outside 0..1 means that parts have opposite signs"
        ),
    )
}

/// The error of the motions between the exact and the computed one.
fn reference_error([name, symbol, ..]: Component) -> Metric {
    Metric::built(
        [
            format!("reference_error_{name}"),
            format!("reference error of {symbol}"),
            "1".into(),
        ],
        format!(
            "estimated error of the integrated motions between the exact and the computed one: the rms of {name} with a tolerance of 1e-10 \
             less {name} with 1e-12, or the part of step_error_{name} that the convergence of the steps dt to dt/64 does not explain, \
             if that is larger; empty for the impact spring"
        ),
    )
}

const fn metric_of(name: &str) -> usize {
    problem::metric_of(&DEFAULT, name)
}

/// Rows of the parts of errors.
pub const BUDGET: Rows<usize> = behind(DEFAULT.len(), 2 * PARTS.len() * COMPONENTS.len());

/// Rows of the metrics of the exact motion.
pub const REFERENCE: Rows<usize> = behind(BUDGET.end, OF_EXACT.len());

/// Rows of the energies that contact and method take, and of the cost.
pub const LOSSES_AND_COST: Rows<usize> = behind(REFERENCE.end, TAKEN.len());

/// Rows of the errors of the motions between, the last ones.
pub const REFERENCE_ERRORS: Rows<usize> = behind(LOSSES_AND_COST.end, COMPONENTS.len());

const fn behind(first: usize, count: usize) -> Rows<usize> {
    first..first + count
}

/// Empty if and only if there is no contact.
pub const MAX_OVERLAP: usize = metric_of("max_overlap");

/// Rows that warnings look at.
pub const CONTACT_STEPS: usize = metric_of("contact_steps");
/// See `CONTACT_STEPS`.
pub const ENERGY_DRIFT_MAX: usize = metric_of("energy_drift_max");
/// See `CONTACT_STEPS`.
pub const ENERGY_DRIFT_FINAL: usize = metric_of("energy_drift_final");

/// The errors with their parts.
pub(super) fn budgets() -> Vec<Budget> {
    let budget = |(place, [name, symbol, over, _]): (usize, Component)| Budget {
        name: name.into(),
        title: format!("rms error of {symbol}{over}").into(),
        total: metric_of("rms_error_r") + place,
        parts: (0..PARTS.len())
            .map(|part| {
                let row = BUDGET.start + part * COMPONENTS.len() + place;
                (PARTS[part][0].into(), row)
            })
            .collect(),
    };
    COMPONENTS.into_iter().enumerate().map(budget).collect()
}
