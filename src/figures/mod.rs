//! Figures: a study's cases as sheets of panels, drawn as PNG, SVG and PDF by the same strokes. Draws data, never simulates.
//!
//! A kind of figure (`history`, `profile`, `wave`, `metric`, `convergence`, `budget`, `map`, `scatter`, `samples`,
//! `sobol`, `law`) builds a [`Sheet`], which is plain data; `draw` puts it on paper.

mod arrangement;
mod bands;
pub mod base64;
mod budget;
mod clip;
mod cloud;
mod contours;
mod curves;
mod draw;
mod envelope;
mod font;
mod front;
mod guides;
mod history;
mod hover;
mod label;
mod law;
mod layout;
mod legend;
mod limits;
mod map;
pub mod markup;
mod metric;
mod number;
mod outline;
mod pdf;
mod pen;
mod profile;
mod raster;
mod reference;
mod ridge;
mod samples;
mod scatter;
pub mod sheet;
mod slope;
mod sobol;
pub mod style;
mod tags;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod tests_contents;
#[cfg(test)]
mod tests_extent;
#[cfg(test)]
mod tests_guides;
#[cfg(test)]
mod tests_limits;
#[cfg(test)]
mod tests_samples;
mod text;
mod ticks;
mod vector;
mod wave;

pub use front::Front;
pub use hover::with_hover;

use crate::error::Error;
use crate::problem::{Case, Snapshot, Solution};
use crate::study::{Figure, FigureKind, Study};
use sheet::Sheet;
use std::cell::RefCell;
use std::rc::Rc;

/// A case as figures see it.
#[derive(Debug, Clone, Copy)]
pub struct Shown<'a> {
    /// Its parameters.
    pub case: &'a Case,
    /// Its metrics, in the order of the study's measures; `None` where one is undefined.
    pub metrics: &'a [Option<f64>],
    /// What was computed, for kinds that draw histories; `None` if the case could not be solved.
    pub solution: Option<&'a Solution>,
    /// What stands along the structure at the figure's times, rising with them; none for kinds that do not draw it.
    pub snapshots: &'a [Snapshot],
}

/// The sheet of `figure` over the cases that its filter chose.
pub fn sheet(study: &Study, figure: &Figure, cases: &[Shown]) -> Sheet {
    let mut sheet = match &figure.kind {
        FigureKind::History { .. } => history::sheet(study, figure, cases),
        FigureKind::Metric { .. } | FigureKind::Convergence { .. } => {
            metric::sheet(study, figure, cases)
        }
        FigureKind::Budget { .. } => budget::sheet(study, figure, cases),
        FigureKind::Map { .. } => map::sheet(study, figure, cases),
        FigureKind::Scatter { .. } => scatter::sheet(study, figure, cases),
        FigureKind::Samples { .. } => samples::sheet(study, figure, cases),
        FigureKind::Sobol { .. } => sobol::sheet(study, figure, cases),
        FigureKind::Law => law::sheet(study, figure, cases),
        FigureKind::Profile { .. } => profile::sheet(study, figure, cases),
        FigureKind::Wave { .. } => wave::sheet(study, figure, cases),
    };
    sheet.title = match &figure.title {
        Some(title) => markup::plain(title),
        None => study.title.clone(),
    };
    // Curves over time or place. Those over a parameter have a marker on every point.
    if let FigureKind::History { .. } | FigureKind::Profile { .. } = &figure.kind {
        envelope::find(&mut sheet);
    }
    let mut said: Vec<String> = Vec::new();
    for entry in &sheet.legend {
        let label = markup::plain(&entry.label);
        match said.last_mut() {
            Some(before) if entry.continues() => *before += &format!(" {label}"),
            _ => said.push(label),
        }
    }
    let bands = envelope::any(&sheet).then_some(envelope::MEANING);
    let notes = bands.into_iter().chain(figure.note.as_deref());
    said.extend(notes.map(markup::plain));
    sheet.description = said.join("; ");
    if let Some(note) = &figure.note {
        layout::small_print(&mut sheet, note);
    }
    sheet
}

/// The sheet as a PNG file of `dpi` pixels an inch; fails only on a sheet with too many of them.
pub fn png(sheet: &Sheet, dpi: u32) -> Result<Vec<u8>, Error> {
    let raster = raster::Raster::new(sheet.width, sheet.height, dpi)?;
    let raster = Rc::new(RefCell::new(raster));
    draw::draw(sheet, &raster, dpi)?;
    raster.borrow().png()
}

/// The sheet as the text of an SVG file, whose images have `dpi` pixels an inch.
pub fn svg(sheet: &Sheet, dpi: u32) -> Result<String, Error> {
    let (title, description) = (&sheet.title, &sheet.description);
    let vector = vector::Vector::new(sheet.width, sheet.height, title, description, dpi);
    let vector = Rc::new(RefCell::new(vector));
    draw::draw(sheet, &vector, dpi)?;
    Ok(vector.borrow_mut().svg())
}

/// The sheet as a PDF file, whose images have `dpi` pixels an inch.
pub fn pdf(sheet: &Sheet, dpi: u32) -> Result<Vec<u8>, Error> {
    let dots = style::pixels(dpi);
    let page = pdf::Page::new(sheet.width, sheet.height, &sheet.title, dots);
    let page = Rc::new(RefCell::new(page));
    draw::draw(sheet, &page, dpi)?;
    page.borrow_mut().pdf()
}
