//! An axis: its range, scale and ticks, and the place of a value along it.

pub use slipgap_notation::Scale;

use crate::text::number;

/// An axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// Title in markup; empty if another panel shows it.
    pub title: String,
    /// First and last value.
    pub range: [f64; 2],
    /// Linear or logarithmic.
    pub scale: Scale,
    /// Ticks inside the range.
    pub ticks: Vec<Tick>,
    /// The power of ten that the numbers of all ticks leave out.
    pub power: i32,
    /// Whether this panel shows the numbers of the ticks.
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
    /// The power of ten of the numbers, in markup; empty without one.
    pub fn power_label(&self) -> String {
        match self.power {
            0 => String::new(),
            power => format!("× 10^{power}^").replace('-', "−"),
        }
    }

    /// The same with whole numbers at the ticks, where there is no room for the power.
    pub fn with_power_at_each(mut self) -> Axis {
        let has_power = std::mem::take(&mut self.power) != 0;
        for tick in self.ticks.iter_mut().filter(|_| has_power) {
            if !tick.label.is_empty() {
                tick.label = number::short(tick.at);
            }
        }
        self
    }

    /// The value at a fraction of the range.
    pub fn value(&self, fraction: f64) -> f64 {
        let [a, b] = self.range;
        match self.scale {
            Scale::Linear => a + (b - a) * fraction,
            Scale::Log => a * libm::pow(b / a, fraction),
        }
    }

    /// The fraction of the range at `value`: 0 at its first, 1 at its last value; not finite for a value without a place.
    pub fn fraction(&self, value: f64) -> f64 {
        let [a, b] = self.range;
        match self.scale {
            Scale::Linear if (b - a).is_finite() => (value - a) / (b - a),
            // The difference or ratio of the ends is larger than the largest number.
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
