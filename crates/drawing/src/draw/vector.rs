//! The drawing backend behind SVG files: glyphs are outlines, so that no font is needed.

use super::base64;
use super::raster;
use crate::DrawingError;
use crate::style::{self, UNITS};
use crate::text::font::{self, Glyph};
use crate::text::outline::ToData;
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind,
    FontStyle, FontTransform,
};
use std::collections::BTreeSet;
use std::fmt::Write;

type Drawn = Result<(), DrawingErrorKind<DrawingError>>;

/// An SVG drawing; its user units are the virtual units of the drawing.
pub struct Vector {
    size: (u32, u32),
    /// Pixels an inch of images.
    dpi: u32,
    title: String,
    description: String,
    glyphs: BTreeSet<Glyph>,
    body: String,
    /// Colour, width and path data of the strokes not written yet: neighbours in one style share an element.
    strokes: (String, u32, String),
    /// Colour and path data of the filled rectangles not written yet, which share elements too.
    cells: (String, String),
}

impl Vector {
    /// A drawing of the given size in points, with its title and description in plain text.
    pub fn new(width: f64, height: f64, title: &str, description: &str, dpi: u32) -> Vector {
        Vector {
            size: (style::units(width), style::units(height)),
            dpi,
            title: escape(title),
            description: escape(description),
            glyphs: BTreeSet::new(),
            body: String::new(),
            strokes: Default::default(),
            cells: Default::default(),
        }
    }

    /// The complete file.
    pub fn svg(&mut self) -> String {
        self.flush();
        let (w, h) = self.size;
        let [width, height] = [w, h].map(|units| f64::from(units) / UNITS);
        let mut out = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}pt\" height=\"{height}pt\" \
             viewBox=\"0 0 {w} {h}\" role=\"img\">\n\
             <title>{}</title>\n<desc>{}</desc>\n<defs>\n",
            self.title, self.description
        );
        for glyph in &self.glyphs {
            let mut pen = ToData(String::new());
            glyph.outline(&mut pen);
            let _ = writeln!(out, "<path id=\"{}\" d=\"{}\"/>", glyph.name(), pen.0);
        }
        let _ = writeln!(
            out,
            "</defs>\n<rect width=\"{w}\" height=\"{h}\" fill=\"#fff\"/>"
        );
        out + &self.body + "</svg>\n"
    }

    fn flush(&mut self) {
        let (colour, width, data) = std::mem::take(&mut self.strokes);
        if !data.is_empty() {
            self.write(format_args!(
                "<path fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\" d=\"{data}\"/>"
            ));
        }
        let (colour, data) = std::mem::take(&mut self.cells);
        if !data.is_empty() {
            // Without smoothing, so that neighbouring cells of a map leave no seam.
            self.write(format_args!(
                "<path fill=\"{colour}\" shape-rendering=\"crispEdges\" d=\"{data}\"/>"
            ));
        }
    }

    fn element(&mut self, element: std::fmt::Arguments) {
        self.flush();
        self.write(element);
    }

    fn write(&mut self, element: std::fmt::Arguments) {
        // Writing to a string cannot fail.
        let _ = writeln!(self.body, "{element}");
    }
}

/// Text as XML 1.0 has it: what it cannot hold at all becomes the replacement character.
pub fn escape(text: &str) -> String {
    // Of the control characters tab and line ends; of the rest all but the two noncharacters (section 2.2, Char).
    let held = |c: char| match c {
        '\t' | '\n' | '\r' | ' '..='\u{fffd}' | '\u{10000}'.. => c,
        _ => char::REPLACEMENT_CHARACTER,
    };
    let text: String = text.chars().map(held).collect();
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

fn colour(colour: BackendColor) -> String {
    let (r, g, b) = colour.rgb;
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// Path data of a line through points, with relative steps; closed where it ends where it began.
fn data(points: &[BackendCoord]) -> String {
    let mut out = String::new();
    let mut before = (0, 0);
    let closed = points.len() > 2 && points.first() == points.last();
    let open = points.len() - usize::from(closed);
    for (i, &(x, y)) in points[..open].iter().enumerate() {
        let _ = match i {
            0 => write!(out, "M{x} {y}"),
            _ => write!(out, "l{} {}", x - before.0, y - before.1),
        };
        before = (x, y);
    }
    if closed {
        out.push('z');
    }
    out
}

impl DrawingBackend for Vector {
    type ErrorType = DrawingError;

    fn get_size(&self) -> (u32, u32) {
        self.size
    }

    fn ensure_prepared(&mut self) -> Drawn {
        Ok(())
    }

    fn present(&mut self) -> Drawn {
        Ok(())
    }

    fn draw_pixel(&mut self, (x, y): BackendCoord, colour: BackendColor) -> Drawn {
        self.draw_rect((x, y), (x + 1, y + 1), &colour, true)
    }

    fn draw_line<S: BackendStyle>(&mut self, a: BackendCoord, b: BackendCoord, style: &S) -> Drawn {
        self.draw_path([a, b], style)
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        points: I,
        style: &S,
    ) -> Drawn {
        let points: Vec<_> = points.into_iter().collect();
        let (colour, width) = (colour(style.color()), style.stroke_width());
        if self.strokes.0 != colour || self.strokes.1 != width || !self.cells.1.is_empty() {
            self.flush();
            self.strokes = (colour, width, String::new());
        }
        self.strokes.2 += &data(&points);
        Ok(())
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        (x0, y0): BackendCoord,
        (x1, y1): BackendCoord,
        style: &S,
        fill: bool,
    ) -> Drawn {
        if !fill {
            return self.draw_path([(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)], style);
        }
        let colour = colour(style.color());
        let (w, h) = (x1 - x0, y1 - y0);
        if self.cells.0 != colour || !self.strokes.2.is_empty() {
            self.flush();
            self.cells.0 = colour;
        }
        // Writing to a string cannot fail.
        let _ = write!(self.cells.1, "M{x0} {y0}h{w}v{h}h{}z", -w);
        Ok(())
    }

    fn draw_circle<S: BackendStyle>(
        &mut self,
        (x, y): BackendCoord,
        radius: u32,
        style: &S,
        fill: bool,
    ) -> Drawn {
        let (colour, width) = (colour(style.color()), style.stroke_width());
        let paint = if fill {
            format!("fill=\"{colour}\"")
        } else {
            format!("fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\"")
        };
        self.element(format_args!(
            "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" {paint}/>"
        ));
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        points: I,
        style: &S,
    ) -> Drawn {
        let points: Vec<_> = points.into_iter().collect();
        let (colour, data) = (colour(style.color()), data(&points));
        let opacity = match style.color().alpha {
            1.0 => String::new(),
            opacity => format!(" fill-opacity=\"{opacity}\""),
        };
        self.element(format_args!(
            "<path fill=\"{colour}\"{opacity} d=\"{data}z\"/>"
        ));
        Ok(())
    }

    fn blit_bitmap(&mut self, (x, y): BackendCoord, (w, h): (u32, u32), bytes: &[u8]) -> Drawn {
        let png = raster::png((w, h), bytes.to_vec(), self.dpi)
            .map_err(DrawingErrorKind::DrawingError)?;
        let dots = style::pixels(self.dpi);
        let [width, height] = [w, h].map(|pixels| f64::from(pixels) * UNITS / dots);
        self.element(format_args!(
            "<image x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" \
             href=\"data:image/png;base64,{}\"/>",
            base64::text(&png)
        ));
        Ok(())
    }

    fn draw_text<S: BackendTextStyle>(&mut self, text: &str, style: &S, at: BackendCoord) -> Drawn {
        let (x, y) = at;
        let turned = matches!(style.transform(), FontTransform::Rotate270);
        let turn = if turned { " rotate(-90)" } else { "" };
        let glyphs = font::set(text, matches!(style.style(), FontStyle::Italic)).0;
        let Some((first, _)) = glyphs.first() else {
            return Ok(());
        };
        let per_em = first.per_em();
        let scale = style.size() / per_em;
        self.element(format_args!(
            "<g transform=\"translate({x} {y}){turn} scale({scale:.4} {:.4})\" fill=\"{}\">",
            -scale,
            colour(style.color())
        ));
        for (glyph, x) in glyphs {
            self.glyphs.insert(glyph);
            let x = x * per_em;
            self.write(format_args!(
                "<use href=\"#{}\" x=\"{x:.0}\"/>",
                glyph.name()
            ));
        }
        self.write(format_args!("</g>"));
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_text_is_well_formed_xml() {
        // XML 1.0, section 2.2: Char ::= #x9 | #xA | #xD | [#x20-#xD7FF] | [#xE000-#xFFFD] | [#x10000-#x10FFFF].
        let characters: String = ('\0'..=char::MAX).collect();
        let escaped = escape(&characters);
        let is_char = |c: char| matches!(u32::from(c), 0x9 | 0xa | 0xd | 0x20..=0xd7ff | 0xe000..=0xfffd | 0x1_0000..=0x10_ffff);
        assert!(escaped.chars().all(is_char));
        assert!(!escaped.contains(['<', '>', '"']));
        // All 29 control characters but three, and U+FFFE and U+FFFF; U+FFFD is there itself.
        assert_eq!(escaped.matches('\u{fffd}').count(), 29 + 2 + 1);
        assert_eq!(escape("\u{1b}[1m & \u{ffff}"), "\u{fffd}[1m &amp; \u{fffd}");
        let drawn = Vector::new(10.0, 10.0, "a\0b", "\u{fffe}", style::DPI).svg();
        assert!(drawn.contains("<title>a\u{fffd}b</title>") && drawn.chars().all(is_char));
    }
}
