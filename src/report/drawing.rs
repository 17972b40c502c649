//! A figure on the page: as lines where they are few, as pixels where they are many.

use super::text::{escape, printable};
use crate::error::Error;
use crate::figures::base64;
use crate::figures::sheet::Sheet;
use crate::figures::style;
use crate::figures::{self, DrawnCase};
use crate::study::{Figure, Study};
use std::io::{self, Write};

/// Most bytes of the lines of a figure; tens of thousands of points take more.
const MOST_BYTES: usize = 2 << 20;

/// A figure, drawn.
#[derive(Debug)]
pub struct Drawing {
    caption: String,
    /// What it shows, for readers that cannot see it.
    description: String,
    picture: Picture,
}

#[derive(Debug)]
enum Picture {
    /// SVG with points that say what they are.
    Lines(String),
    /// PNG.
    Pixels(Vec<u8>),
}

impl Drawing {
    /// Draws a figure over its cases; `prefix` keeps its names apart from those of other figures.
    ///
    /// # Errors
    /// Those of drawing.
    pub fn new(
        study: &Study,
        figure: &Figure,
        cases: &[DrawnCase],
        prefix: &str,
    ) -> Result<Drawing, Error> {
        let sheet = figures::sheet(study, figure, cases);
        let svg = figures::svg(&sheet, style::DPI)?;
        let picture = if svg.len() <= MOST_BYTES {
            let svg = figures::with_hover(study, figure, cases, &sheet, &svg, prefix);
            Picture::Lines(svg)
        } else {
            Picture::Pixels(figures::png(&sheet, style::DPI)?)
        };
        Ok(Drawing::of(figure, &sheet, picture))
    }

    fn of(figure: &Figure, sheet: &Sheet, picture: Picture) -> Drawing {
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
            Picture::Lines(svg) => write!(
                out,
                "<figure>\n{}<figcaption>{caption}</figcaption>\n</figure>\n",
                printable(svg)
            ),
            Picture::Pixels(png) => write!(
                out,
                "<figure>\n<img alt=\"{}\" src=\"data:image/png;base64,{}\">\
                 <figcaption>{caption} (too many points to show their values)</figcaption>\n</figure>\n",
                escape(&self.description),
                base64::text(png)
            ),
        }
    }
}
