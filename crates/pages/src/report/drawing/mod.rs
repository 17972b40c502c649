//! A figure on the page: SVG if it is small, else PNG.

pub(super) mod caption;
pub(super) mod compact;
pub(super) mod glyphs;

use super::packed;
use super::text::{escape, printable};
use glyphs::Glyphs;
use slipgap_drawing::style;
use slipgap_figures::FigureData;
use slipgap_figures::base64;
use slipgap_figures::sheet::Sheet;
use slipgap_study::error::Error;
use std::io::{self, Write};

/// Largest SVG in bytes; a figure with tens of thousands of points is larger.
const MOST_BYTES: usize = 2 << 20;

/// Pixels an inch of images inside SVG: those of a plain screen, because an image of dots takes more bytes than all else.
const IMAGE_DPI: u32 = 96;

/// A drawn figure.
#[derive(Debug)]
pub struct Drawing {
    /// What it shows, in words.
    caption: String,
    /// Alternative text.
    description: String,
    /// Width and height in points.
    size: [f64; 2],
    picture: Picture,
}

#[derive(Debug)]
enum Picture {
    /// With the values of points under the pointer.
    Svg(String),
    Png(Vec<u8>),
}

impl Drawing {
    /// Draws a figure.
    ///
    /// # Errors
    /// Those of drawing.
    pub fn new(data: &FigureData) -> Result<Drawing, Error> {
        let sheet = slipgap_figures::sheet(data);
        let svg = slipgap_figures::svg(&sheet, IMAGE_DPI)?;
        let picture = if svg.len() <= MOST_BYTES {
            Picture::Svg(slipgap_figures::with_hover(
                data,
                &sheet,
                &compact::svg(&svg),
            ))
        } else {
            Picture::Png(slipgap_figures::png(&sheet, style::DPI)?)
        };
        Ok(Drawing::with_texts(data, &sheet, picture))
    }

    fn with_texts(data: &FigureData, sheet: &Sheet, picture: Picture) -> Drawing {
        Drawing {
            caption: caption::of(data, sheet),
            description: format!("{}: {}", sheet.title, sheet.description),
            size: [sheet.width, sheet.height],
            picture,
        }
    }

    /// Takes the outlines of the glyphs out of the drawing, which many figures share.
    pub fn take_glyphs(&mut self, glyphs: &mut Glyphs) {
        if let Picture::Svg(svg) = &mut self.picture {
            *svg = glyphs.take(svg);
        }
    }

    /// Writes the figure.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        let [width, height] = self.size;
        writeln!(
            out,
            "<figure style=\"--width:{width}\">\n<div class=\"drawing\" style=\"aspect-ratio:{width}/{height}\">"
        )?;
        let mut caption = escape(&self.caption);
        match &self.picture {
            Picture::Svg(svg) => packed::write(out, printable(svg).as_bytes())?,
            Picture::Png(png) => {
                writeln!(
                    out,
                    "<img loading=\"lazy\" alt=\"{}\" src=\"data:image/png;base64,{}\">",
                    escape(&self.description),
                    base64::text(png)
                )?;
                caption += " Too many points to show their values.";
            }
        }
        writeln!(out, "</div>\n<figcaption>{caption}</figcaption>\n</figure>")
    }
}
