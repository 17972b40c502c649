//! How the curves of a figure are told apart.

use super::marker::Marker;
use super::stroke::{COLOURS, Stroke};

/// Most curves: as many as strokes and markers can distinguish, in black or in colour.
pub const MOST_STYLES: usize = 30;

/// How the curves of a figure are told apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Look {
    /// By colours, instead of by dashes and markers.
    pub colour: bool,
    /// Whether curves in colour have markers, too.
    pub markers: bool,
}

impl Look {
    /// The stroke of curve `i` of `count`; a single one is unbroken.
    pub fn stroke(self, i: usize, count: usize) -> Stroke {
        match self.colour {
            true => Stroke::Colour((i % MOST_STYLES) as u8),
            false if count == 1 => Stroke::Solid,
            false => Stroke::of_case(i),
        }
    }

    /// The marker of curve `i`. With the colours used up, the next curves have markers: dashes mean curves that coincide.
    pub fn marker(self, i: usize) -> Option<Marker> {
        let round = i % MOST_STYLES / COLOURS.len();
        match (self.colour && !self.markers, round) {
            (true, 0) => None,
            (true, round) => Some(Marker::of_case(round - 1)),
            // The same marker and colour come together again after a round of both.
            (false, round) => Some(Marker::of_case(if self.colour { i + round } else { i })),
        }
    }
}
