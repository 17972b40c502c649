//! Dots of cases: a shape each where they are few, one image where they are many.

use super::pen::{Drawn, Pen, at, line, unit};
use super::raster::Raster;
use super::sheet::{Axis, Panel};
use super::style;
use crate::error::Error;
use plotters::element::{Circle, Drawable, PointCollection};
use plotters::style::{Color, RGBColor};
use plotters_backend::{BackendCoord, DrawingBackend, DrawingErrorKind};
use std::cell::RefCell;
use std::rc::Rc;

/// Most dots of a sheet that are a shape each.
pub const MOST_SHAPES: usize = 2000;

/// An image of the dots of a panel.
pub struct Image {
    /// Upper left corner, in points.
    pub place: [f64; 2],
    /// Pixels across and down.
    pub size: (u32, u32),
    /// Red, green and blue of each, row by row.
    pub bytes: Vec<u8>,
}

/// Dots, one a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Cloud {
    /// The dots, drawn in this order.
    pub dots: Vec<Dot>,
    /// Radius of a dot.
    pub radius: f64,
    /// Whether they are one image, because they are many.
    pub image: bool,
}

/// A dot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dot {
    /// Its place in the axes' units.
    pub at: [f64; 2],
    /// Its value on the axis of the colours, if it has one.
    pub value: Option<f64>,
    /// The place of its colour on the scale of colours.
    pub shade: f64,
}

impl Cloud {
    /// The dots of a panel, of `count` on the whole sheet; their values coloured along `colours`.
    pub fn of(
        points: impl Iterator<Item = ([f64; 2], Option<f64>)>,
        colours: Option<&Axis>,
        count: usize,
    ) -> Cloud {
        let dot = |(at, value): ([f64; 2], Option<f64>)| {
            let shade = match (colours, value) {
                (Some(colours), Some(value)) => colours.fraction(value),
                _ => style::DOT_SHADE,
            };
            Dot { at, value, shade }
        };
        // The dots together cover the same area however many there are, until the smallest radius.
        let less = libm::sqrt(MOST_SHAPES as f64 / count.max(1) as f64);
        Cloud {
            dots: points.map(dot).collect(),
            radius: (style::DOT * less).clamp(style::SMALL_DOT, style::DOT),
            image: count > MOST_SHAPES,
        }
    }
}

/// The image of a panel's dots, where they are one.
pub fn image(panel: &Panel, dpi: u32) -> Result<Option<Image>, Error> {
    let Some(cloud) = panel.cloud.as_ref().filter(|cloud| cloud.image) else {
        return Ok(None);
    };
    // Whole pixels round the frame.
    let dots = style::pixels(dpi);
    let frame = &panel.frame;
    let [left, top] = [frame.left, frame.top].map(|x| (x * dots).floor() / dots);
    let [right, bottom] = [frame.right(), frame.bottom()].map(|x| (x * dots).ceil() / dots);
    let raster = Raster::new(right - left, bottom - top, dpi)?;
    let raster = Rc::new(RefCell::new(raster));
    let mut pen = Pen::on(&raster);
    for dot in &cloud.dots {
        let [x, y] = panel.place(dot.at);
        if frame.contains([x, y]) {
            pen.dot([x - left, y - top], cloud.radius, dot.shade, false)
                .map_err(|error| Error::Internal(format!("drawing: {error}")))?;
        }
    }
    let (size, bytes) = raster.borrow().rgb();
    let place = [left, top];
    Ok(Some(Image { place, size, bytes }))
}

impl<B: DrawingBackend> Pen<B> {
    /// The dots that are a shape each.
    pub fn dots(&mut self, panel: &Panel) -> Drawn<B> {
        for cloud in panel.cloud.iter().filter(|cloud| !cloud.image) {
            for dot in &cloud.dots {
                let place = panel.place(dot.at);
                if panel.frame.contains(place) {
                    self.dot(place, cloud.radius, dot.shade, true)?;
                }
            }
        }
        Ok(())
    }

    /// A dot in a colour of maps, with a thin outline if it is `outlined`.
    fn dot(&mut self, place: [f64; 2], radius: f64, shade: f64, outlined: bool) -> Drawn<B> {
        let [r, g, b] = style::colour(shade);
        let (place, radius) = (at(place), unit(radius));
        let filled = RGBColor(r, g, b).filled();
        self.area.draw(&Circle::new(place, radius, filled))?;
        match outlined {
            true => self
                .area
                .draw(&Circle::new(place, radius, line(style::DOT_LINE))),
            false => Ok(()),
        }
    }

    /// An image of dots.
    pub fn image(&mut self, image: &Image) -> Drawn<B> {
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
            Some(place) => backend.blit_bitmap(place, self.image.size, &self.image.bytes),
            None => Ok(()),
        }
    }
}
