//! Draws a sheet with plotters, the same way for PNG, SVG and PDF.

mod axes;
mod bands;
pub mod base64;
mod canvas;
mod colour_map;
mod dots;
mod lettering;
mod panel;
pub mod pdf;
pub mod raster;
pub mod vector;

use crate::DrawingError;
use crate::layout::clip;
use crate::layout::sheet::{Anchor, Entry, PlacedText, Shape, Sheet};
use crate::style;
use canvas::{Canvas, DrawResult};
use dots::Image;
use plotters_backend::DrawingBackend;
use std::cell::RefCell;
use std::rc::Rc;

/// Draws `sheet` on a backend whose size is the sheet's in virtual units; images have `dpi` pixels an inch.
pub fn draw<B: DrawingBackend>(
    sheet: &Sheet,
    backend: &Rc<RefCell<B>>,
    dpi: u32,
) -> Result<(), DrawingError> {
    let drawn = sheet.panels.iter().map(|panel| dots::image(panel, dpi));
    let images: Vec<Option<Image>> = drawn.collect::<Result<_, _>>()?;
    let mut canvas = Canvas::on(backend);
    canvas
        .sheet(sheet, &images)
        .map_err(|error| DrawingError::Internal(format!("drawing: {error}")))
}

impl<B: DrawingBackend> Canvas<B> {
    fn sheet(&mut self, sheet: &Sheet, images: &[Option<Image>]) -> DrawResult<B> {
        for (panel, image) in sheet.panels.iter().zip(images) {
            self.panel(panel, image.as_ref())?;
        }
        for shape in &sheet.picture.shapes {
            self.shape(shape)?;
        }
        for entry in &sheet.legend {
            self.entry(entry)?;
        }
        let words = sheet.picture.words.iter();
        let mut texts = words.chain(&sheet.heading).chain(&sheet.small_print);
        texts.try_for_each(|text| self.placed_text(text))
    }

    fn shape(&mut self, shape: &Shape) -> DrawResult<B> {
        match shape {
            Shape::Line(points, width) => self.path(points, *width),
            Shape::Box(rect, grey) => self.box_of(rect, *grey),
            Shape::Arrow([from, to]) => {
                self.path(&[*from, *to], style::EXACT_LINE)?;
                self.head(*to, *from)
            }
            Shape::DoubleArrow([a, b]) => self.arrow(*a, *b),
        }
    }

    fn placed_text(&mut self, text: &PlacedText) -> DrawResult<B> {
        self.text(&text.text, text.size, text.at, text.anchor, false)
    }

    fn entry(&mut self, entry: &Entry) -> DrawResult<B> {
        let [x, y] = entry.at;
        let sample = [[x, y], [x + style::SAMPLE, y]];
        // Places that are only marked have no line.
        for dash in clip::dashes(&sample, entry.stroke.pattern()) {
            if entry.width > 0.0 {
                self.curve(&dash, entry.width, entry.stroke.colour())?;
            }
        }
        if let Some(marker) = entry.marker {
            self.marker(marker, [x + style::SAMPLE / 2.0, y], entry.stroke.colour())?;
        }
        let at_label = [
            x + style::SAMPLE + style::SAMPLE_GAP,
            y + style::CAP_HEIGHT * style::LABEL / 2.0,
        ];
        self.text(&entry.label, style::LABEL, at_label, Anchor::Start, false)
    }
}
