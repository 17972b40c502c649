//! The metrics of the bar impact, each a row of its texts and of what computes it, and the parts of its errors.

use crate::lane::{Lane, largest};
use crate::metrics::impact::{Compared, OfExact};
use crate::problem::table::metric_rows::{Groups, metric_rows};
use crate::problem::{self, Budget, Metric};
use std::ops::Range;

metric_rows! {
    /// Those of all studies.
    new DEFAULT,
    /// Their values for each lane; not a finite number if undefined.
    fn values[L](of: &Compared<L>) -> Lane<L>;
    ["contact_duration", "contact duration/*T*_I_", "T_I"], "time from the first zero of r to the last, with r straight between steps; undefined without contact, and if the bars touch at the end"
    => of.in_contact(of.durations[0]);
    ["contact_steps", "contact in whole steps/*T*_I_", "T_I"], "contact_duration in whole steps: first step with r >= 0 after the last with r < 0, minus last step with r >= 0 before the first with r < 0"
    => of.in_contact(of.durations[1]);
    ["separations", "separations", "1"], "number of openings that close again, both within 0.9 exact contact durations after the exact first touch; undefined without contact"
    => of.in_contact(of.separations());
    ["max_overlap", "max. overlap/(*cT*_I_/2)", "c T_I/2"], "max(-r); undefined without contact"
    => of.in_contact(of.overlap());
    ["rdot_oscillation", "rms of *ṙ*/*c* in contact", "c"], "root mean square of c - e of rdot from 0.3 to 0.9 exact contact durations after the exact first touch; undefined without contact"
    => of.in_contact(of.oscillation());
    ["peak_force", "peak of *F*/*F*_0_", "F0"], "max force; undefined without contact"
    => of.in_contact(largest(of.force));
    ["impulse_error", "impulse error", "1"], "impulse (trapezoidal rule) over the exact impulse, minus 1; needs a duration beyond the exact separation"
    => of.in_contact(of.impulse_error());
    ["restitution", "restitution", "1"], "relative velocity of the mass centres at the end, over c; undefined without contact"
    => of.in_contact(of.restitution);
    ["energy_drift_max", "max. energy drift", "1"], "(E - E_0)/E_0 of the largest magnitude; E is the energy of bars and spring in the frame of the common mass centre, with what the damping of the contact and of the method has taken"
    => of.of_start(of.drift);
    ["energy_drift_final", "final energy drift", "1"], "(E - E_0)/E_0 at the last step"
    => of.of_start(of.end);
    ["rms_error_r", "rms error of *r*/(*cT*_I_/2)", "c T_I/2"], "sqrt(1/duration times the integral of (c - e)^2) of r, trapezoidal rule"
    => of.rms(0, of.r);
    ["rms_error_rdot", "rms error of *ṙ*/*c*", "c"], "sqrt(1/duration times the integral of (c - e)^2) of rdot, trapezoidal rule; at a jump of e, each side has its own limit"
    => of.rms(1, of.rdot);
}

metric_rows! {
    /// Those of the exact motion.
    selected OF_EXACT,
    /// Their values; `None` without contact.
    fn of_exact(of: Option<&OfExact>) -> Option<f64>;
    ["contact_duration_exact", "exact contact duration/*T*_I_", "T_I"], "contact_duration of the exact motion"
    => of.and_then(|exact| exact.duration);
    ["peak_force_exact", "exact peak of *F*/*F*_0_", "F0"], "peak_force of the exact motion"
    => of.map(|exact| exact.peak_force);
    ["restitution_exact", "exact restitution", "1"], "restitution of the exact motion, from its impulse until the last step"
    => of.map(|exact| exact.restitution);
}

/// What contact and method take of the energy, and the cost.
pub struct Taken {
    /// Energy at t = 0.
    pub start: f64,
    /// Energy that the damping of the contact takes.
    pub by_contact: f64,
    /// Energy that the method takes.
    pub by_method: f64,
    /// Energy at the last step, less that at t = 0.
    pub drift: f64,
    /// Steps times modes times sub-steps.
    pub cost: u64,
}

metric_rows! {
    /// The energies that contact and method take, and the cost.
    selected TAKEN,
    /// Their values.
    fn taken(of: &Taken) -> Option<f64>;
    ["contact_dissipation", "contact dissipation", "1"], "energy that the damping of the contact takes up to the last step, over E_0"
    => Some(of.by_contact / of.start);
    ["numerical_dissipation", "numerical dissipation", "1"], "energy that the method takes up to the last step, over E_0; below 0 where it adds energy; round-off for average-acceleration"
    => Some(of.by_method / of.start);
    ["energy_lost", "energy lost", "1"], "energy of bars and spring lost up to the last step, over E_0: contact_dissipation plus numerical_dissipation minus energy_drift_final"
    => Some((of.by_contact + of.by_method - of.drift) / of.start);
    ["cost", "cost", "1"], "steps times modes times sub-steps of the method"
    => Some(of.cost as f64);
}

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

/// All of them.
pub(super) fn table() -> Vec<Metric> {
    let each = |metric: fn(usize, Component) -> Metric| {
        let parts = 0..PARTS.len();
        parts.flat_map(move |part| COMPONENTS.map(|of| metric(part, of)))
    };
    let groups = Groups {
        default: DEFAULT.to_vec(),
        parts: each(error).chain(each(share)).collect(),
        exact: OF_EXACT.to_vec(),
        taken: TAKEN.to_vec(),
        errors: COMPONENTS.map(reference_error).to_vec(),
    };
    groups.in_order()
}

/// The norm of a part of the error.
fn error(part: usize, [name, symbol, over, unit]: Component) -> Metric {
    let [part_name, made_by, motion] = PARTS[part];
    let before = part.checked_sub(1).map_or("e", |before| PARTS[before][2]);
    Metric::built(
        [
            format!("{part_name}_error_{name}"),
            format!("{part_name} error of {symbol}{over}"),
            unit.into(),
        ],
        format!(
            "error of {made_by} alone: rms_error_{name} of {motion}, compared with {before}; for equal bars (integrated laws: or a wall) \
             and n <= 1000; empty for rigid contact"
        ),
    )
}

/// Its share in the error.
fn share(part: usize, [name, symbol, ..]: Component) -> Metric {
    let [part_name, ..] = PARTS[part];
    Metric::built(
        [
            format!("{part_name}_share_{name}"),
            format!("{part_name} share of {symbol}"),
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
            "estimated error of integrated motions: the larger of the rms of {name} with a tolerance of 1e-10 less that with 1e-12, and the \
             part of step_error_{name} that the convergence from dt to dt/64 does not explain; empty for the impact spring"
        ),
    )
}

const fn metric_of(name: &str) -> usize {
    problem::metric_of(&DEFAULT, name)
}

/// The rows of the groups.
pub const ROWS: Groups<Range<usize>> = Groups {
    default: DEFAULT.len(),
    parts: 2 * PARTS.len() * COMPONENTS.len(),
    exact: OF_EXACT.len(),
    taken: TAKEN.len(),
    errors: COMPONENTS.len(),
}
.rows();

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
    let budget = |(index, [name, symbol, over, _]): (usize, Component)| Budget {
        name: name.into(),
        title: format!("rms error of {symbol}{over}").into(),
        total: metric_of("rms_error_r") + index,
        parts: (0..PARTS.len())
            .map(|part| {
                let row = ROWS.parts.start + part * COMPONENTS.len() + index;
                (PARTS[part][0].into(), row)
            })
            .collect(),
    };
    COMPONENTS.into_iter().enumerate().map(budget).collect()
}

#[cfg(test)]
mod tests;
