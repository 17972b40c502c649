//! Sizes, lines, markers and colours of the figures. Lengths are points of 1/72 inch.

mod marker;

pub use marker::Marker;

/// Width of a figure over one column of a journal, 90 mm.
pub const SINGLE: f64 = 255.0;
/// Width of a figure over one and a half columns, 140 mm.
pub const MIDDLE: f64 = 397.0;
/// Width of a figure over two columns, 180 mm.
pub const DOUBLE: f64 = 510.0;

/// Virtual units of the drawing backends in a point, so that integer coordinates do not show.
pub const UNITS: f64 = 64.0;
/// A length in virtual units.
pub fn units(length: f64) -> u32 {
    (length * UNITS).round() as u32
}

/// Pixels an inch of figures by default: twice those of a plain screen.
pub const DPI: u32 = 192;

/// Pixels of a point.
pub fn pixels(dpi: u32) -> f64 {
    f64::from(dpi) / 72.0
}

/// Type size of axis titles, headings and captions.
pub const TITLE: f64 = 9.5;
/// Type size of numbers at ticks, legends and notes.
pub const LABEL: f64 = 8.5;
/// Sub- and superscripts: size relative to that of the text.
pub const SCRIPT: f64 = 0.7;
/// How far a subscript drops, relative to the size of the text.
pub const SUBSCRIPT_DROP: f64 = 0.17;
/// How far a superscript rises, relative to the size of the text.
pub const SUPERSCRIPT_RISE: f64 = 0.36;
/// Height of digits and capitals relative to the type size, for centring on ticks.
pub const CAP_HEIGHT: f64 = 0.66;

/// Width of frames and ticks.
pub const FRAME_LINE: f64 = 0.6;
/// Width of the line at zero.
pub const ZERO_LINE: f64 = 0.3;
/// Width of the exact solution.
pub const EXACT_LINE: f64 = 0.6;
/// Width of a measured curve.
pub const MEASURED_LINE: f64 = 1.1;
/// Width of a contour line.
pub const CONTOUR_LINE: f64 = 0.45;
/// Width of the lines of hatched areas.
pub const HATCH_LINE: f64 = 0.35;
/// Distance of the lines of hatched areas along an axis.
pub const HATCH: f64 = 6.0;
/// Distance of the lines of hatched bands along an axis.
pub const BAND_HATCH: f64 = 4.0;
/// Colour of these lines, so that curves stand out from them.
pub const BAND_GREY: [u8; 3] = [140; 3];
/// Width of the line along the ridge of a map.
pub const RIDGE_LINE: f64 = 1.3;
/// Width of the light band under the best of all cases.
pub const FRONT_BAND: f64 = 5.0;
/// Width of a case's curve.
pub const CASE_LINE: f64 = 0.9;
/// Width of the edges of a band between envelopes.
pub const BAND_LINE: f64 = 0.45;
/// Width of a marker's outline.
pub const MARKER_LINE: f64 = 0.7;
/// Half the size of a marker.
pub const MARKER: f64 = 2.3;

/// Radius of a dot, one of few.
pub const DOT: f64 = 1.5;
/// Radius of a dot at a case of a map.
pub const MAP_DOT: f64 = 1.1;
/// Radius of a dot, one of very many.
pub const SMALL_DOT: f64 = 0.6;
/// Width of a dot's outline, where dots are few.
pub const DOT_LINE: f64 = 0.25;
/// The fraction of the scale of colours for a dot without a value: dark.
pub const DOT_SHADE: f64 = 0.2;

/// Length of the head of an arrow.
pub const ARROW: f64 = 5.0;
/// Length of a tick with a number, inwards.
pub const MAJOR_TICK: f64 = 4.5;
/// Length of a tick without one.
pub const MINOR_TICK: f64 = 2.5;
/// Distance of the numbers from the frame.
pub const LABEL_GAP: f64 = 4.0;
/// Distance of the axis title from the numbers.
pub const TITLE_GAP: f64 = 5.0;
/// Margin of the sheet.
pub const EDGE: f64 = 5.0;

/// Length of the piece of line in a legend.
pub const SAMPLE: f64 = 29.0;
/// Distance of the label from that piece.
pub const SAMPLE_GAP: f64 = 5.0;
/// Distance between the lines of a legend.
pub const LEADING: f64 = 12.0;

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
    /// The curve of this number in colour, unbroken as long as the colours last.
    Colour(u8),
}

/// Colours that people with any colour vision tell apart (Okabe and Ito), the darkest first. Black is the colour of exact curves, and
/// yellow lines do not show on white.
const COLOURS: [[u8; 3]; 6] = [
    [0, 114, 178],
    [213, 94, 0],
    [0, 158, 115],
    [204, 121, 167],
    [230, 159, 0],
    [86, 180, 233],
];

/// Grey of measured curves: no colour of a curve, and lighter than all black ones.
const GREY: [u8; 3] = [150; 3];

impl Stroke {
    /// Lengths of line and gap in turn; empty for an unbroken line.
    pub fn pattern(self) -> &'static [f64] {
        match self {
            Stroke::Solid | Stroke::Grey | Stroke::Graded(_) => &[],
            // With the colours used up, the next ones have dashes.
            Stroke::Colour(i) => match usize::from(i) / COLOURS.len() {
                0 => &[],
                round => Stroke::of_case(round - 1).pattern(),
            },
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
        let place = 0.85 * i as f64 / (count - 1).max(1) as f64;
        Stroke::Graded((255.0 * place).round() as u8)
    }

    /// The stroke of a band that black lines cross.
    pub const LIGHT: Stroke = Stroke::Graded(217);

    /// Red, green and blue of the line.
    pub fn colour(self) -> [u8; 3] {
        match self {
            Stroke::Graded(place) => colour(f64::from(place) / 255.0),
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

    /// Red, green and blue of the area of a band: light.
    pub fn fill(self) -> [u8; 3] {
        match self {
            Stroke::Grey | Stroke::Graded(_) | Stroke::Colour(_) => {
                self.colour().map(|part| 255 - (255 - part) / 3)
            }
            Stroke::Solid
            | Stroke::Dashed
            | Stroke::DashDot
            | Stroke::Dotted
            | Stroke::DashDotDot
            | Stroke::LongDash => [240; 3],
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

    /// The marker of curve `i`.
    pub fn marker(self, i: usize) -> Option<Marker> {
        (!self.colour || self.markers).then(|| Marker::of_case(i))
    }
}

/// Colours of a map at equal distances, dark (small) to light (large): matplotlib's viridis (CC0), whose lightness
/// rises evenly, so that it is readable in grey.
const VIRIDIS: [[u8; 3]; 11] = [
    [68, 1, 84],
    [72, 36, 117],
    [65, 68, 135],
    [53, 95, 141],
    [42, 120, 142],
    [33, 145, 140],
    [34, 168, 132],
    [68, 191, 112],
    [122, 209, 81],
    [189, 223, 38],
    [253, 231, 37],
];

/// The fraction of the scale of colours for band `k` of `count`: above 0.3, so that black lines and numbers
/// show on all of them.
pub fn band(k: usize, count: usize) -> f64 {
    0.3 + 0.7 * (k as f64 + 0.5) / count as f64
}

/// The colour at `fraction` of a map's range; values outside of 0..1 have the end colours.
pub fn colour(fraction: f64) -> [u8; 3] {
    let last = VIRIDIS.len() - 1;
    let at = fraction.clamp(0.0, 1.0) * last as f64;
    let i = (at as usize).min(last - 1);
    let blend = |k: usize| {
        let (a, b) = (f64::from(VIRIDIS[i][k]), f64::from(VIRIDIS[i + 1][k]));
        (a + (b - a) * (at - i as f64)).round() as u8
    };
    [blend(0), blend(1), blend(2)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn no_two_curves_look_the_same() {
        let black = Look::default();
        let mut looks = HashSet::new();
        for i in 0..MOST_STYLES {
            let stroke = black.stroke(i, MOST_STYLES);
            let dashes: Vec<u64> = stroke.pattern().iter().map(|x| x.to_bits()).collect();
            assert!(
                looks.insert((dashes, format!("{:?}", black.marker(i)))),
                "curve {i}"
            );
        }
        let colour = Look {
            colour: true,
            markers: false,
        };
        let mut looks = HashSet::new();
        for i in 0..MOST_STYLES {
            let stroke = colour.stroke(i, MOST_STYLES);
            let dashes: Vec<u64> = stroke.pattern().iter().map(|x| x.to_bits()).collect();
            assert!(looks.insert((dashes, stroke.colour())), "curve {i}");
            assert_eq!(stroke.pattern().is_empty(), i < COLOURS.len());
            assert_eq!(colour.marker(i), None);
        }
        assert_eq!(black.stroke(0, 1), Stroke::Solid);
        let both = Look {
            colour: true,
            markers: true,
        };
        assert_eq!(both.marker(2), black.marker(2));
    }

    /// Contrast of a colour with white (WCAG 2.2, relative luminance).
    fn contrast(rgb: [u8; 3]) -> f64 {
        let linear = |part: u8| {
            let c = f64::from(part) / 255.0;
            if c <= 0.04045 {
                c / 12.92
            } else {
                libm::pow((c + 0.055) / 1.055, 2.4)
            }
        };
        let [r, g, b] = rgb.map(linear);
        1.05 / (0.2126 * r + 0.7152 * g + 0.0722 * b + 0.05)
    }

    #[test]
    fn colours_show_on_white() {
        // Twice is enough for a line on paper; the yellow of the same palette has 1.3.
        assert!(
            COLOURS
                .iter()
                .chain([&GREY])
                .all(|rgb| contrast(*rgb) > 2.0)
        );
        assert!(contrast([240, 228, 66]) < 1.4);
    }
}
