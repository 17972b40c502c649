//! Sheets of panels as plain data, and their PNG, SVG and PDF. They know no studies.
//!
//! [`layout`] has panels, axes and legends, [`colour_map`] the parts of maps, [`text`] sets text, [`draw`] draws a sheet.
//!
//! plotters gives the drawing area, its elements (rectangle, polygon, path, circle) and the trait of a backend, so that one drawing
//! goes to the three backends here: pixels by tiny-skia, SVG and PDF. Its charts, axes, series and backends are not used, because they
//! have no ticks inwards on all four sides, no sub- and superscripts, no powers of ten and multiples of pi at the ticks, and no legend
//! in a corner that is free. A plotters coordinate is a whole number, so a unit here is 1/64 of a point.

pub mod colour_map;
pub mod draw;
pub mod layout;
pub mod style;
pub mod text;

use draw::pdf::Page;
use draw::{raster, vector};
use layout::sheet::Sheet;
use std::cell::RefCell;
use std::rc::Rc;

/// The sheet as a PNG file of `dpi` pixels an inch; an error if the sheet has too many of them.
pub fn png(sheet: &Sheet, dpi: u32) -> Result<Vec<u8>, DrawingError> {
    let blank = raster::Raster::new(sheet.width, sheet.height, dpi)?;
    let raster = Rc::new(RefCell::new(blank));
    draw::draw(sheet, &raster, dpi)?;
    raster.borrow().png()
}

/// The sheet as the text of an SVG file, whose images have `dpi` pixels an inch.
pub fn svg(sheet: &Sheet, dpi: u32) -> Result<String, DrawingError> {
    let (title, description) = (&sheet.title, &sheet.description);
    let blank = vector::Vector::new(sheet.width, sheet.height, title, description, dpi);
    let vector = Rc::new(RefCell::new(blank));
    draw::draw(sheet, &vector, dpi)?;
    Ok(vector.borrow_mut().svg())
}

/// The sheet as a PDF file, whose images have `dpi` pixels an inch.
pub fn pdf(sheet: &Sheet, dpi: u32) -> Result<Vec<u8>, DrawingError> {
    let dots = style::pixels(dpi);
    let blank = Page::new(sheet.width, sheet.height, &sheet.title, dots);
    let page = Rc::new(RefCell::new(blank));
    draw::draw(sheet, &page, dpi)?;
    page.borrow_mut().pdf()
}

/// Why a sheet could not be drawn.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum DrawingError {
    /// The picture would have too many pixels.
    TooLarge(String),
    /// An error of this program.
    Internal(String),
}

impl std::fmt::Display for DrawingError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            DrawingError::TooLarge(message) | DrawingError::Internal(message) => {
                f.write_str(message)
            }
        }
    }
}

impl std::error::Error for DrawingError {}
