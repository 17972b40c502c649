//! The drawing backend behind PNG files: tiny-skia at sub-pixel coordinates.

use crate::DrawingError;
use crate::style::{self, UNITS};
use crate::text::font;
use crate::text::outline::ToPixels;
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind,
    FontStyle, FontTransform,
};
use std::convert::Infallible;
use tiny_skia::{Color, FillRule, Paint, Path, PathBuilder, Pixmap, Rect, Stroke, Transform};

type Drawn = Result<(), DrawingErrorKind<Infallible>>;

/// Most pixels of a picture: half a gigabyte.
const MOST_PIXELS: u64 = 1 << 27;

/// A white sheet of pixels.
pub struct Raster {
    pixels: Pixmap,
    size: (u32, u32),
    dpi: u32,
    /// Pixels of a virtual unit.
    scale: f64,
}

impl Raster {
    /// A sheet of the given size in points.
    pub fn new(width: f64, height: f64, dpi: u32) -> Result<Raster, DrawingError> {
        let dots = style::pixels(dpi);
        let [w, h] = [width, height].map(|length| (length * dots).round() as u32);
        if u64::from(w) * u64::from(h) > MOST_PIXELS {
            return Err(DrawingError::TooLarge(format!(
                "a figure of {w} x {h} pixels; allowed: at most {MOST_PIXELS} in all; give a smaller --dpi"
            )));
        }
        let mut pixels = Pixmap::new(w, h)
            .ok_or_else(|| DrawingError::Internal(format!("a figure of {w} x {h} pixels")))?;
        pixels.fill(Color::WHITE);
        Ok(Raster {
            pixels,
            size: (style::units(width), style::units(height)),
            dpi,
            scale: dots / UNITS,
        })
    }

    /// The sheet as a PNG file.
    pub fn png(&self) -> Result<Vec<u8>, DrawingError> {
        let (size, bytes) = self.rgb();
        png(size, bytes, self.dpi)
    }

    /// Its size in pixels, and red, green and blue of each, row by row.
    pub fn rgb(&self) -> ((u32, u32), Vec<u8>) {
        let (pixels, _) = self.pixels.data().as_chunks::<4>();
        let bytes = pixels.iter().flat_map(|[r, g, b, _]| [*r, *g, *b]);
        let size = (self.pixels.width(), self.pixels.height());
        (size, bytes.collect())
    }

    fn pixel(&self, coordinate: i32) -> f32 {
        (f64::from(coordinate) * self.scale) as f32
    }

    /// The line through points, in pixels.
    fn outline(&self, points: &[BackendCoord], closed: bool) -> Option<Path> {
        let mut path = PathBuilder::new();
        for (i, (x, y)) in points.iter().enumerate() {
            match i {
                0 => path.move_to(self.pixel(*x), self.pixel(*y)),
                _ => path.line_to(self.pixel(*x), self.pixel(*y)),
            }
        }
        if closed {
            path.close();
        }
        path.finish()
    }

    /// An upright or level line (a tick, a side of a frame) as whole pixels, so that it is crisp.
    fn crisp(&self, points: &[BackendCoord], width: f64) -> Option<Rect> {
        let [(x0, y0), (x1, y1)] = *points else {
            return None;
        };
        let thick = (width * self.scale).round().max(1.0);
        // The middle on the nearest place at which both edges fall between pixels.
        let across = |middle: i32| (f64::from(middle) * self.scale - thick / 2.0).round();
        let (left, top, right, bottom) = if x0 == x1 {
            let left = across(x0);
            let (a, b) = (y0.min(y1), y0.max(y1));
            (
                left,
                f64::from(a) * self.scale,
                left + thick,
                f64::from(b) * self.scale,
            )
        } else if y0 == y1 {
            let top = across(y0);
            let (a, b) = (x0.min(x1), x0.max(x1));
            (
                f64::from(a) * self.scale,
                top,
                f64::from(b) * self.scale,
                top + thick,
            )
        } else {
            return None;
        };
        Rect::from_ltrb(left as f32, top as f32, right as f32, bottom as f32)
    }

    fn fill(&mut self, path: Option<Path>, colour: BackendColor, smooth: bool) {
        if let Some(path) = path {
            let paint = paint(colour, smooth);
            let transform = Transform::identity();
            self.pixels
                .fill_path(&path, &paint, FillRule::Winding, transform, None);
        }
    }
}

/// Red, green and blue bytes of pixels as a PNG file, in grey where they have no colour, with its resolution.
pub fn png((width, height): (u32, u32), bytes: Vec<u8>, dpi: u32) -> Result<Vec<u8>, DrawingError> {
    let (pixels, _) = bytes.as_chunks::<3>();
    let (colour, bytes) = if pixels.iter().all(|[r, g, b]| r == g && g == b) {
        let grey = pixels.iter().map(|pixel| pixel[0]).collect();
        (png::ColorType::Grayscale, grey)
    } else {
        (png::ColorType::Rgb, bytes)
    };
    let mut file = Vec::new();
    let fault = |error: png::EncodingError| DrawingError::Internal(format!("PNG: {error}"));
    let mut encoder = png::Encoder::new(&mut file, width, height);
    encoder.set_color(colour);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    let per_metre = (f64::from(dpi) / 0.0254).round() as u32;
    encoder.set_pixel_dims(Some(png::PixelDimensions {
        xppu: per_metre,
        yppu: per_metre,
        unit: png::Unit::Meter,
    }));
    let mut writer = encoder.write_header().map_err(fault)?;
    writer.write_image_data(&bytes).map_err(fault)?;
    writer.finish().map_err(fault)?;
    Ok(file)
}

fn paint(colour: BackendColor, smooth: bool) -> Paint<'static> {
    let mut paint = Paint {
        anti_alias: smooth,
        ..Paint::default()
    };
    let (r, g, b) = colour.rgb;
    paint.set_color_rgba8(r, g, b, (colour.alpha * 255.0).round() as u8);
    paint
}

impl DrawingBackend for Raster {
    type ErrorType = Infallible;

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
        let width = f64::from(style.stroke_width());
        if let Some(rect) = self.crisp(&points, width) {
            self.fill(Some(PathBuilder::from_rect(rect)), style.color(), true);
        } else if let Some(path) = self.outline(&points, points.first() == points.last()) {
            let stroke = Stroke {
                width: (width * self.scale) as f32,
                ..Stroke::default()
            };
            let (paint, transform) = (paint(style.color(), true), Transform::identity());
            self.pixels
                .stroke_path(&path, &paint, &stroke, transform, None);
        }
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
            for side in [
                [(x0, y0), (x1, y0)],
                [(x1, y0), (x1, y1)],
                [(x1, y1), (x0, y1)],
                [(x0, y1), (x0, y0)],
            ] {
                self.draw_path(side, style)?;
            }
            return Ok(());
        }
        // Whole pixels, so that neighbouring cells of a map leave no seam.
        let [left, top, right, bottom] = [x0, y0, x1, y1].map(|v| self.pixel(v).round());
        let rect = Rect::from_ltrb(left, top, right, bottom);
        self.fill(rect.map(PathBuilder::from_rect), style.color(), false);
        Ok(())
    }

    fn draw_circle<S: BackendStyle>(
        &mut self,
        (x, y): BackendCoord,
        radius: u32,
        style: &S,
        fill: bool,
    ) -> Drawn {
        let radius = (f64::from(radius) * self.scale) as f32;
        let path = PathBuilder::from_circle(self.pixel(x), self.pixel(y), radius);
        if fill {
            self.fill(path, style.color(), true);
        } else if let Some(path) = path {
            let stroke = Stroke {
                width: (f64::from(style.stroke_width()) * self.scale) as f32,
                ..Stroke::default()
            };
            let (paint, transform) = (paint(style.color(), true), Transform::identity());
            self.pixels
                .stroke_path(&path, &paint, &stroke, transform, None);
        }
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        points: I,
        style: &S,
    ) -> Drawn {
        let points: Vec<_> = points.into_iter().collect();
        let path = self.outline(&points, true);
        self.fill(path, style.color(), true);
        Ok(())
    }

    fn blit_bitmap(&mut self, (x, y): BackendCoord, (w, h): (u32, u32), bytes: &[u8]) -> Drawn {
        let [left, top] = [x, y].map(|v| self.pixel(v).round() as i32);
        let (width, height) = (self.pixels.width() as i32, self.pixels.height() as i32);
        let (colours, _) = bytes.as_chunks::<3>();
        let places = (0..h as i32).flat_map(|j| (0..w as i32).map(move |i| (left + i, top + j)));
        for ((i, j), [r, g, b]) in places.zip(colours) {
            if (0..width).contains(&i) && (0..height).contains(&j) {
                let at = 4 * (j * width + i) as usize;
                self.pixels.data_mut()[at..at + 4].copy_from_slice(&[*r, *g, *b, 255]);
            }
        }
        Ok(())
    }

    fn draw_text<S: BackendTextStyle>(&mut self, text: &str, style: &S, at: BackendCoord) -> Drawn {
        let size = style.size() * self.scale;
        let mut pen = ToPixels {
            path: PathBuilder::new(),
            origin: [f64::from(at.0) * self.scale, f64::from(at.1) * self.scale],
            along: 0.0,
            scale: 1.0,
            upwards: matches!(style.transform(), FontTransform::Rotate270),
        };
        for (glyph, x) in font::set(text, matches!(style.style(), FontStyle::Italic)).0 {
            pen.along = x * size;
            pen.scale = size / glyph.per_em();
            glyph.outline(&mut pen);
        }
        self.fill(pen.path.finish(), style.color(), true);
        Ok(())
    }
}
