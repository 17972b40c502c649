//! Metrics of the exact motion, for those metrics of the computed motion that do not contain the exact value.

use super::Sampled;
use crate::exact::wave::Wave;
use crate::metrics::reached;

/// Number of the metrics here.
pub const COUNT: usize = 3;

/// Duration of the contact, peak of the force and restitution of the exact motion up to the last step. All are undefined without
/// contact, and the first also if the bars touch at the end.
pub fn reference(wave: &Wave, exact: &Sampled) -> [Option<f64>; COUNT] {
    if !exact.touches {
        return [None; COUNT];
    }
    let end = (exact.count() - 1) as f64 * exact.step;
    let separation = wave.first_touch() + exact.lasts;
    [
        reached(end, separation).then_some(exact.lasts),
        Some(wave.peak_force(end)),
        Some(wave.restitution(end)),
    ]
}
