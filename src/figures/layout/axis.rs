//! An axis: its range, scale and ticks, and the place of a value along it.

use crate::study::Scale;

/// An axis: its range, and what stands along it.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// Title in markup; empty where another panel shares the axis and has it.
    pub title: String,
    /// First and last value.
    pub range: [f64; 2],
    /// Evenly or by the logarithm.
    pub scale: Scale,
    /// Ticks inside the range.
    pub ticks: Vec<Tick>,
    /// Whether the ticks have their numbers here.
    pub numbered: bool,
}

/// A tick.
#[derive(Debug, Clone, PartialEq)]
pub struct Tick {
    /// Value on the axis.
    pub at: f64,
    /// Number in markup; empty for a minor tick.
    pub label: String,
}

impl Axis {
    /// Where `value` lies: 0 at the first, 1 at the last value of the range; not finite where it has no place.
    pub fn fraction(&self, value: f64) -> f64 {
        let [a, b] = self.range;
        match self.scale {
            Scale::Linear if (b - a).is_finite() => (value - a) / (b - a),
            // Ends that lie further apart, or in a larger ratio, than the largest number.
            Scale::Linear => (value / 2.0 - a / 2.0) / (b / 2.0 - a / 2.0),
            Scale::Log if value > 0.0 && (b / a).is_finite() => {
                libm::log10(value / a) / libm::log10(b / a)
            }
            Scale::Log if value > 0.0 => {
                let over = |x: f64| libm::log10(x) - libm::log10(a);
                over(value) / over(b)
            }
            Scale::Log => f64::NAN,
        }
    }
}
