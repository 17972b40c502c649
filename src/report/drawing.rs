//! A figure on the page: SVG if it is small, else PNG.

use super::text::{escape, printable};
use crate::figures::base64;
use crate::figures::sheet::Sheet;
use crate::figures::{self, FigureData};
use slipgap_drawing::style;
use slipgap_study::Figure;
use slipgap_study::error::Error;
use std::io::{self, Write};

/// Largest SVG in bytes; a figure with tens of thousands of points is larger.
const MOST_BYTES: usize = 2 << 20;

/// A drawn figure.
#[derive(Debug)]
pub struct Drawing {
    caption: String,
    /// Alternative text.
    description: String,
    picture: Picture,
}

#[derive(Debug)]
enum Picture {
    /// With the values of points under the pointer.
    Svg(String),
    Png(Vec<u8>),
}

impl Drawing {
    /// Draws a figure. `prefix` distinguishes its identifiers from those of other figures.
    ///
    /// # Errors
    /// Those of drawing.
    pub fn new(data: &FigureData, prefix: &str) -> Result<Drawing, Error> {
        let sheet = figures::sheet(data);
        let svg = figures::svg(&sheet, style::DPI)?;
        let picture = if svg.len() <= MOST_BYTES {
            let svg = figures::with_hover(data, &sheet, &svg, prefix);
            Picture::Svg(svg)
        } else {
            Picture::Png(figures::png(&sheet, style::DPI)?)
        };
        Ok(Drawing::with_texts(data.figure, &sheet, picture))
    }

    fn with_texts(figure: &Figure, sheet: &Sheet, picture: Picture) -> Drawing {
        let caption = match figure.title {
            Some(_) => sheet.title.clone(),
            None => figure.name.clone(),
        };
        Drawing {
            caption,
            description: format!("{}: {}", sheet.title, sheet.description),
            picture,
        }
    }

    /// Writes the figure.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        let caption = escape(&self.caption);
        match &self.picture {
            Picture::Svg(svg) => write!(
                out,
                "<figure>\n{}<figcaption>{caption}</figcaption>\n</figure>\n",
                printable(svg)
            ),
            Picture::Png(png) => write!(
                out,
                "<figure>\n<img alt=\"{}\" src=\"data:image/png;base64,{}\">\
                 <figcaption>{caption} (too many points to show their values)</figcaption>\n</figure>\n",
                escape(&self.description),
                base64::text(png)
            ),
        }
    }
}
