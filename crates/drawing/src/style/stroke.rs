//! The patterns and colours of lines and of the areas of bands.

use super::scale::colour;

/// The dash pattern of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stroke {
    /// Unbroken.
    Solid,
    /// Dashes.
    Dashed,
    /// Dash, dot.
    DashDot,
    /// Dots.
    Dotted,
    /// Dash, two dots.
    DashDotDot,
    /// Long dashes.
    LongDash,
    /// Unbroken, in grey.
    Grey,
    /// Unbroken, in a colour of maps: its fraction of the scale in parts of 255.
    Graded(u8),
    /// The curve of this number in colour, unbroken.
    Colour(u8),
}

/// Colours that people with any colour vision tell apart (Okabe and Ito), the darkest first. Black is the colour of exact curves, and
/// yellow lines do not show on white.
pub(super) const COLOURS: [[u8; 3]; 6] = [
    [0, 114, 178],
    [213, 94, 0],
    [0, 158, 115],
    [204, 121, 167],
    [230, 159, 0],
    [86, 180, 233],
];

/// Opacity of the areas of bands in colour.
const OPACITY: f64 = 0.2;

/// Grey of measured curves: no colour of a curve, and lighter than all black ones.
pub(super) const GREY: [u8; 3] = [150; 3];

impl Stroke {
    /// Lengths of line and gap in turn; empty for an unbroken line.
    pub fn pattern(self) -> &'static [f64] {
        match self {
            Stroke::Solid | Stroke::Grey | Stroke::Graded(_) | Stroke::Colour(_) => &[],
            Stroke::Dashed => &[5.0, 2.2],
            Stroke::DashDot => &[7.0, 2.0, 1.2, 2.0],
            Stroke::Dotted => &[1.1, 1.7],
            Stroke::DashDotDot => &[7.0, 1.8, 1.2, 1.8, 1.2, 1.8],
            Stroke::LongDash => &[10.0, 3.0],
        }
    }

    /// The stroke of curve `i` of `count` in the order of a number, from dark to light. The
    /// lightest colours are not used, because they do not show on white.
    pub fn graded(i: usize, count: usize) -> Stroke {
        let grade = 0.85 * i as f64 / (count - 1).max(1) as f64;
        Stroke::Graded((255.0 * grade).round() as u8)
    }

    /// The stroke of a band that black lines cross.
    pub const LIGHT: Stroke = Stroke::Graded(217);

    /// Red, green and blue of the line.
    pub fn colour(self) -> [u8; 3] {
        match self {
            Stroke::Graded(grade) => colour(f64::from(grade) / 255.0),
            Stroke::Colour(i) => COLOURS[usize::from(i) % COLOURS.len()],
            Stroke::Grey => GREY,
            Stroke::Solid
            | Stroke::Dashed
            | Stroke::DashDot
            | Stroke::Dotted
            | Stroke::DashDotDot
            | Stroke::LongDash => [0, 0, 0],
        }
    }

    /// Red, green and blue of the area of a band, and its opacity: bands in colour show each other.
    pub fn fill(self) -> ([u8; 3], f64) {
        match self {
            Stroke::Grey | Stroke::Graded(_) | Stroke::Colour(_) => (self.colour(), OPACITY),
            Stroke::Solid
            | Stroke::Dashed
            | Stroke::DashDot
            | Stroke::Dotted
            | Stroke::DashDotDot
            | Stroke::LongDash => ([240; 3], 1.0),
        }
    }

    /// The hatching of the band of a black curve: `[a, b]` for lines along which a x + b y is constant, y downwards. None for a
    /// colour or in grey, whose bands are filled.
    pub fn hatching(self) -> &'static [[f64; 2]] {
        match self {
            Stroke::Grey | Stroke::Graded(_) | Stroke::Colour(_) => &[],
            Stroke::Solid => &[[1.0, 1.0]],
            Stroke::Dashed => &[[1.0, -1.0]],
            Stroke::DashDot => &[[1.0, 0.0]],
            Stroke::Dotted => &[[0.0, 1.0]],
            Stroke::DashDotDot => &[[1.0, 1.0], [1.0, -1.0]],
            Stroke::LongDash => &[[1.0, 0.0], [0.0, 1.0]],
        }
    }

    /// The pattern of the `i`-th curve of a panel.
    pub fn of_case(i: usize) -> Stroke {
        const TURN: [Stroke; 5] = [
            Stroke::Dashed,
            Stroke::DashDot,
            Stroke::Dotted,
            Stroke::DashDotDot,
            Stroke::LongDash,
        ];
        TURN[i % TURN.len()]
    }
}
