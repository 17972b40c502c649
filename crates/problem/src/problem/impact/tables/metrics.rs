//! The metrics of the bar impact, and the parts of its errors.

use crate::problem::{self, Budget, Metric};
use std::borrow::Cow::Borrowed;
use std::ops::Range as Rows;

pub(super) static METRICS: [Metric; 33] = [
    Metric::new(
        ["contact_duration", "contact duration/*T*_I_", "T_I"],
        "time from the first zero of r to the last, straight between steps; undefined if the bars touch at the end and, as other metrics of the contact, without contact",
    ),
    Metric::new(
        ["contact_steps", "contact in whole steps/*T*_I_", "T_I"],
        "contact_duration in whole steps: from the last one before the contact to the first after it",
    ),
    Metric::new(
        ["separations", "separations", "1"],
        "number of openings that close again within 0.9 exact contact durations after the exact first touch",
    ),
    Metric::new(
        ["max_overlap", "max. overlap/(*cT*_I_/2)", "c T_I/2"],
        "max(-r)",
    ),
    Metric::new(
        ["rdot_oscillation", "rms of *ṙ*/*c* in contact", "c"],
        "root mean square of c - e of rdot from 0.3 to 0.9 exact contact durations after the exact first touch",
    ),
    Metric::new(["peak_force", "peak of *F*/*F*_0_", "F0"], "max force"),
    Metric::new(
        ["impulse_error", "impulse error", "1"],
        "impulse over the exact impulse, minus 1; needs a duration beyond the exact separation",
    ),
    Metric::new(
        ["restitution", "restitution", "1"],
        "relative velocity of the mass centres at the end, over c",
    ),
    Metric::new(
        ["energy_drift_max", "max. energy drift", "1"],
        "(E - E_0)/E_0 of the largest magnitude; E is the energy of bars and spring relative to the mass centre, with what damping and the method took",
    ),
    Metric::new(
        ["energy_drift_final", "final energy drift", "1"],
        "(E - E_0)/E_0 at the last step",
    ),
    Metric::new(
        ["rms_error_r", "rms error of *r*/(*cT*_I_/2)", "c T_I/2"],
        "sqrt(1/duration times the integral of (c - e)^2) of r",
    ),
    Metric::new(
        ["rms_error_rdot", "rms error of *ṙ*/*c*", "c"],
        "sqrt(1/duration times the integral of (c - e)^2) of rdot",
    ),
    Metric::selected(
        [
            "regularisation_error_r",
            "regularisation error of *r*/(*cT*_I_/2)",
            "c T_I/2",
        ],
        "error of the softened law alone: rms_error_r of continuous bars with the law, compared with e; docs/scope.md says when",
    ),
    Metric::selected(
        [
            "regularisation_error_rdot",
            "regularisation error of *ṙ*/*c*",
            "c",
        ],
        "error of the softened law alone: rms_error_rdot of continuous bars with the law, compared with e; docs/scope.md says when",
    ),
    Metric::selected(
        ["mesh_error_r", "mesh error of *r*/(*cT*_I_/2)", "c T_I/2"],
        "error of the mesh alone: rms_error_r of the elements in continuous time, compared with continuous bars with the law",
    ),
    Metric::selected(
        ["mesh_error_rdot", "mesh error of *ṙ*/*c*", "c"],
        "error of the mesh alone: rms_error_rdot of the elements in continuous time, compared with continuous bars with the law",
    ),
    Metric::selected(
        ["step_error_r", "step error of *r*/(*cT*_I_/2)", "c T_I/2"],
        "error of the time step alone: rms_error_r of c, compared with the elements in continuous time",
    ),
    Metric::selected(
        ["step_error_rdot", "step error of *ṙ*/*c*", "c"],
        "error of the time step alone: rms_error_rdot of c, compared with the elements in continuous time",
    ),
    Metric::selected(
        ["regularisation_share_r", "regularisation share of *r*", "1"],
        "share of this part in the error of r: mean of (part) (c - e) over mean of (c - e)^2; outside 0..1 parts have opposite signs",
    ),
    Metric::selected(
        [
            "regularisation_share_rdot",
            "regularisation share of *ṙ*",
            "1",
        ],
        "share of this part in the error of rdot: mean of (part) (c - e) over mean of (c - e)^2; outside 0..1 parts have opposite signs",
    ),
    Metric::selected(
        ["mesh_share_r", "mesh share of *r*", "1"],
        "share of this part in the error of r: mean of (part) (c - e) over mean of (c - e)^2; outside 0..1 parts have opposite signs",
    ),
    Metric::selected(
        ["mesh_share_rdot", "mesh share of *ṙ*", "1"],
        "share of this part in the error of rdot: mean of (part) (c - e) over mean of (c - e)^2; outside 0..1 parts have opposite signs",
    ),
    Metric::selected(
        ["step_share_r", "step share of *r*", "1"],
        "share of this part in the error of r: mean of (part) (c - e) over mean of (c - e)^2; outside 0..1 parts have opposite signs",
    ),
    Metric::selected(
        ["step_share_rdot", "step share of *ṙ*", "1"],
        "share of this part in the error of rdot: mean of (part) (c - e) over mean of (c - e)^2; outside 0..1 parts have opposite signs",
    ),
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
    Metric::selected(
        ["contact_dissipation", "contact dissipation", "1"],
        "energy that the damping of the contact takes, over E_0",
    ),
    Metric::selected(
        ["numerical_dissipation", "numerical dissipation", "1"],
        "energy that the method takes, over E_0; below 0 where it adds some",
    ),
    Metric::selected(
        ["energy_lost", "energy lost", "1"],
        "contact_dissipation plus numerical_dissipation minus energy_drift_final",
    ),
    Metric::selected(
        ["cost", "cost", "1"],
        "steps times modes times sub-steps of the method",
    ),
    Metric::selected(
        ["reference_error_r", "reference error of *r*", "1"],
        "estimated error of the integrated motions between the exact and the computed one (docs/scope.md); empty for the impact spring",
    ),
    Metric::selected(
        ["reference_error_rdot", "reference error of *ṙ*", "1"],
        "estimated error of the integrated motions between the exact and the computed one (docs/scope.md); empty for the impact spring",
    ),
];

const fn metric_of(name: &str) -> usize {
    problem::metric_of(&METRICS, name)
}

/// Rows of the parts of errors.
pub const BUDGET: Rows<usize> =
    metric_of("regularisation_error_r")..metric_of("step_share_rdot") + 1;

/// Rows of the errors of the motions between, the last ones.
pub const REFERENCE_ERRORS: Rows<usize> =
    metric_of("reference_error_r")..metric_of("reference_error_rdot") + 1;

/// Rows of the metrics of the exact motion.
pub const REFERENCE: Rows<usize> =
    metric_of("contact_duration_exact")..metric_of("restitution_exact") + 1;

/// Rows of the energies that contact and method take, and of the cost.
pub const LOSSES_AND_COST: Rows<usize> = metric_of("contact_dissipation")..metric_of("cost") + 1;

/// Empty if and only if there is no contact.
pub const MAX_OVERLAP: usize = metric_of("max_overlap");

/// Rows that warnings look at.
pub const CONTACT_STEPS: usize = metric_of("contact_steps");
/// See `CONTACT_STEPS`.
pub const ENERGY_DRIFT_MAX: usize = metric_of("energy_drift_max");
/// See `CONTACT_STEPS`.
pub const ENERGY_DRIFT_FINAL: usize = metric_of("energy_drift_final");

pub(super) static BUDGETS: [Budget; 2] = [
    Budget {
        name: Borrowed("r"),
        title: Borrowed("rms error of *r*/(*cT*_I_/2)"),
        total: metric_of("rms_error_r"),
        parts: Borrowed(&[
            (
                Borrowed("regularisation"),
                metric_of("regularisation_error_r"),
            ),
            (Borrowed("mesh"), metric_of("mesh_error_r")),
            (Borrowed("step"), metric_of("step_error_r")),
        ]),
    },
    Budget {
        name: Borrowed("rdot"),
        title: Borrowed("rms error of *ṙ*/*c*"),
        total: metric_of("rms_error_rdot"),
        parts: Borrowed(&[
            (
                Borrowed("regularisation"),
                metric_of("regularisation_error_rdot"),
            ),
            (Borrowed("mesh"), metric_of("mesh_error_rdot")),
            (Borrowed("step"), metric_of("step_error_rdot")),
        ]),
    },
];
