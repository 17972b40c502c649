//! The drawing backend behind PDF files: vector paths, and text in subsets of the embedded fonts.

mod compressed;
mod fonts;
mod objects;

use crate::DrawingError;
use crate::style::{self, UNITS};
use crate::text::font;
use fonts::Fonts;
use objects::{Opacities, Picture};
use pdf_writer::{Content, Name, Str};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind,
    FontStyle, FontTransform,
};

type Drawn = Result<(), DrawingErrorKind<DrawingError>>;

/// Red, green and blue.
type Rgb = (u8, u8, u8);

/// Width of the seam that is painted round filled rectangles, in points.
const SEAM: f64 = 0.5;

/// Distance of the control points of a quarter circle from its ends, over the radius.
const QUARTER: f32 = 0.552_284_8;

/// A PDF page; its user units are the virtual units of the drawing, y downwards.
pub struct Page {
    /// Size in points.
    size: [f64; 2],
    dots: f64,
    title: String,
    content: Content,
    /// Colour and width of lines, and colour of areas, as the page has them now.
    line: Option<(Rgb, u32)>,
    area: Option<Rgb>,
    /// Filled rectangles not written yet: colour and corners.
    cells: Vec<(Rgb, [i32; 4])>,
    fonts: Fonts,
    pictures: Vec<Picture>,
    opacities: Opacities,
}

impl Page {
    /// A page of the given size in points with its title in plain text, on which images have `dots` pixels a point.
    pub fn new(width: f64, height: f64, title: &str, dots: f64) -> Page {
        let mut content = Content::new();
        let unit = (1.0 / UNITS) as f32;
        content.transform([unit, 0.0, 0.0, -unit, 0.0, height as f32]);
        // As the other backends have it.
        content.set_miter_limit(4.0);
        Page {
            size: [width, height],
            dots,
            title: title.to_owned(),
            content,
            line: None,
            area: None,
            cells: Vec::new(),
            fonts: Fonts::default(),
            pictures: Vec::new(),
            opacities: Opacities::default(),
        }
    }

    /// The complete file.
    pub fn pdf(&mut self) -> Result<Vec<u8>, DrawingError> {
        self.flush();
        let content = std::mem::replace(&mut self.content, Content::new()).finish();
        objects::file(
            self.size,
            &self.title,
            content.as_slice(),
            &self.fonts,
            &self.pictures,
            &self.opacities,
        )
    }

    /// Writes the pending filled rectangles, first a little larger: viewers smooth edges, which would leave light seams.
    fn flush(&mut self) {
        let cells = std::mem::take(&mut self.cells);
        let seam = style::units(SEAM);
        for larger in [true, false] {
            for (colour, [x, y, width, height]) in &cells {
                self.fill_in(*colour);
                let [x, y, width, height] = [*x, *y, *width, *height].map(|v| v as f32);
                self.content.rect(x, y, width, height);
                if larger {
                    self.stroke_in(*colour, seam);
                    self.content.fill_nonzero_and_stroke();
                } else {
                    self.content.fill_nonzero();
                }
            }
        }
    }

    fn stroke_in(&mut self, colour: Rgb, width: u32) {
        if self.line != Some((colour, width)) {
            let [r, g, b] = parts(colour);
            self.content.set_stroke_rgb(r, g, b);
            self.content.set_line_width(width as f32);
            self.line = Some((colour, width));
        }
    }

    fn fill_in(&mut self, colour: Rgb) {
        if self.area != Some(colour) {
            let [r, g, b] = parts(colour);
            self.content.set_fill_rgb(r, g, b);
            self.area = Some(colour);
        }
    }

    /// Adds a line through points to the path; closed where it ends where it began.
    fn trace(&mut self, points: &[BackendCoord]) {
        let closed = points.len() > 2 && points.first() == points.last();
        let open = points.len() - usize::from(closed);
        for (i, (x, y)) in points[..open].iter().enumerate() {
            let (x, y) = (*x as f32, *y as f32);
            match i {
                0 => self.content.move_to(x, y),
                _ => self.content.line_to(x, y),
            };
        }
        if closed {
            self.content.close_path();
        }
    }
}

/// Parts of a colour from 0 to 1.
fn parts((r, g, b): Rgb) -> [f32; 3] {
    [r, g, b].map(|part| f32::from(part) / 255.0)
}

impl DrawingBackend for Page {
    type ErrorType = DrawingError;

    fn get_size(&self) -> (u32, u32) {
        (style::units(self.size[0]), style::units(self.size[1]))
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
        self.flush();
        self.stroke_in(style.color().rgb, style.stroke_width());
        self.trace(&points.into_iter().collect::<Vec<_>>());
        self.content.stroke();
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
        self.cells
            .push((style.color().rgb, [x0, y0, x1 - x0, y1 - y0]));
        Ok(())
    }

    fn draw_circle<S: BackendStyle>(
        &mut self,
        (x, y): BackendCoord,
        radius: u32,
        style: &S,
        fill: bool,
    ) -> Drawn {
        self.flush();
        let (x, y, r) = (x as f32, y as f32, radius as f32);
        let k = QUARTER * r;
        self.content.move_to(x + r, y);
        for [a, b, c] in [
            [[r, k], [k, r], [0.0, r]],
            [[-k, r], [-r, k], [-r, 0.0]],
            [[-r, -k], [-k, -r], [0.0, -r]],
            [[k, -r], [r, -k], [r, 0.0]],
        ] {
            let [a, b, c] = [a, b, c].map(|[dx, dy]| [x + dx, y + dy]);
            self.content.cubic_to(a[0], a[1], b[0], b[1], c[0], c[1]);
        }
        self.content.close_path();
        if fill {
            self.fill_in(style.color().rgb);
            self.content.fill_nonzero();
        } else {
            self.stroke_in(style.color().rgb, style.stroke_width());
            self.content.stroke();
        }
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        points: I,
        style: &S,
    ) -> Drawn {
        self.flush();
        let BackendColor { rgb, alpha } = style.color();
        self.fill_in(rgb);
        if alpha < 1.0 {
            let name = self.opacities.name(alpha);
            self.content.save_state();
            self.content.set_parameters(Name(name.as_bytes()));
        }
        self.trace(&points.into_iter().collect::<Vec<_>>());
        self.content.fill_nonzero();
        if alpha < 1.0 {
            self.content.restore_state();
        }
        Ok(())
    }

    fn blit_bitmap(&mut self, (x, y): BackendCoord, size: (u32, u32), bytes: &[u8]) -> Drawn {
        self.flush();
        let [width, height] = [size.0, size.1].map(|p| (f64::from(p) * UNITS / self.dots) as f32);
        let picture = Picture::new(self.pictures.len(), size, bytes);
        // An image is a unit square with its first row at the top, where y points upwards.
        self.content.save_state();
        self.content
            .transform([width, 0.0, 0.0, -height, x as f32, y as f32 + height]);
        self.content.x_object(Name(picture.name.as_bytes()));
        self.content.restore_state();
        self.pictures.push(picture);
        Ok(())
    }

    fn draw_text<S: BackendTextStyle>(
        &mut self,
        text: &str,
        style: &S,
        (x, y): BackendCoord,
    ) -> Drawn {
        self.flush();
        self.fill_in(style.color().rgb);
        let (x, y) = (f64::from(x), f64::from(y));
        let upwards = matches!(style.transform(), FontTransform::Rotate270);
        let (glyphs, _) = font::set(text, matches!(style.style(), FontStyle::Italic));
        let glyphs: Vec<_> = glyphs.into_iter().zip(text.chars()).collect();
        self.content.begin_text();
        // A piece of each font in turn.
        for piece in glyphs.chunk_by(|((a, _), _), ((b, _), _)| a.face() == b.face()) {
            let Some(((first, start), _)) = piece.first() else {
                continue;
            };
            let name = self.fonts.name(first.face());
            self.content
                .set_font(Name(name.as_bytes()), style.size() as f32);
            let along = start * style.size();
            // Text has y upwards.
            let matrix = match upwards {
                false => [1.0, 0.0, 0.0, -1.0, (x + along) as f32, y as f32],
                true => [0.0, -1.0, -1.0, 0.0, x as f32, (y - along) as f32],
            };
            self.content.set_text_matrix(matrix);
            let mut shown = self.content.show_positioned();
            let mut items = shown.items();
            let mut end = *start;
            for ((glyph, from), c) in piece {
                // In thousandths, to the left.
                let closer = (1000.0 * (end - from)).round();
                if closer != 0.0 {
                    items.adjust(closer as f32);
                }
                items.show(Str(&self.fonts.code(*glyph, *c).to_be_bytes()));
                end = from + glyph.advance();
            }
        }
        self.content.end_text();
        Ok(())
    }
}
