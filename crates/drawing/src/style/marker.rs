//! The markers of curves.

use super::MARKER;

/// An open marker, filled white so that the line does not run through it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Marker {
    /// Circle.
    Circle,
    /// Triangle, point up.
    Triangle,
    /// Square.
    Square,
    /// Square on its corner.
    Diamond,
    /// Triangle, point down.
    InvertedTriangle,
    /// Two strokes crossing.
    Cross,
    /// A dark bar.
    Dark,
    /// A light bar.
    Light,
    /// A hatched area.
    Hatched,
}

impl Marker {
    /// Number of different markers of curves.
    pub const KINDS: usize = 6;

    /// The marker of the `i`-th curve of a panel; strokes and markers distinguish thirty curves.
    pub fn of_case(i: usize) -> Marker {
        const TURN: [Marker; Marker::KINDS] = [
            Marker::Circle,
            Marker::Triangle,
            Marker::Square,
            Marker::Diamond,
            Marker::InvertedTriangle,
            Marker::Cross,
        ];
        TURN[i % TURN.len()]
    }

    /// The fraction of the scale of colours for a bar; different in grey.
    pub fn shade(self) -> f64 {
        if self == Marker::Dark { 0.25 } else { 0.85 }
    }

    /// The corners about the origin, y downwards, of equal visual weight; none for circle and cross.
    pub fn corners(self) -> &'static [[f64; 2]] {
        const M: f64 = MARKER;
        match self {
            Marker::Circle | Marker::Cross | Marker::Dark | Marker::Light | Marker::Hatched => &[],
            Marker::Triangle => &[[0.0, -1.25 * M], [1.15 * M, 0.8 * M], [-1.15 * M, 0.8 * M]],
            Marker::InvertedTriangle => {
                &[[0.0, 1.25 * M], [-1.15 * M, -0.8 * M], [1.15 * M, -0.8 * M]]
            }
            Marker::Square => &[
                [-0.9 * M, -0.9 * M],
                [0.9 * M, -0.9 * M],
                [0.9 * M, 0.9 * M],
                [-0.9 * M, 0.9 * M],
            ],
            Marker::Diamond => &[
                [0.0, -1.3 * M],
                [1.3 * M, 0.0],
                [0.0, 1.3 * M],
                [-1.3 * M, 0.0],
            ],
        }
    }
}
