//! The metrics of the friction oscillator: each a row of its texts and of what computes it.

use crate::lane::Lane;
use crate::methods::Amplification;
use crate::metrics::friction::{Compared, peak_error, residual_motion};
use crate::metrics::or_undefined;
use crate::problem::Metric;
use crate::problem::table::metric_rows::{Groups, metric_rows};
use std::ops::Range;

/// What the metrics of all studies are computed from.
pub struct Shared<'a, const L: usize> {
    /// The computed motion and the exact one.
    pub compared: Compared<'a, L>,
    /// Work of the friction force over |x0|.
    pub work: Lane<L>,
}

metric_rows! {
    /// Those of all studies.
    new DEFAULT,
    /// Their values for each lane; not a finite number if undefined.
    fn values[L](of: &Shared<L>) -> Lane<L>;
    ["rms_error", "rms error", "1"], "sqrt(mean (c - e)^2) / abs(x0); c is the computed X, e the exact X"
    => of.compared.rms();
    ["max_error", "max. error", "1"], "max abs(c - e) / abs(x0)"
    => of.compared.furthest;
    ["peak_error", "peak error", "1"], "largest error of a peak, over abs(x0); the computed peak k = 1..m is the extreme value from (k - 1/2) pi to (k + 1/2) pi; needs duration >= (m + 1/2) pi, m >= 1"
    => or_undefined(peak_error(of.compared.c, of.compared.exact).map(|error| error * of.compared.over));
    ["rest_error", "rest error", "1"], "abs(c - e) / abs(x0) at the last step; needs duration >= m pi, the time from which the exact solution rests"
    => or_undefined(of.compared.rest());
    ["residual_motion", "residual motion", "1"], "(max c - min c)/2 / abs(x0) over the steps with T >= (m + 1) pi"
    => or_undefined(residual_motion(of.compared.c, of.compared.exact).map(|motion| motion * of.compared.over));
    ["work_error", "work error", "1"], "work of the friction force over the exact work (a0^2 - a_m^2)/2, minus 1; needs duration >= m pi, m >= 1"
    => or_undefined(of.compared.work_error(of.work));
    ["sprague_geers_magnitude", "Sprague–Geers *M*", "1"], "sqrt(sum c^2 / sum e^2) - 1"
    => of.compared.sprague_geers[0];
    ["sprague_geers_phase", "Sprague–Geers *P*", "1"], "acos(sum c e / sqrt(sum c^2 sum e^2)) / pi"
    => of.compared.sprague_geers[1];
    ["sprague_geers_combined", "Sprague–Geers *C*", "1"], "sqrt(magnitude^2 + phase^2)"
    => {
        let [magnitude, phase] = of.compared.sprague_geers;
        (magnitude * magnitude + phase * phase).map(f64::sqrt)
    };
}

/// The parts of the error, in the order of [`crate::metrics::budget::parts`].
pub static PARTS: [Metric; 4] = [
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
];

/// What the method takes and costs.
pub struct Taken {
    /// The displacement at release.
    pub x0: f64,
    /// Number of steps times sub-steps.
    pub steps: u64,
    /// Energy that the method takes up to the last step, over |x0|; `None` without a step.
    pub by_method: Option<f64>,
    /// The amplification of the method without friction.
    pub step: Amplification,
}

metric_rows! {
    /// What the method takes and costs, and its amplification.
    selected TAKEN,
    /// Their values.
    fn taken(of: &Taken) -> Option<f64>;
    ["numerical_dissipation", "numerical dissipation", "1"], "energy that the method takes up to the last step, over the energy at t = 0; below 0 where it adds energy; round-off for average-acceleration"
    => of.by_method.map(|energy| 2.0 * energy / of.x0.abs());
    ["cost", "cost", "1"], "steps times sub-steps of the method"
    => Some(of.steps as f64);
    ["spectral_radius", "spectral radius", "1"], "largest magnitude of the eigenvalues of a step without friction"
    => Some(of.step.spectral_radius);
    ["period_elongation", "period elongation", "1"], "(T - T_0)/T_0 of the period without friction; undefined if the step does not oscillate"
    => of.step.principal.as_ref().map(|eigenvalue| eigenvalue.period_elongation);
    ["numerical_damping", "numerical damping ratio", "1"], "-ln(abs(lambda))/phase of the principal eigenvalue lambda of a step without friction; undefined if the step does not oscillate"
    => of.step.principal.as_ref().map(|eigenvalue| eigenvalue.damping_ratio);
}

/// The error of the reference.
static ERRORS: [Metric; 1] = [Metric::selected(
    ["reference_error", "reference error", "1"],
    "estimated error of an integrated g: the larger of rms_error of g with a tolerance of 1e-10 compared with 1e-12, and the part of step_error that the convergence from dT to dT/64 does not explain; empty for the laws of [F]",
)];

/// The rows of the groups.
pub const ROWS: Groups<Range<usize>> = Groups {
    default: DEFAULT.len(),
    parts: PARTS.len(),
    exact: 0,
    taken: TAKEN.len(),
    errors: ERRORS.len(),
}
.rows();

/// All of them.
pub fn table() -> Vec<Metric> {
    let groups = Groups {
        default: DEFAULT.to_vec(),
        parts: PARTS.to_vec(),
        exact: Vec::new(),
        taken: TAKEN.to_vec(),
        errors: ERRORS.to_vec(),
    };
    groups.in_order()
}

#[cfg(test)]
mod tests;
