//! Curves, bands and bars, in the units of the axes.

use crate::style::{self, Marker, Stroke};

/// The label of a measured curve.
pub const MEASURED: &str = "measured";

/// A curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Label in the legend, in markup.
    pub label: String,
    /// Points in the axes' units; one that is not finite leaves a gap.
    pub points: Vec<[f64; 2]>,
    /// Pattern of the line.
    pub stroke: Stroke,
    /// Width of the line.
    pub width: f64,
    /// Marker at the points `marked`.
    pub marker: Option<Marker>,
    /// Indices of the points with a marker.
    pub marked: Vec<usize>,
}

impl Series {
    /// The line of an exact solution.
    pub fn exact(points: Vec<[f64; 2]>) -> Series {
        Series {
            label: "exact".into(),
            points,
            stroke: Stroke::Solid,
            width: style::EXACT_LINE,
            marker: None,
            marked: Vec::new(),
        }
    }

    /// The line of what was measured.
    pub fn measured(points: Vec<[f64; 2]>) -> Series {
        Series {
            label: MEASURED.into(),
            points,
            stroke: Stroke::Grey,
            width: style::MEASURED_LINE,
            marker: None,
            marked: Vec::new(),
        }
    }

    /// A thin line without an entry in the legend.
    pub fn rule(points: [[f64; 2]; 2]) -> Series {
        Series {
            label: String::new(),
            points: points.to_vec(),
            stroke: Stroke::Solid,
            width: style::ZERO_LINE,
            marker: None,
            marked: Vec::new(),
        }
    }
}

/// A part of a curve that is not drawn, because it coincides with others, which have their turn there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gap {
    /// Which of the panel's curves.
    pub series: usize,
    /// Its ends, as lengths along the visible curve.
    pub ends: [f64; 2],
}

/// The band between the envelopes of a part of a curve, in points of the curve by rising index. Both edges go from the
/// first to the last point of the part.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Envelope {
    /// Which of the panel's curves.
    pub series: usize,
    /// The upper edge.
    pub upper: Vec<usize>,
    /// The lower edge.
    pub lower: Vec<usize>,
}

/// An area between two lines through points in the axes' units, all of them finite.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    /// The upper line, from left to right.
    pub upper: Vec<[f64; 2]>,
    /// The lower line, from left to right.
    pub lower: Vec<[f64; 2]>,
    /// Pattern of both lines.
    pub stroke: Stroke,
}

/// A bar between two corners in the axes' units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bar {
    /// Its sides, rising.
    pub x: [f64; 2],
    /// Its lower and upper end.
    pub y: [f64; 2],
    /// Its fraction of the scale of colours.
    pub shade: f64,
}
