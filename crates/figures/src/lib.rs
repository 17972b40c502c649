//! Figures: a study's cases as sheets of panels, drawn as PNG, SVG and PDF in the same way. They compute no results but
//! those over groups of cases ([`groups`]), which tables have, too.
//!
//! A `kind` makes a [`Sheet`] of the cases, which is plain data; `layout` has its panels, axes
//! and legends, `colour_map` the parts of maps; `draw` draws the sheet; `text` sets its text.

mod column;
mod front;
pub mod groups;
mod hover;
mod kind;
mod label;
mod measured_motion;
mod misfit;
mod shown;
#[cfg(test)]
mod tests;
mod words;

pub use front::Front;
pub use groups::GroupResults;
pub use hover::with_hover;
pub use kind::scheme;
pub use measured_motion::{MeasuredMotion, MeasuredPanel};
pub use misfit::{AlternativeMisfit, MisfitPanel, Misfits};
pub use shown::{DrawnCase, Needed, ShownCases};
pub use slipgap_drawing::draw::base64;
pub use slipgap_drawing::layout::sheet;
pub use slipgap_drawing::style;
pub use slipgap_drawing::text::markup;

use sheet::Sheet;
use slipgap_drawing::DrawingError;
use slipgap_drawing::layout::{self, coincide, envelope};
use slipgap_drawing::style::Look;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_study::error::Error;
use slipgap_study::kinds::Fit;
use slipgap_study::{Block, Figure, Study};
use std::collections::BTreeSet;

/// What a figure draws.
#[derive(Debug, Clone, Copy)]
pub struct FigureData<'a> {
    /// The study.
    pub study: &'a Study,
    /// The figure.
    pub figure: &'a Figure,
    /// The cases that its filter chose.
    pub cases: &'a [DrawnCase<'a>],
    /// The results over groups of these cases.
    pub groups: &'a GroupResults<'a>,
    /// Whether all curves are black, as for print.
    pub black: bool,
    /// Pixels an inch, which decide what is too dense to draw.
    pub dpi: u32,
}

impl FigureData<'_> {
    /// How the curves are told apart.
    pub fn look(&self) -> Look {
        Look {
            colour: self.figure.colour && !self.black,
            markers: self.figure.markers,
        }
    }
}

/// See [`slipgap_drawing::png`].
pub fn png(sheet: &Sheet, dpi: u32) -> Result<Vec<u8>, Error> {
    slipgap_drawing::png(sheet, dpi).map_err(error)
}

/// See [`slipgap_drawing::svg`].
pub fn svg(sheet: &Sheet, dpi: u32) -> Result<String, Error> {
    slipgap_drawing::svg(sheet, dpi).map_err(error)
}

/// See [`slipgap_drawing::pdf`].
pub fn pdf(sheet: &Sheet, dpi: u32) -> Result<Vec<u8>, Error> {
    slipgap_drawing::pdf(sheet, dpi).map_err(error)
}

fn error(error: DrawingError) -> Error {
    match error {
        DrawingError::TooLarge(message) => Error::Usage(message),
        DrawingError::Internal(message) => Error::Internal(message),
    }
}

/// The sheet of a figure.
pub fn sheet(data: &FigureData) -> Sheet {
    let FigureData { study, figure, .. } = *data;
    let kind = kind::of(&figure.kind);
    let mut sheet = kind.sheet(data);
    sheet.title = match &figure.title {
        Some(title) => markup::plain(title),
        None => study.title.clone(),
    };
    if kind.has_dense_curves() {
        envelope::find(&mut sheet, data.dpi);
    }
    let description = Some(std::mem::take(&mut sheet.description));
    let mut parts: Vec<String> = description
        .into_iter()
        .filter(|text| !text.is_empty())
        .collect();
    for entry in &sheet.legend {
        let label = markup::plain(&entry.label);
        match parts.last_mut() {
            Some(before) if entry.continues() => *before += &format!(" {label}"),
            _ => parts.push(label),
        }
    }
    let bands = envelope::meaning(&sheet);
    let over = taken_over(data);
    let meanings = coincide::meaning(&sheet).into_iter().chain(bands);
    let sentences = meanings.chain(over.as_deref());
    let notes = sentences.chain(figure.note.as_deref());
    parts.extend(notes.map(markup::plain));
    sheet.description = parts.join("; ");
    if let Some(over) = &over {
        layout::small_print(&mut sheet, over);
    }
    if let Some(words) = run_away(data) {
        layout::small_print(&mut sheet, &words);
    }
    if let Some(note) = &figure.note {
        layout::small_print(&mut sheet, note);
    }
    sheet
}

/// The remark on a figure with cases that run away; with `collapse` those are counted for what they are.
fn run_away(data: &FigureData) -> Option<String> {
    let fragility = data.figure.kind.fragility();
    let is_counted = fragility.is_some_and(|curve| curve.collapse.is_some());
    let away = data.cases.iter().filter(|shown| shown.has_run_away());
    let (away, count) = (away.count(), data.cases.len());
    let is_cloud = fragility.is_some_and(|curve| curve.fit == Fit::Cloud);
    let of_fit = match is_cloud {
        true => ", and the line goes through them: give collapse",
        false => "",
    };
    (away > 0 && !is_counted).then(|| {
        format!("{away} of {count} cases run away: their peaks grow with the duration{of_fit}.")
    })
}

/// The remark on a figure of reductions, in markup: axis titles are too short for it.
fn taken_over(data: &FigureData) -> Option<String> {
    let study = data.study;
    let rows = data.figure.kind.measures(&*study.problem).into_iter();
    let reduction = { rows }.find_map(|row| study.reduction(row))?;
    let table = study.problem.parameters();
    let operator = reduction.operator.title();
    let of = if operator.ends_with(" of") { "" } else { " of" };
    let over = Vec::from_iter(reduction.over.iter().map(|row| &*table[*row].symbol));
    let count = match reduction.over[..] {
        [row] => number_of_values(data, row),
        _ => None,
    };
    let count = count.map_or_else(|| "all".to_owned(), |count| count.to_string());
    let what = match &over[..] {
        // Each seed has its own motion.
        ["seed"] => format!("{count} motions"),
        // A word has a plural.
        [one] if one.len() > 3 && one.chars().all(|c| c.is_ascii_lowercase()) => {
            format!("{count} {one}s")
        }
        _ => format!("{count} values of {}", over.join(", ")),
    };
    Some(format!("Each value is the {operator}{of} {what}."))
}

/// How many values of a parameter all combinations of the others have; `None` if a condition decides, or blocks differ.
fn number_of_values(data: &FigureData, row: usize) -> Option<usize> {
    let filter = data.figure.filter.0.iter().find(|known| known.0 == row);
    let is_drawn =
        |value: &Value| filter.is_none_or(|known| known.1.iter().any(|x| x.matches(*value)));
    let of_block = |block: &Block| {
        let is_free = block.when.is_none() && block.design.is_none();
        let axis = block.axes().find(|axis| axis.parameter == row)?;
        let values = (0..axis.values.len()).map(|i| axis.values.at(i));
        let count = BTreeSet::from_iter(values.filter(is_drawn).map(Value::identity)).len();
        Some(count).filter(|count| is_free && *count > 1)
    };
    let mut counts = data.study.blocks.iter().map(of_block);
    let first = counts.next()?;
    first.filter(|_| counts.all(|count| count == first))
}
