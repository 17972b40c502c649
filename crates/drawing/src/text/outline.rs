//! Glyph outlines as a path of pixels, and as the path data of SVG.

use read_fonts::ps::cs::CommandSink;
use read_fonts::types::Fixed;
use std::fmt::Write;
use tiny_skia::PathBuilder;

/// Adds outlines to a path at their place on the sheet.
pub struct ToPixels {
    /// The path so far, in pixels.
    pub path: PathBuilder,
    /// Beginning of the base line, in pixels.
    pub origin: [f64; 2],
    /// Place of the glyph along the line, in pixels.
    pub along: f64,
    /// Pixels of a unit of the font.
    pub scale: f64,
    /// Whether the line is turned to read from below.
    pub upwards: bool,
}

impl ToPixels {
    fn place(&self, x: Fixed, y: Fixed) -> (f32, f32) {
        let along = self.along + x.to_f64() * self.scale;
        let above = y.to_f64() * self.scale;
        let [x, y] = self.origin;
        let (x, y) = if self.upwards {
            (x - above, y - along)
        } else {
            (x + along, y - above)
        };
        (x as f32, y as f32)
    }
}

impl CommandSink for ToPixels {
    fn move_to(&mut self, x: Fixed, y: Fixed) {
        let (x, y) = self.place(x, y);
        self.path.move_to(x, y);
    }

    fn line_to(&mut self, x: Fixed, y: Fixed) {
        let (x, y) = self.place(x, y);
        self.path.line_to(x, y);
    }

    fn curve_to(&mut self, x1: Fixed, y1: Fixed, x2: Fixed, y2: Fixed, x: Fixed, y: Fixed) {
        let ((x1, y1), (x2, y2)) = (self.place(x1, y1), self.place(x2, y2));
        let (x, y) = self.place(x, y);
        self.path.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.path.close();
    }
}

/// Writes outlines as path data in units of the font.
pub struct ToData(pub String);

impl CommandSink for ToData {
    fn move_to(&mut self, x: Fixed, y: Fixed) {
        let _ = write!(self.0, "M{x} {y}");
    }

    fn line_to(&mut self, x: Fixed, y: Fixed) {
        let _ = write!(self.0, "L{x} {y}");
    }

    fn curve_to(&mut self, x1: Fixed, y1: Fixed, x2: Fixed, y2: Fixed, x: Fixed, y: Fixed) {
        let _ = write!(self.0, "C{x1} {y1} {x2} {y2} {x} {y}");
    }

    fn close(&mut self) {
        self.0.push('Z');
    }
}
