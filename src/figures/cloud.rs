//! Dots of cases: a shape each where they are few, one image where they are many.

use super::pen::Pen;
use super::raster::Raster;
use super::sheet::{Axis, Cloud, Dot, Panel};
use super::style::{self, PIXELS};
use crate::error::Error;
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
        // So that ten times as many dots take three times the paper.
        let less = libm::sqrt(MOST_SHAPES as f64 / count.max(1) as f64);
        Cloud {
            dots: points.map(dot).collect(),
            radius: (style::DOT * less).clamp(style::SMALL_DOT, style::DOT),
            image: count > MOST_SHAPES,
        }
    }
}

/// The image of a panel's dots, where they are one.
pub fn image(panel: &Panel) -> Result<Option<Image>, Error> {
    let Some(cloud) = panel.cloud.as_ref().filter(|cloud| cloud.image) else {
        return Ok(None);
    };
    // Whole pixels round the frame.
    let frame = &panel.frame;
    let [left, top] = [frame.left, frame.top].map(|x| (x * PIXELS).floor() / PIXELS);
    let [right, bottom] = [frame.right(), frame.bottom()].map(|x| (x * PIXELS).ceil() / PIXELS);
    let raster = Raster::new(right - left, bottom - top)?;
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
