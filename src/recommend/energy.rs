//! The largest gain of energy on the way of an impact, which a larger loss hides in `energy_drift_max`.

use crate::history::History;
use crate::problem::Case;
use crate::problem::impact::scaled::Scaled;

/// max (E_i - E_0)/E_0 over the steps of a run from t = 0; never negative, since step 0 is among them.
///
/// Over a step the contact force F does the work (F_i + F_{i+1})/2 (r_{i+1} - r_i) on the bars: constant average
/// acceleration keeps this sum exactly. The spring holds F |r|/2, and at the start only the closing speed has energy.
pub fn gain(case: &Case, computed: &History) -> Option<f64> {
    // Scaled as in `Scaled`: the closing speed is 2.
    let inverse: f64 = Scaled::new(case)?.each().map(|bar| 1.0 / bar.mass).sum();
    let start = 2.0 / inverse;
    let (r, force) = (&computed.displacement, &computed.force);
    let (mut bars, mut most) = (0.0, 0.0_f64);
    for (r, force) in r.windows(2).zip(force.windows(2)) {
        bars += 0.5 * (force[0] + force[1]) * (r[1] - r[0]);
        most = most.max(bars - 0.5 * force[1] * r[1]);
    }
    Some(most / start)
}
