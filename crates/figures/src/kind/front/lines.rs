//! The lines of a panel of a front: the best points of each value of a parameter.

use super::best::{Point, best};
use crate::DrawnCase;
use crate::label;
use slipgap_drawing::layout::legend::Key;
use slipgap_drawing::layout::sheet::{Panel, Series};
use slipgap_drawing::style::{self, Look};
use slipgap_drawing::text::number::Form;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_study::Study;

/// A line through the best points of one value.
pub struct Line {
    /// Its label, in markup.
    pub label: String,
    /// Its place among the lines, which decides its style.
    index: usize,
    /// How lines are told apart.
    look: Look,
    /// The points, by rising x.
    pub best: Vec<usize>,
}

impl Line {
    /// The curve, with markers that do not hide one another.
    pub fn series(&self, points: &[Point], panel: &Panel) -> Series {
        let points: Vec<[f64; 2]> = self.best.iter().map(|i| points[*i].at).collect();
        let mut marked: Vec<usize> = Vec::new();
        for (i, point) in points.iter().enumerate() {
            let far = |last: &usize| {
                let ([a, b], [c, d]) = (panel.place(*point), panel.place(points[*last]));
                libm::hypot(a - c, b - d) >= 2.5 * style::MARKER
            };
            if marked.last().is_none_or(far) {
                marked.push(i);
            }
        }
        let Key {
            label,
            stroke,
            width,
            marker,
        } = self.key();
        Series {
            label,
            points,
            stroke,
            width,
            marker,
            marked,
        }
    }

    /// The entry of the legend.
    pub fn key(&self) -> Key {
        Key {
            label: self.label.clone(),
            stroke: self.look.stroke(self.index, style::MOST_STYLES),
            width: style::CASE_LINE,
            marker: self.look.marker(self.index),
        }
    }
}

/// A line for each value of a parameter that has points.
pub fn lines(
    study: &Study,
    look: Look,
    cases: &[DrawnCase],
    points: &[Point],
    row: usize,
) -> Vec<Line> {
    let form = label::form(cases, row);
    let values = label::values(cases, row)
        .into_iter()
        .take(style::MOST_STYLES);
    let line = |(index, value): (usize, Option<Value>)| Line {
        label: name(study, row, value, form),
        index,
        look,
        best: best_of(points, |point| label::same(point.shown.value(row), value)),
    };
    let lines = values.enumerate().map(line);
    lines.filter(|line| !line.best.is_empty()).collect()
}

/// The best of the points chosen.
pub fn best_of(points: &[Point], chosen: impl Fn(&Point) -> bool) -> Vec<usize> {
    let indices: Vec<usize> = (0..points.len()).filter(|i| chosen(&points[*i])).collect();
    let places: Vec<[f64; 2]> = indices.iter().map(|i| points[*i].at).collect();
    best(&places).into_iter().map(|k| indices[k]).collect()
}

/// A value of a parameter, in markup.
fn name(study: &Study, row: usize, value: Option<Value>, form: Form) -> String {
    let parameter = &study.problem.parameters()[row];
    match value {
        Some(value) => label::value_label(parameter, value, form),
        None => format!("without {}", parameter.symbol),
    }
}
