//! An axis: its range, scale and ticks, and the place of a value along it.

pub use slipgap_notation::Scale;

use crate::text::number;
use crate::{style, text};

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

    /// The same; unless it is `labelled`, without title and numbers, which another panel shows.
    pub fn labelled(mut self, labelled: bool) -> Axis {
        if !labelled {
            self.title.clear();
            self.numbered = false;
        }
        self
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

/// Distance of the lines of a title.
pub const TITLE_LINE: f64 = style::TITLE + 3.0;

/// The lines of the title of a horizontal axis of this length; beside the last one is the power of its numbers.
pub fn horizontal_title(axis: &Axis, length: f64) -> Vec<String> {
    let power = match axis.power {
        0 => 0.0,
        _ => text::width(&axis.power_label(), style::LABEL) + style::TITLE_GAP,
    };
    // It may reach over both ends a little.
    text::wrap(
        &axis.title,
        style::TITLE,
        length + 2.0 * style::EDGE - power,
    )
}

/// Height of the numbers and title of a horizontal axis below its frame, if the title needs one line.
pub fn below(axis: &Axis) -> f64 {
    foot(axis, f64::INFINITY)
}

/// Height of the numbers and title of a horizontal axis of this length below its frame.
pub fn foot(axis: &Axis, length: f64) -> f64 {
    let numbers = if axis.numbered {
        style::LABEL_GAP + style::LABEL
    } else {
        0.0
    };
    let lines = match axis.numbered && axis.power != 0 {
        true => horizontal_title(axis, length).len().max(1),
        false => horizontal_title(axis, length).len(),
    };
    let title = match lines {
        0 => 0.0,
        lines => style::TITLE_GAP + style::TITLE + (lines - 1) as f64 * TITLE_LINE,
    };
    numbers + title
}
