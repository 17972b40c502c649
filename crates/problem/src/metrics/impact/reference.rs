//! The exact motion, for those metrics of the computed motion that do not contain the exact value.

use super::Sampled;
use crate::exact::wave::Wave;
use crate::metrics::reached;

/// The contact of the exact motion up to the last step.
pub struct OfExact {
    /// Duration of the contact; `None` if the bars touch at the end.
    pub duration: Option<f64>,
    /// Peak of the force.
    pub peak_force: f64,
    /// Relative velocity of the mass centres at the end, over c.
    pub restitution: f64,
}

/// The contact of the exact motion; `None` without one.
pub fn reference(wave: &Wave, exact: &Sampled) -> Option<OfExact> {
    let end = (exact.count() - 1) as f64 * exact.step;
    let separation = wave.first_touch() + exact.lasts;
    exact.touches.then(|| OfExact {
        duration: reached(end, separation).then_some(exact.lasts),
        peak_force: wave.peak_force(end),
        restitution: wave.restitution(end),
    })
}
