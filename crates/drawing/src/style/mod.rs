//! Sizes, lines, markers and colours of the figures. Lengths are points of 1/72 inch.

mod look;
mod marker;
mod scale;
mod stroke;

pub use look::{Look, MOST_STYLES};
pub use marker::Marker;
pub use scale::{band, colour};
pub use stroke::Stroke;

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

#[cfg(test)]
mod tests {
    use super::stroke::{COLOURS, GREY};
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
        let both = Look {
            colour: true,
            markers: true,
        };
        for look in [colour, both] {
            let mut looks = HashSet::new();
            for i in 0..MOST_STYLES {
                let stroke = look.stroke(i, MOST_STYLES);
                let marker = format!("{:?}", look.marker(i));
                assert!(looks.insert((marker, stroke.colour())), "curve {i}");
                // Dashes of colours mean curves that coincide.
                assert!(stroke.pattern().is_empty());
            }
        }
        for i in 0..COLOURS.len() {
            assert_eq!(colour.marker(i), None);
        }
        assert_eq!(black.stroke(0, 1), Stroke::Solid);
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
