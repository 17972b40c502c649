//! Draws the dots of cases: a shape each if they are few, one image if they are many.

use super::canvas::{Canvas, DrawResult, at, line, shade, unit};
use super::raster::Raster;
use crate::DrawingError;
use crate::layout::cloud::Dot;
use crate::layout::sheet::Panel;
use crate::style;
use plotters::element::{Circle, Drawable, PointCollection};
use plotters_backend::{BackendCoord, DrawingBackend, DrawingErrorKind};
use std::cell::RefCell;
use std::rc::Rc;

/// An image of the dots of a panel.
pub struct Image {
    /// Upper left corner, in points.
    pub place: [f64; 2],
    /// Pixels across and down.
    pub size: (u32, u32),
    /// Red, green and blue of each, row by row.
    pub bytes: Vec<u8>,
}

/// The image of a panel's dots, if they are one image.
pub fn image(panel: &Panel, dpi: u32) -> Result<Option<Image>, DrawingError> {
    let Some(cloud) = panel.cloud.as_ref().filter(|cloud| cloud.image) else {
        return Ok(None);
    };
    // Whole pixels round the frame.
    let dots = style::pixels(dpi);
    let frame = &panel.frame;
    let [left, top] = [frame.left, frame.top].map(|x| (x * dots).floor() / dots);
    let [right, bottom] = [frame.right(), frame.bottom()].map(|x| (x * dots).ceil() / dots);
    let raster = Rc::new(RefCell::new(Raster::new(right - left, bottom - top, dpi)?));
    let canvas = Canvas::on(&raster);
    for dot in &cloud.dots {
        let [x, y] = panel.place(dot.at);
        if frame.contains([x, y]) {
            let centre = at([x - left, y - top]);
            let circle = Circle::new(centre, unit(cloud.radius), shade(dot.shade));
            canvas
                .area
                .draw(&circle)
                .map_err(|error| DrawingError::Internal(format!("drawing: {error}")))?;
        }
    }
    let (size, bytes) = raster.borrow().rgb();
    let corner = [left, top];
    Ok(Some(Image {
        place: corner,
        size,
        bytes,
    }))
}

impl<B: DrawingBackend> Canvas<B> {
    /// The dots that are a shape each.
    pub fn dots(&mut self, panel: &Panel) -> DrawResult<B> {
        let area = self.in_units_of(panel);
        for cloud in panel.cloud.iter().filter(|cloud| !cloud.image) {
            let radius = unit(cloud.radius);
            let inside = |dot: &&Dot| panel.frame.contains(panel.place(dot.at));
            for dot in cloud.dots.iter().filter(inside) {
                let centre = (dot.at[0], dot.at[1]);
                area.draw(&Circle::new(centre, radius, shade(dot.shade)))?;
                area.draw(&Circle::new(centre, radius, line(style::DOT_LINE)))?;
            }
        }
        Ok(())
    }

    /// An image of dots.
    pub fn image(&mut self, image: &Image) -> DrawResult<B> {
        self.area.draw(&Pixels {
            place: at(image.place),
            image,
        })
    }
}

/// An image as an element of plotters.
struct Pixels<'i> {
    place: BackendCoord,
    image: &'i Image,
}

impl<'a> PointCollection<'a, BackendCoord> for &'a Pixels<'_> {
    type Point = &'a BackendCoord;
    type IntoIter = std::iter::Once<&'a BackendCoord>;

    fn point_iter(self) -> Self::IntoIter {
        std::iter::once(&self.place)
    }
}

impl<B: DrawingBackend> Drawable<B> for Pixels<'_> {
    fn draw<I: Iterator<Item = BackendCoord>>(
        &self,
        mut places: I,
        backend: &mut B,
        _: (u32, u32),
    ) -> Result<(), DrawingErrorKind<B::ErrorType>> {
        match places.next() {
            Some(corner) => backend.blit_bitmap(corner, self.image.size, &self.image.bytes),
            None => Ok(()),
        }
    }
}
