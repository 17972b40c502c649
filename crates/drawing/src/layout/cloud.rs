//! Dots of cases: a shape each if they are few, one image if they are many.

use crate::layout::axis::Axis;
use crate::style;

/// Most dots of a sheet that are a shape each.
pub const MOST_SHAPES: usize = 2000;

/// Dots, one a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Cloud {
    /// The dots, drawn in this order.
    pub dots: Vec<Dot>,
    /// Radius of a dot.
    pub radius: f64,
    /// Whether they are one image, because they are many.
    pub image: bool,
}

/// A dot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dot {
    /// Its place in the axes' units.
    pub at: [f64; 2],
    /// Its value along the colour bar, if it has one.
    pub value: Option<f64>,
    /// The fraction of the scale of colours for it.
    pub shade: f64,
}

impl Cloud {
    /// The dots of a panel, of `count` on the whole sheet; their values coloured along `colours`.
    pub fn of(
        points: impl Iterator<Item = ([f64; 2], Option<f64>)>,
        colours: Option<&Axis>,
        count: usize,
    ) -> Cloud {
        let dot = |(at, value): ([f64; 2], Option<f64>)| {
            let shade = match (colours, value) {
                (Some(colours), Some(value)) => colours.fraction(value),
                (None, _) | (_, None) => style::DOT_SHADE,
            };
            Dot { at, value, shade }
        };
        // The dots together cover the same area for any number of them, down to the smallest radius.
        let less = libm::sqrt(MOST_SHAPES as f64 / count.max(1) as f64);
        Cloud {
            dots: points.map(dot).collect(),
            radius: (style::DOT * less).clamp(style::SMALL_DOT, style::DOT),
            image: count > MOST_SHAPES,
        }
    }
}
